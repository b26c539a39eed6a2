#!/usr/bin/env python3
"""Writes docs/reference/ and Python's records from what `prs schema` says of inputs and results.

    scripts/reference.py PRS            writes the files
    scripts/reference.py PRS --check    says which of them are not current
"""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGES = ROOT / "docs/reference"
NOTE = "<!-- Written by scripts/reference.py from the program's own tables. -->\n\n"
KINDS = {
    "number": "float", "series": "Array", "matrix": "Array", "count": "int", "flag": "bool",
    "text": "str", "texts": "list[str]",
}  # fmt: skip


def cell(text: str) -> str:
    return text.replace("|", "\\|")


def table(head: tuple[str, ...], rows: list[tuple[str, ...]]) -> str:
    lines = [head, ("---",) * len(head), *rows]
    return "".join("| " + " | ".join(map(cell, line)) + " |\n" for line in lines)


def said_of(q: dict) -> str:
    """Title, formula or sentence, validity and source, as far as they are told."""
    parts = [] if q["key"].startswith(q["title"].replace(" ", "_")) else [q["title"]]
    parts += [q[name] for name in ("meaning", "validity") if name in q]
    if "source" in q:
        parts.append(f"*{q['source']}*")
    return "; ".join(parts)


def shape(q: dict) -> str:
    if "record" in q:
        link = f"[{q['record']}](#{q['record'].lower()})"
        return link if q["kind"] == "record" else f"list of {link}"
    return q["kind"]


def records_in(name: str, records: dict, found: list[str]) -> list[str]:
    if name not in found:
        found.append(name)
        for q in records[name]["quantities"]:
            if "record" in q:
                records_in(q["record"], records, found)
    return found


def result_pages(schema: dict) -> dict[str, str]:
    pages: dict[str, str] = {}
    for place in schema["documents"]:
        path, records = place["path"], schema["records"]
        name = path.replace("[]", "").replace(".", "_")
        text = f"# `{path}`\n\n"
        for record in records_in(place["record"], records, []):
            rows = [
                (f"`{q['key']}`", q.get("unit", ""), shape(q), said_of(q))
                for q in records[record]["quantities"]
            ]
            text += f"## {record}\n{records[record]['meaning']}\n\n"
            text += table(("key", "unit", "shape", "what it is"), rows) + "\n"
        pages[f"{name}.md"] = NOTE + text.rstrip() + "\n"
    return pages


def inputs_in(properties: dict, before: str = "") -> list[tuple[str, ...]]:
    rows = []
    for name, value in properties.items():
        path = before + name
        items = value.get("items", {})
        default = json.dumps(value["default"]) if "default" in value else ""
        rows.append((f"`{path}`", default, value.get("description", "")))
        rows += inputs_in(value.get("properties", {}), path + ".")
        rows += inputs_in(items.get("properties", {}), path + "[].")
    return rows


def reference(results: dict, inputs: dict) -> dict[Path, str]:
    pages = result_pages(results)
    rows = inputs_in(inputs["properties"])
    pages["inputs.md"] = NOTE + "# Inputs\n\n" + table(("path", "default", "what it is"), rows)
    links = "".join(
        f"- [`{place['path']}`]({name})\n"
        for place, name in zip(results["documents"], result_pages(results), strict=True)
    )
    pages["README.md"] = (
        f"{NOTE}# Reference\n\nEvery [input](inputs.md) of a case, and every result of `--json`: "
        f"units stand at the end of the keys.\n\n{links}"
    )
    files = {PAGES / name: text for name, text in pages.items()}
    files[ROOT / "python/rollerscrew/records.py"] = python_records(results["records"])
    return files


def python_records(records: dict) -> str:
    text = '''"""What stands inside the result documents; names and units are those of `prs --json`.

A quantity that a case does not define is absent: attribute access raises, `get` gives its default.
What each is: docs/reference. Written by scripts/reference.py from the program's table.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from rollerscrew.record import Record

Array = npt.NDArray[np.float64]  #: Read-only.
'''
    for name, record in records.items():
        text += f'\n\nclass {name}(Record):\n    """{record["meaning"]}"""\n\n    __slots__ = ()\n'
        for q in record["quantities"]:
            kind = KINDS.get(q["kind"], q.get("record", ""))
            text += f"    {q['key']}: {f'list[{kind}]' if q['kind'] == 'records' else kind}\n"
    return text


def main() -> int:
    prs = sys.argv[1]
    results, inputs = (
        json.loads(subprocess.run([prs, "schema", of], check=True, capture_output=True).stdout)
        for of in ("results", "input")
    )
    files = reference(results, inputs)
    stale = [path for path, text in files.items() if not path.exists() or path.read_text() != text]
    stale += [path for path in PAGES.glob("*") if path not in files]
    if "--check" in sys.argv:
        for path in stale:
            print(f"{path.relative_to(ROOT)} is not current; run scripts/reference.py PRS")
        return 1 if stale else 0
    PAGES.mkdir(exist_ok=True)
    for path in stale:
        path.write_text(files[path]) if path in files else path.unlink()
    return 0


if __name__ == "__main__":
    sys.exit(main())
