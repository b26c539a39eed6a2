#!/usr/bin/env python3
"""pages.py SOURCE: writes into SOURCE, a copy of the repository, the pages of the site that are no
documents of it: the first page with all tables of contents, a page for each lesson and for each
public header, the page that holds the live pages."""

import re
import sys
from pathlib import Path

source = Path(sys.argv[1])
documented: dict[str, str] = {}  # Headers that public ones consist of, with the page that has them.


def write(name: str, text: str) -> str:
    page = source / f"{name}.md"
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(text)
    return name


def contents(caption: str, entries: list[str]) -> str:
    return "\n".join(["```{toctree}", f":caption: {caption}", ":hidden:", "", *entries, "```", ""])


def found(pattern: str) -> list[str]:
    """Documents in the order of their names."""
    return sorted(str(page.relative_to(source).with_suffix("")) for page in source.glob(pattern))


def linked(page: str) -> list[str]:
    """Documents that a page links to, in its order, each once."""
    folder = (source / page).parent
    names = re.findall(r"\]\(([^)#:]+)\.md\)", (source / page).read_text())
    paths = [(folder / name).resolve().relative_to(source.resolve()) for name in names]
    return list(dict.fromkeys(str(path) for path in paths))


def lesson(case: Path) -> str:
    number, name = case.stem.split("_", 1)
    return write(
        f"lessons/{case.stem}",
        f"# {number}: {name.replace('_', ' ')}\n\n"
        f"```{{literalinclude}} ../configs/{case.name}\n:language: yaml\n```\n",
    )


def header(file: Path) -> str:
    """What a public header declares: the internal headers that it is made of."""
    own = file.relative_to(source / "include")
    text = file.read_text()
    said = " ".join(
        line.removeprefix("// ") for line in text.splitlines() if line.startswith("// ")
    )
    parts = re.findall(r'#include "([^"]+)"', text)
    page = str(own.with_suffix("")).replace("/", "_")
    body = ""
    for part in parts:
        place = documented.setdefault(part, page)
        told = (
            f"```{{doxygenfile}} {Path(part).name}\n```"
            if place == page
            else f"See [{place}]({place}.md)."
        )
        body += f"## {part}\n\n{told}\n\n"
    return write(f"cpp/{page}", f"# {own}\n\n{said}\n\n{body}")


OTHERS = (
    r"README|CONTRIBUTING|validation|reference|"
    r"/(designers|researchers|contributors|commands|lessons|gallery|install|output)$|"
    r"/(workbench|report|engine|new_case|models|glossary|tutorial_catalogue|tutorial_reference)$"
)

lessons = [lesson(case) for case in sorted((source / "configs").glob("[0-9]*.yaml"))]
# The first page has a part that public headers share.
public = sorted((source / "include/prs").rglob("*.h"))
public.sort(key=lambda header: header.stem not in ("case", "solve", "result"))
headers = [header(file) for file in public]
models = [page for page in linked("docs/README.md") if not re.search(OTHERS, page)]
notebooks = sorted(
    str(page.relative_to(source).with_suffix(""))
    for page in source.glob("python/notebooks/*.ipynb")
)

(source / "build").mkdir()
(source / "build/doxygen_input").write_text(f"INPUT = {' '.join(sorted(documented))}\n")
write(
    "cpp/index",
    "# C++\n\n`find_package(prs)` gives these headers: [install.md](../docs/install.md).\n\n"
    + "```{toctree}\n:maxdepth: 1\n\n"
    + "\n".join(f"/{page}" for page in headers)
    + "\n```\n",
)
write(
    "live",
    """# Live pages

A report as `prs report` writes it: its sliders recompute the case in your browser. Alone:
<a href="report.html">the report</a>; <a href="workbench.html">the workbench</a> is the program
itself as one page, without an install ([workbench.md](docs/workbench.md)).

<iframe class="live" src="report.html" title="A live report"></iframe>
""",
)
for page in (source / "docs").glob("*.md"):  # The README is the first page.
    page.write_text(page.read_text().replace("](../README.md", "](../index.md"))
write(
    "index",
    "\n".join(
        [
            (source / "README.md").read_text(),
            contents(
                "First pages", ["docs/designers", "docs/researchers", "docs/contributors", "live"]
            ),
            contents(
                "Use",
                [
                    "docs/install",
                    "docs/tutorial_catalogue",
                    "docs/tutorial_reference",
                    "docs/models",
                    "docs/new_case",
                    "docs/commands",
                    "docs/output",
                    "docs/report",
                    "docs/workbench",
                    "docs/lessons",
                    "docs/gallery",
                    "docs/glossary",
                ],
            ),
            contents("Lessons", lessons),
            contents("Models", ["docs/README", *models]),
            contents(
                "Truth",
                [
                    "docs/validation/README",
                    *found("docs/validation/[a-z]*.md"),
                    *found("validation/*/SOURCE.md"),
                    "benchmark/README",
                    "benchmark/RESULTS",
                    *found("benchmark/[0-9]*/*.md"),
                ],
            ),
            contents(
                "Reference",
                [
                    "docs/reference/README",
                    *found("docs/reference/[a-z]*.md"),
                    "cpp/index",
                    "python/README",
                    "autoapi/rollerscrew/index",
                    "python/examples/README",
                    "python/notebooks/README",
                    *notebooks,
                ],
            ),
            contents("Work on it", ["docs/CONTRIBUTING", "docs/engine", "CHANGELOG", "SECURITY"]),
        ]
    ),
)
