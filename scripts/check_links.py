#!/usr/bin/env python3
"""check_links.py: links of Markdown files that lead nowhere, to files and to headings of them.
check_links.py FOLDER: the same of the HTML files of a site."""

import html
import re
import subprocess
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).resolve().parent.parent


class Page(HTMLParser):
    """Where a page leads, and what it can be entered at."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.anchors: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            if value and (name == "id" or (name == "name" and tag == "a")):
                self.anchors.add(value)
            elif value and name in ("href", "src"):
                self.links.append(value)


class Markdown:
    """The same of a Markdown file; anchors of headings as forges make them."""

    def __init__(self, text: str) -> None:
        text = re.sub(r"^( *)(```|~~~).*?^ *\2`*$", "", text, flags=re.M | re.S)
        self.anchors = set(re.findall(r'<a id="([^"]+)"', text))
        for heading in re.findall(r"^#+ +(.*?) *$", text, flags=re.M):
            plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
            self.anchors.add(re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-"))
        text = re.sub(r"`[^`\n]*`", "", text)
        self.links = re.findall(r"\]\(([^)\s]+)\)", text)


def lost(pages: dict[Path, Page | Markdown]) -> Iterator[str]:
    for place, page in pages.items():
        for link in page.links:
            parts = urlsplit(html.unescape(link))
            if parts.scheme or parts.netloc or link.startswith("//"):
                continue
            target = (place.parent / unquote(parts.path)).resolve() if parts.path else place
            if not target.exists():
                yield f"{place}: {link}: no such file"
            elif (
                parts.fragment
                and target in pages
                and unquote(parts.fragment) not in pages[target].anchors
            ):
                yield f"{place}: {link}: no such heading"


def main() -> int:
    if len(sys.argv) > 1:
        files = sorted(Path(sys.argv[1]).resolve().rglob("*.html"))
        if not files:
            sys.exit(f"check_links: {sys.argv[1]}: no HTML files; name the folder of a built site")
        pages: dict[Path, Page | Markdown] = {file: Page(file.read_text()) for file in files}
    else:
        listed = subprocess.run(
            ["git", "ls-files", "*.md"], cwd=ROOT, capture_output=True, text=True, check=True
        )
        pages = {ROOT / name: Markdown((ROOT / name).read_text()) for name in listed.stdout.split()}
    found = list(lost(pages))
    print(*found, sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
