#!/usr/bin/env python3
"""Finds lines of Markdown longer than 120 characters; with --write, wraps the paragraphs that have
them. Tables, code, and words without blanks (links) stay as they are; they may have 180."""

import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WIDTH = 120
ROW = 180  # of a table, or code
ITEM = re.compile(r"( *)([-*+]|\d+\.) +")
# At the start of a line these would begin a list, a title, a quotation or a table.
MARK = re.compile(r"([-+*=|>#]+|\d+[.)])$")


def is_text(line: str) -> bool:
    return bool(line.strip()) and not re.match(r"#|\||<|!\[", line.lstrip())


def words(text: str) -> Iterator[str]:
    """Words, where a code span is one and a mark belongs to the word before it."""
    waiting = ""
    for word in re.findall(r"(?:`[^`]*`|[^\s`]|`)+", text):
        if waiting and not MARK.match(word):
            yield waiting
            waiting = word
        else:
            waiting = f"{waiting} {word}".strip()
    if waiting:
        yield waiting


def wrapped(lines: list[str]) -> Iterator[str]:
    item = ITEM.match(lines[0])
    first = item[0] if item else lines[0][: len(lines[0]) - len(lines[0].lstrip())]
    line, indent = first, " " * len(first)
    text = " ".join(lines)[len(first) :]
    for word in words(text):
        if len(line) + len(word) > WIDTH and line.strip() and line != first:
            yield line.rstrip()
            line = indent
        line += word + " "
    yield line.rstrip()


def paragraphs(lines: list[str]) -> Iterator[tuple[bool, list[str]]]:
    """Paragraphs and items of lists, which are text; anything else line by line."""
    fenced, after_blank, indented, inside = False, True, False, []
    for line in lines:
        # A list in an indented block, as YAML has them, is code; a nested list is not.
        if line.strip():
            started = indented or not ITEM.match(line)
            indented = after_blank and line.startswith("    ") and started
        if line.lstrip().startswith("```"):
            fenced = not fenced
        code = fenced or line.lstrip().startswith("```") or (indented and not inside)
        if inside and (code or not is_text(line) or ITEM.match(line)):
            yield True, inside
            inside = []
        if code or not is_text(line):
            yield False, [line]
        else:
            inside.append(line)
        after_blank = not line.strip() or (code and after_blank)
    if inside:
        yield True, inside


def is_long(line: str) -> bool:
    return len(line) > WIDTH and " " in line.strip()


def wrap(text: str) -> str:
    """The text, with paragraphs that have long lines wrapped."""
    result: list[str] = []
    for is_paragraph, lines in paragraphs(text.splitlines()):
        result += wrapped(lines) if is_paragraph and any(map(is_long, lines)) else lines
    return "\n".join(result) + "\n"


def main() -> int:
    listed = subprocess.run(
        ["git", "ls-files", "*.md"], cwd=ROOT, check=True, capture_output=True, text=True
    )
    found = rows = 0
    for name in listed.stdout.split():
        path = ROOT / name
        text = path.read_text()
        result = wrap(text)
        if result.splitlines() != text.splitlines():
            found += 1
            if "--write" in sys.argv:
                path.write_text(result)
            else:
                print(f"{name}: lines of more than {WIDTH} characters", file=sys.stderr)
        for line in filter(lambda line: len(line) > ROW, result.splitlines()):
            rows += 1
            print(f"{name}: more than {ROW} characters: {line[:WIDTH]}", file=sys.stderr)
    if found and "--write" not in sys.argv:
        print("scripts/wrap_markdown.py --write wraps them", file=sys.stderr)
        return 1
    return 1 if rows else 0


if __name__ == "__main__":
    sys.exit(main())
