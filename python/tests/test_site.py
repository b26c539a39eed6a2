"""Links and widths of documents, and what stands on the site of all of them."""

import re
import runpy
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def lost(*arguments: str | Path) -> list[str]:
    run = subprocess.run(
        [sys.executable, ROOT / "scripts/check_links.py", *arguments],
        capture_output=True,
        text=True,
    )
    assert run.returncode == (1 if run.stdout else 0), run.stderr
    return run.stdout.splitlines()


def test_links_of_a_site_that_lead_nowhere_are_found(tmp_path: Path) -> None:
    (tmp_path / "a.html").write_text(
        '<h1 id="top"></h1><a href="b.html#here">b</a> <a href="https://example.org">c</a>'
    )
    (tmp_path / "b.html").write_text(
        '<h1 id="here"></h1><a href="a.html">a</a><a href="#here"></a>'
    )
    assert lost(tmp_path) == []
    (tmp_path / "b.html").write_text(
        '<a href="c.html"></a><a href="a.html#bottom"></a><img src="a%20b.png">'
    )
    assert [line.split(": ", 1)[1] for line in lost(tmp_path)] == [
        "b.html#here: no such heading",
        "c.html: no such file",
        "a.html#bottom: no such heading",
        "a%20b.png: no such file",
    ]


def test_long_lines_are_wrapped_in_text_only() -> None:
    wrap = runpy.run_path(str(ROOT / "scripts/wrap_markdown.py"))["wrap"]
    words = "word " * 30
    code = f"```yaml\nload: 1 kN  # {words}\n```\n\n    list:\n      - {words}\n\n| {words}|\n"
    assert wrap(code) == code
    assert wrap(f"- {words}\n") == f"- {'word ' * 22}word\n  {'word ' * 6}word\n"


def test_long_rows_only_start_in_a_table(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(ROOT / "scripts")
    table = runpy.run_path(str(ROOT / "scripts/reference.py"))["table"]
    said = "Force (of a pair; both) over `a; b`; " + "word " * 40
    first = table(("key", "unit", "what"), [("`f`", "N", said), ("`g`", "N", "Short; whole")])
    assert first.splitlines()[2:] == [
        "| `f` | N | Force (of a pair; both) over `a; b` .. |",
        "| `g` | N | Short; whole |",
        "",
        f"- `f`: {said}",
    ]
    with pytest.raises(ValueError, match="no clauses"):
        table(("key", "what"), [("`f`", "word " * 40)])


def test_every_document_is_on_the_site(tmp_path: Path) -> None:
    listed = subprocess.run(
        [
            "git",
            *("-c", "safe.directory=*"),  # Whoever owns the clone.
            "ls-files",
            "README.md",
            "docs/*.md",
            "benchmark/*.md",
            "validation/*.md",
            "configs/*.yaml",
            "python/*.md",
            "python/notebooks",
            "include",
            "scripts",
        ],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    for name in listed.stdout.split():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_bytes((ROOT / name).read_bytes())
    subprocess.run([sys.executable, ROOT / "docs/site/pages.py", tmp_path], check=True)
    index = (tmp_path / "index.md").read_text()
    entries = set(
        re.findall(
            r"^(\S+)$", "\n".join(re.findall(r"```\{toctree\}\n(.*?)```", index, re.S)), re.M
        )
    )
    documents = {
        str(page.relative_to(tmp_path).with_suffix(""))
        for pattern in ("docs/**/*.md", "benchmark/*/*.md", "lessons/*.md")
        for page in tmp_path.glob(pattern)
    }
    assert documents <= entries, documents - entries
