"""`docs/validation/`: each model has a record with what the form demands, and words for tests."""

from __future__ import annotations

import re
import sys
from importlib import import_module

import pytest
import yaml
from conftest import REPOSITORY

sys.path.insert(0, str(REPOSITORY / "scripts"))
records = import_module("validation_records")

FORMS = sorted((REPOSITORY / "docs" / "validation" / "forms").glob("*.yaml"))
SECTIONS = [
    "Purpose",
    "Equations",
    "Range",
    "Reference examples",
    "Tests",
    "Deviations",
    "Limits of use",
]


@pytest.mark.parametrize("path", FORMS, ids=lambda path: str(path.stem))
def test_record_has_what_the_form_demands(path) -> None:  # type: ignore[no-untyped-def]
    form = yaml.safe_load(path.read_text())
    assert set(form) == {"title", "purpose", "page", "equations", "range", "limits", "examples"}
    assert (REPOSITORY / "docs" / form["page"].split("#")[0]).is_file()
    text = (path.parent.parent / f"{path.stem}.md").read_text()
    assert re.findall(r"^## (.*)$", text, re.MULTILINE) == SECTIONS
    assert re.search(
        r"^Computed on \d{4}-\d\d-\d\d with `prs` \S+, commit [0-9a-f]{7,}\.$", text, re.MULTILINE
    )
    for limit in form["limits"]:
        assert " ".join(limit.split()) in " ".join(text.split())
    assert f"({path.stem}.md)" in (path.parent.parent / "README.md").read_text()


def test_links_lead_somewhere() -> None:
    for page in (REPOSITORY / "docs" / "validation").glob("*.md"):
        for link in re.findall(r"\]\(([^)#]+)", page.read_text()):
            assert (page.parent / link).exists(), f"{page.name}: {link}"


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("ThreadLoadsSumToAppliedLoad", "thread loads sum to applied load"),
        ("AThinRingBends", "a thin ring bends"),
        ("SharesEquallyAt45kN", "shares equally at 45kN"),
        ("ReproducesAWorkedExample", "reproduces a worked example"),
    ],
)
def test_name_of_a_test_in_words(name: str, words: str) -> None:
    assert records.in_words(name) == words


def test_digits_are_those_that_agree() -> None:
    row = {"value": "2.0", "uncertainty": "1e-3"}
    assert records.digits_of(row, 2.0) == records.MOST_DIGITS
    assert records.digits_of(row, 2.0003) == 3
    assert records.digits_of(row, 3.0) == 0


def test_record_without_its_date_is_compared() -> None:
    one = "a\n\nComputed on 2026-01-01 with `prs` 1, commit 0000000000.\n"
    other = "a\n\nComputed on 2027-02-02 with `prs` 2, commit 1111111111.\n"
    assert records.without_mark(one) == records.without_mark(other)
    assert records.without_mark(one) != records.without_mark(one.replace("a", "b"))


def test_tolerance_is_the_loosest_that_is_compared_with() -> None:
    body = """{
  const double step = 1e-4;
  EXPECT_NEAR(a, max(b, 3e-6), 1e-12 * scale) << "at " << i;
  EXPECT_LT(std::abs(c - d), 3e-10);
  EXPECT_GT(e, 1e-5);
}"""
    assert records.tolerance(body) == " [3e-10]"
    assert records.tolerance("EXPECT_EQ(a, 1e-5);") == ""
