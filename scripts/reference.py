#!/usr/bin/env python3
"""Writes docs/reference/, Python's records and results from `prs schema` and `prs help --json`.

scripts/reference.py PRS            writes the files
scripts/reference.py PRS --check    says which of them are not current
"""

import ast
import itertools
import json
import keyword
import re
import subprocess
import sys
import textwrap
from collections.abc import Iterable, Sequence
from pathlib import Path

from wrap_markdown import ROW, wrap

ROOT = Path(__file__).resolve().parent.parent
PAGES = ROOT / "docs/reference"
PYTHON = ROOT / "python/rollerscrew"
CUT = "Where a cell ends in `..`, the whole text stands below the table."
NOTE = "<!-- Written by scripts/reference.py from the program's own tables. -->\n\n"
KINDS = {
    "number": "float", "series": "Array", "matrix": "Array", "count": "int", "flag": "bool",
    "text": "str", "texts": "list[str]",
}  # fmt: skip


def row_of(cells: Sequence[str]) -> str:
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def start_of(text: str) -> str:
    """Its first sentence; of one sentence the first clause that leaves nothing open."""
    for end in (r"(?<=[\w`)]{2})\. ", "; ", ": ", ", "):
        for found in re.finditer(end, text):
            start = text[: found.start()]
            if start.count("(") == start.count(")") and not start.count("`") % 2:
                return start + " .."
    raise ValueError(f"no clauses, and too long for a row: {text}")


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines, below = [row_of(head), row_of(["---"] * len(head))], ""
    for row in rows:
        # Of a row that is too long the longest cells only start here, and stand whole below.
        cells = list(row)
        while len(row_of(cells)) > ROW:
            longest = max(cells[1:], key=len)
            cells[cells.index(longest)] = start_of(longest)
        if whole := ". ".join(text for text, start in zip(row, cells) if text != start):
            below += f"- {row[0]}: {whole}\n"
        lines.append(row_of(cells))
    return "\n".join(lines) + "\n" + (below and f"\n{below}")


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


def bounds(value: dict) -> str:
    """`> 0 and <= 1` of a number."""
    words = {"exclusiveMinimum": ">", "minimum": ">=", "exclusiveMaximum": "<", "maximum": "<="}
    return " and ".join(f"{words[key]} {value[key]:g}" for key in words if key in value)


def value_of(value: dict, quantities: dict[str, str]) -> str:
    """What may stand there: quantity and bounds, words, or how it is made up."""
    if "pattern" in value and "examples" in value:
        units, _, limits = (value.get("x-value") or value["description"]).partition("; ")
        return f"{quantities[units.removeprefix('In ')]} {limits}".rstrip()
    if "oneOf" in value:
        return " or ".join(dict.fromkeys(value_of(each, quantities) for each in value["oneOf"]))
    if "enum" in value:
        return ", ".join(f"`{word}`" for word in value["enum"])
    kind = value["type"]
    if kind == "integer":
        return f"whole number, {value['minimum']} to {value['maximum']}"
    if kind == "number":
        return f"number {bounds(value)}".rstrip()
    if kind == "object":
        keys = value["properties"]
        return f"`{{{', '.join(keys)}}}`" if len(keys) < 5 else "map"
    if kind == "array":
        return "list: " + value_of(value["items"], quantities)
    words = {"string": "text", "boolean": "`true`, `false`"}
    return words.get(str(kind), "as it would stand there")


def maps_in(value: dict, path: str) -> list[tuple[str, dict]]:
    """The maps that a value may be, or holds, with the path of their keys."""
    if "oneOf" in value:
        return [each for other in value["oneOf"] for each in maps_in(other, path)]
    if value.get("type") == "array":
        return maps_in(value["items"], path + "[]")
    return [(path + ".", value)] if "properties" in value else []


def inputs_in(
    block: dict, before: str, quantities: dict[str, str], rows: dict[str, tuple[str, ...]]
) -> None:
    for name, value in block["properties"].items():
        path = before + name
        default = f"`{value['default']}`".replace("True", "true") if "default" in value else ""
        default = default.replace("False", "false")
        needed = "yes" if name in block.get("required", []) else value.get("x-condition", "")
        meaning = value.get("x-meaning") or value.get("description", "")
        if words := value.get("x-value") if "examples" not in value else None:
            meaning += f". {words}"
        value_text = value_of(value, quantities)
        rows.setdefault(path, (f"`{path}`", value_text, default, needed, meaning))
        for inner, keys in maps_in(value, path):
            inputs_in(keys, inner, quantities, rows)


def quantities_in(units: list[dict]) -> dict[str, str]:
    """What a quantity is called, and either of two, by the units that the schema lists for it."""
    names = {
        ", ".join(alike[0] for alike in q["units"]): q["quantity"].partition(" ")[2] for q in units
    }
    both = itertools.permutations(names, 2)
    return names | {f"{a}, {b}": f"{names[a]} or {names[b]}" for a, b in both}


def unit_table(schema: dict, units: list[dict]) -> str:
    """The units of the quantities that a schema has."""
    said = json.dumps(schema)
    found = {
        name
        for listed, names in quantities_in(units).items()
        if f'"In {listed}"' in said or f'"In {listed}; ' in said
        for name in names.split(" or ")
    }
    named = [(q["quantity"].partition(" ")[2], q) for q in units]
    rows = [
        (name, f"`{q['example']}`", ", ".join(f"`{' = '.join(alike)}`" for alike in q["units"]))
        for name, q in named
        if name in found
    ]
    return table(("quantity", "example", "units"), rows)


def input_page(schema: dict, units: list[dict], title: str, of: str) -> str:
    text = (
        f"# {title}\n\nEvery key of a {of}. `[]` stands for the entries of a list. A path with"
        " the\n"
        "number of an entry, `load_cases[0].axial_force`, is what `--set` and studies take.\n"
        "A length, a force or another quantity is a number with one of its [units](#units).\n"
        "Required: where the block that holds the key stands; what a command needs, `prs check`\n"
        f"says. {CUT}\n\n"
    )
    quantities = quantities_in(units)
    for name, value in schema["properties"].items():
        rows: dict[str, tuple[str, ...]] = {}
        one = {"properties": {name: value}, "required": schema.get("required", [])}
        inputs_in(one, "", quantities, rows)
        head = ("path", "value", "default", "required", "what it is")
        text += f"## {name}\n{table(head, rows.values())}\n"
    return f"{NOTE}{text}## Units\n{unit_table(schema, units)}"


def responses_in(owner: dict, before: str, records: dict) -> list[tuple[str, ...]]:
    """Those of a record, which has the title and the unit of the quantity that it is."""
    rows = []
    for q in records[owner["record"]]["quantities"]:
        path = before + q["key"]
        is_ratio = q["key"].endswith("_relative")  # It has no unit among numbers with one.
        unit = q.get("unit") or ("" if is_ratio else owner.get("unit", ""))
        title = f"{owner['title']}: {q['title']}" if "title" in owner else q["title"]
        if q["kind"] == "record":
            inner = {"record": q["record"], "title": title, "unit": unit}
            rows += responses_in(inner, path + ".", records)
        elif q["kind"] in ("number", "series") and q.get("response", True):
            path += ".max" if q["kind"] == "series" else ""
            rows.append((f"`{path}`", unit, title))
    return rows


def response_page(schema: dict) -> str:
    text = (
        "# Responses\n\nThe numbers of results by their paths, which studies and optimizations\n"
        "record, except those of `preload` and `fit`; `prs compare` takes those of `preload`.\n"
        "Of a series of threads `.max`, `.min`, `.mean` or `[k]`, from 0, is one number.\n"
        "A thread that is open, and each of a missing roller, has load and pressure 0 and counts:\n"
        "`.min` is 0 then, and `.mean` is that of all.\n"
        "`load_cases[1].` before a path means the second load case; without it, the first.\n\n"
    )
    others = [a["name"] for a in schema["analyses"] if "takes" in a]  # No study runs these.
    for place in schema["documents"]:
        if place["path"] in others or place["path"] == "references[]":
            continue
        before = "" if place["path"] == "load_cases[]" else place["path"] + "."
        if rows := responses_in({"record": place["record"]}, before, schema["records"]):
            text += f"## {place['path']}\n{table(('path', 'unit', 'title'), rows)}\n"
    return NOTE + text.rstrip() + "\n"


def keys_in(value: dict, path: str, links: dict[str, str]) -> list[tuple[str, ...]]:
    """The values of a document below a path; records of the tables have pages of their own."""
    said = value.get("description", "")
    if "$ref" in value:
        name = value["$ref"].rpartition("/")[2]
        return [(f"`{path}`", links.get(name, name), said)]
    if value.get("type") == "array":
        return keys_in(value["items"], path + "[]", links)
    if "properties" in value:
        return [
            row
            for key, inner in value["properties"].items()
            for row in keys_in(inner, f"{path}.{key}", links)
        ]
    if isinstance(values := value.get("additionalProperties"), dict):
        return keys_in(values | ({"description": said} if said else {}), path + ".*", links)
    if words := value.get("enum"):
        return [(f"`{path}`", " or ".join(words), said)]
    kind = value.get("type", "text")
    kind = " or ".join(kind) if isinstance(kind, list) else kind
    return [(f"`{path}`", kind.replace("string", "text"), said)]


def keys_of_all(schemas: dict[str, dict]) -> set[str]:
    """What every document has."""
    return schemas["configurations"]["properties"].keys() & schemas["check"]["properties"].keys()


def document_page(schemas: dict[str, dict], results: dict) -> str:
    links = {"Input": "[a case](inputs.md)", "Figure": "`prs schema figures`"}
    for place in results["documents"]:
        page = place["path"].replace("[]", "").replace(".", "_")
        for name in records_in(place["record"], results["records"], []):
            links.setdefault(name, f"[{name}]({page}.md#{name.lower()})")
    text = (
        "# Documents\n\nWhat `--json` prints, and `--output` writes, by command. `.*` stands for\n"
        "any key, `[]` for the entries of a list. `prs schema COMMAND` prints a JSON Schema of it."
        "\n"
        "`resolved_input` is the case with overrides and defaults in place: as a file of its own,\n"
        "it gives the same results.\n\n"
    )
    head = ("key", "value", "what it is")

    def rows_of(properties: dict) -> list[tuple[str, ...]]:
        return [row for key, value in properties.items() for row in keys_in(value, key, links)]

    always = keys_of_all(schemas)
    shared = {k: v for k, v in schemas["check"]["properties"].items() if k in always}
    text += f"## Every document\n{table(head, rows_of(shared))}\n"
    for command, schema in schemas.items():
        for form in schema.get("oneOf", [schema]):
            own = {k: v for k, v in form["properties"].items() if k not in always}
            text += f"## {command}\n{table(head, rows_of(own))}\n"
            for name, definition in schema["$defs"].items():
                if f'"#/$defs/{name}"' in json.dumps(own) and name not in links:
                    text += f"### {name}\n{table(head, rows_of(definition['properties']))}\n"
    return NOTE + text.rstrip() + "\n"


def anchor(name: str) -> str:
    return name.replace(" ", "-")


def commands_in(command: dict) -> list[dict]:
    """A command, then those in it."""
    return [command, *(each for c in command.get("commands", []) for each in commands_in(c))]


def term(option: dict) -> str:
    """`-o, --output DIR`, as a cell."""
    return f"`{' '.join([', '.join(option.get('names', [])), option.get('value', '')]).strip()}`"


def effect(option: dict) -> str:
    """The help of an option or argument, with the words that may stand for an argument."""
    said, words = option["help"], option.get("words", [])
    if words and "names" not in option and words[0] + ":" not in said:
        said += ": " + ", ".join(words)
    return said + "; required" * (option["required"] and "names" in option)


def command_page(program: dict) -> str:
    """Every command; options that more than half of them have are explained once."""
    commands = commands_in(program)[1:]
    given = [option for command in commands for option in command.get("options", [])]
    common: list[dict] = []
    for option in given:
        if 2 * given.count(option) > len(commands) and option not in common:
            common.append(option)
    head = ("option", "what it does")
    text = "# Commands\n\n" + program["help"] + ".\n\n"
    rows = [(f"[`{c['name']}`](#{anchor(c['name'])})", c["help"]) for c in commands]
    text += table(("command", "what it does"), rows)
    rows = [(status, meaning) for status, meaning in program["exit_status"].items()]
    text += "\n" + table(("exit status", "meaning"), rows)
    text += "\n## Options of most commands\n\n"
    text += table(head, [(term(option), effect(option)) for option in common])
    for command in commands:
        text += f"\n## {command['name']}\n{command['help']}.\n\n    {command['usage']}\n\n"
        options = command.get("options", [])
        own = [option for option in options if option not in common]
        rows = [(term(option), effect(option)) for option in command.get("arguments", []) + own]
        text += table(head, rows) + "\n" if rows else ""
        shared = [f"`{option['names'][-1]}`" for option in options if option in common]
        text += f"[Also](#options-of-most-commands) {', '.join(shared)}.\n"
        if examples := command.get("examples"):
            lines = "".join(f"    {line}\n" for line in examples.split("\n"))
            text += f"\nExamples:\n\n{lines}"
    return NOTE + text


def reference(
    program: dict,
    results: dict,
    inputs: dict[str, dict],
    units: list[dict],
    documents: dict[str, dict],
) -> dict[Path, str]:
    pages = result_pages(results)
    links = "".join(
        f"- [`{place['path']}`]({name})\n"
        for place, name in zip(results["documents"], pages, strict=True)
    )
    pages["commands.md"] = command_page(program)
    pages["inputs.md"] = input_page(inputs["input"], units, "Inputs", "case")
    pages["requirement.md"] = input_page(inputs["requirement"], units, "Requirement", "requirement")
    pages["responses.md"] = response_page(results)
    pages["documents.md"] = document_page(documents, results)
    pages["README.md"] = (
        f"{NOTE}# Reference\n\n"
        "- [Commands](commands.md): every command and option of the program\n"
        "- [Inputs](inputs.md): every key of a case, with unit, bounds and default\n"
        "- [Requirement](requirement.md): the same of a requirement, for `prs size`\n"
        "- [Documents](documents.md): what every command prints with `--json`\n"
        "- [Responses](responses.md): the numbers that studies record\n\n"
        "Every quantity of the results, with its formula and source; units stand at the end of the "
        f"keys. {CUT}\n\n{links}"
    )
    files = {PAGES / name: wrap(text) for name, text in pages.items()}
    studied = inputs["input"]["properties"]["study"]["properties"]["command"]["enum"]
    files[PYTHON / "records.py"] = python_records(results["records"], studied)
    files[PYTHON / "results.py"] = python_results(results, documents)
    return files


def python_records(records: dict, studied: list[str]) -> str:
    text = '''"""What stands inside the result documents; names and units are those of `prs --json`.

Of what a case may not define the attribute is None; `record["name"]` raises and says why.
Written by scripts/reference.py from the program's table.
"""

from __future__ import annotations

from typing import Literal

import numpy as np
import numpy.typing as npt

from rollerscrew.record import Record

Array = npt.NDArray[np.float64]  #: Read-only.

#: What each design of a study runs through.
'''
    words = ", ".join(f'"{word}"' for word in studied)
    text += f"Command = Literal[{words}]\n"
    for name, record in records.items():
        said = "".join(f"\n{told_of(q)}" for q in record["quantities"])
        said = docstring(f"{record['meaning']}\n{said}", " " * 4)
        text += f"\n\nclass {name}(Record):\n{said}\n    __slots__ = ()\n"
        for q in record["quantities"]:
            if keyword.iskeyword(q["key"]):  # `record["from"]` alone.
                continue
            kind = KINDS.get(q["kind"], q.get("record", ""))
            kind = f"list[{kind}]" if q["kind"] == "records" else kind
            text += f"    {q['key']}: {kind}{' | None' * q.get('optional', False)}\n"
    return text


def told_of(q: dict) -> str:
    """A quantity in a docstring: `efficiency: power out over power in; source`."""
    said = "; ".join(q[name] for name in ("meaning", "validity", "source") if name in q)
    return f"{q['key']}{' [' + q['unit'] + ']' if 'unit' in q else ''}: {said or q['title']}"


def classes_in(module: str) -> dict[str, ast.ClassDef]:
    """Those that a module of the package has by hand."""
    tree = ast.parse((PYTHON / module).read_text())
    return {item.name: item for item in tree.body if isinstance(item, ast.ClassDef)}


def stated_in(owner: ast.ClassDef) -> set[str]:
    """Its methods, and what its own lines annotate or assign."""
    functions = {item.name for item in owner.body if isinstance(item, ast.FunctionDef)}
    targets = {
        target.id
        for item in owner.body
        for target in getattr(item, "targets", [getattr(item, "target", None)])
        if isinstance(target, ast.Name)
    }
    return functions | targets


def python_type(value: dict, records: dict) -> str:
    """The type of a key of a document; what has no record in the tables is `Values`."""
    name = value.get("$ref", "").rpartition("/")[2]
    if name in records:
        return f"records.{name}"
    if value.get("type") == "array":
        items = value["items"]
        is_numbers = items.get("type") in ("integer", "number")
        return "records.Array" if is_numbers else f"list[{python_type(items, records)}]"
    kinds = {"integer": "int", "number": "float", "boolean": "bool", "string": "str"}
    return kinds.get(value.get("type", ""), "Values")


def docstring(text: str, margin: str) -> str:
    return textwrap.indent(f'"""{text}' + "\n" * ("\n" in text) + '"""\n', margin)


def python_results(results: dict, schemas: dict[str, dict]) -> str:
    """A class for each form of a document, and the methods of a case that answer with them.

    What views.py and case.py have by hand is taken from there.
    """
    views, by_hand = classes_in("views.py"), stated_in(classes_in("case.py")["Case"])
    always = keys_of_all(schemas)
    names: list[str] = []
    classes = methods = ""
    for analysis in results["analyses"]:
        command = analysis["name"]
        schema = schemas[command]
        for form in schema.get("oneOf", [schema]):
            own = {key: value for key, value in form["properties"].items() if key not in always}
            block = command if command in own else [k for k in form["required"] if k in own][-1]
            is_first = form is schema or form is schema["oneOf"][0]
            name = analysis["class"] if is_first else block.capitalize() + "Result"
            view = views.get(name.removesuffix("Result") + "Views")
            if not view and not is_first:  # No answer of a case alone.
                continue
            bases = ["Result"]
            if view:
                others = [ast.unparse(base).replace("Views", "Result") for base in view.bases]
                bases = [f"views.{view.name}", *(other for other in others if other in names)]
            stated = stated_in(view) if view else set()
            said = (view and ast.get_docstring(view)) or analysis["help"] + "."
            lines = [f'_command = "{command}"']
            lines += [] if "_block" in stated else [f'_block = "{block}"']
            for key, value in own.items():
                kind = python_type(value, results["records"])
                kind += " | None" * (key not in form["required"])
                if key not in stated or "Values" not in kind:  # By hand more may be said.
                    lines.append(f"{key}: {kind}")
            classes += f"\n\nclass {name}({', '.join(bases)}):\n{docstring(said, ' ' * 4)}\n"
            classes += "".join(f"    {line}\n" for line in ["__slots__ = ()", *lines])
            names.append(name)
            if is_first and command not in by_hand and "takes" not in analysis:
                methods += f"\n    def {command}(self) -> {name}:\n{docstring(said, ' ' * 8)}"
                methods += f'        return {name}._answer(self, "{command}")\n'
    shared = [name for name in views if name.endswith("Result")]
    public = "".join(f'    "{name}",\n' for name in sorted(["Result", *names, *shared]))
    return f'''"""What the commands answer: documents with data frames and pictures.

Written by scripts/reference.py from the program's list of analyses and from views.py.
"""

from __future__ import annotations

from rollerscrew import _engine, records, views
from rollerscrew.record import Result, Values
from rollerscrew.views import {", ".join(shared)}

__all__ = [
{public}]
{classes}

class Analyses:
    """The commands that a case answers in one call."""

    __slots__ = ()
    _case: _engine.Case
{methods}'''


def main() -> int:
    def of(*arguments: str) -> dict:
        run = subprocess.run([sys.argv[1], *arguments], check=True, capture_output=True)
        return json.loads(run.stdout)

    program = of("help", "--json")
    schema = next(c for c in program["commands"] if c["name"] == "prs schema")
    tables = ("input", "results", "figures", "requirement")
    documents = {
        command: of("schema", command)
        for command in schema["arguments"][0]["words"]
        if command not in tables
    }
    inputs = {word: of("schema", word) for word in ("input", "requirement")}
    units = of("list", "units", "--json")["quantities"]
    files = reference(program, of("schema", "results"), inputs, units, documents)
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
