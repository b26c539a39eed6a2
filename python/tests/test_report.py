"""The page that a case writes."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest
import rollerscrew as rs
from conftest import lesson

VOID = {"meta", "img", "input", "wbr"}


class Page(HTMLParser):
    """Elements that are closed in their order, texts, links and the data."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.names: list[str] = []  # Of the open ones: their id, else what they are.
        self.links: list[str] = []
        self.policy = ""
        self.contents: dict[str, str] = {}
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        values = dict(attrs)
        self.links += [values[key] or "" for key in ("href", "src") if key in values]
        if values.get("http-equiv") == "Content-Security-Policy":
            self.policy = values["content"] or ""
        assert not any(key.startswith("on") or key == "style" for key in values)
        if tag not in VOID:
            self.open.append(tag)
            self.names.append(values.get("id") or tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag
        self.names.pop()

    def handle_data(self, data: str) -> None:
        if self.names:
            self.contents[self.names[-1]] = self.contents.get(self.names[-1], "") + data


@pytest.fixture
def page(own_case: rs.Case, tmp_path: Path) -> Page:
    assert own_case.report(tmp_path / "report.html")
    return Page((tmp_path / "report.html").read_text(encoding="utf-8"))


@pytest.fixture
def own_case() -> rs.Case:
    return lesson(9)


def test_asks_for_nothing(page: Page) -> None:
    assert all(link.startswith(("#", "data:")) for link in page.links)
    digest = base64.b64encode(hashlib.sha256(page.contents["style"].encode()).digest()).decode()
    assert page.policy.startswith(f"default-src 'none'; style-src 'sha256-{digest}';")


def test_holds_what_the_case_answers(own_case: rs.Case, page: Page) -> None:
    data = json.loads(page.contents["data"])
    solved = own_case.solve().load_cases[0]
    reported = data["results"]["solve"]["load_cases"][0]
    assert reported["axial_stiffness_N_per_um"] == solved.axial_stiffness_N_per_um
    assert f"{solved.axial_stiffness_N_per_um:.1f}" in page.contents["td"]


def test_what_cannot_be_written_is_an_error(own_case: rs.Case, tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=re.escape("cannot write")):
        own_case.report(tmp_path / "no folder" / "report.html")


def test_explores_in_the_browser(
    own_case: rs.Case, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    own = own_case.solve().explore(tmp_path / "own.html")
    pages = [own, rs.explore(own_case)]
    assert pages[0] == tmp_path / "own.html"
    assert pages[1].parent.parent == tmp_path
    assert opened == [page.as_uri() for page in pages]
    assert own.read_text().startswith("<!DOCTYPE html>")


def test_warns_once_that_a_page_is_static(
    own_case: rs.Case, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PRS_SHARE", str(tmp_path))
    page = tmp_path / "page.html"
    reason = "the engine of live pages is not built"
    with pytest.warns(UserWarning, match=f"the page is static: {reason}") as caught:
        own_case.report(page)
    assert len(caught) == 1
    assert caught[0].filename == __file__
    assert f"This page is static: {reason}" in page.read_text(encoding="utf-8")
    (tmp_path / "web").mkdir()
    (tmp_path / "web" / "source_id").write_text("another")
    with pytest.warns(UserWarning, match="is of other sources than this program"):
        own_case.report(page)
    assert "script-src" not in page.read_text(encoding="utf-8")
