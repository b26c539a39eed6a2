#!/usr/bin/env python3
"""Checks sources against the rooms of scripts/rooms.toml: includes
against their order, circles of folders, sources of no room, too many tokens or loose files, and
what one room declares and another defines: functions, members, types. So each room links alone."""

import argparse
import ast
import re
import sys
import tomllib
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
ROOMS = ROOT / "scripts/rooms.toml"
CONTRIBUTING = ROOT / "docs/CONTRIBUTING.md"
MOST_LOOSE_FILES = 12
# Tokens of C and C++, which line widths, comments and moved files leave as they are: what is new
# finds room by shrinking what stands.
CPP_FOLDERS = ("contact", "fe", "modules", "prs", "python/engine", "simd", "validation", "wasm")
MOST_TOKENS = 910_000
TOKEN = re.compile(
    r"//[^\n]*|/\*.*?\*/|^[ \t]*\#[ \t]*(?:include|pragma)[^\n]*"
    r"|R\"(\w*)\(.*?\)\1\"|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])+'"
    r"|[A-Za-z_]\w*|\.?\d(?:[\w.']|[eEpP][+-])*|::|->|<<|>>|[-+*/%=<>!&|^]=|&&|\|\||\+\+|--|\S",
    re.DOTALL | re.MULTILINE,
)
MOST_PLOT_LINES = 985


CPP = (".h", ".c", ".cpp")

# Sources that show the results of a room with `shown`.
SHOWN = re.compile(
    r"_(record|json|table|csv|columns|files|figures|pictures|parts|case|analysis|criteria)$"
)


class Room(NamedTuple):
    folder: str
    uses: list[str]  # names of rooms
    hidden: list[str]  # those that rooms above do not see
    purpose: str
    shown: list[str]  # what those sources see besides; empty where there are none


def read_rooms() -> dict[str, Room]:
    """Rooms by their name; those with sources that show results are two."""
    rooms = {
        name: Room(
            row["folder"], row["uses"], row.get("hidden", []), row["holds"], row.get("shown", [])
        )
        for name, row in tomllib.loads(ROOMS.read_text()).items()
    }
    for name, room in list(rooms.items()):
        if room.shown:
            rooms[f"{name}_shown"] = Room(room.folder, [name, *room.shown], [], room.purpose, [])
    return rooms


def room_of(file: Path, rooms: dict[str, Room]) -> str | None:
    """The name of the room that a file of the repository belongs to."""
    found = next((name for name, room in rooms.items() if room.folder == str(file.parent)), None)
    return f"{found}_shown" if found and rooms[found].shown and SHOWN.search(file.stem) else found


def seen_by(name: str, rooms: dict[str, Room]) -> list[str]:
    """The rooms whose headers a room sees, in their order."""
    seen: set[str] = set()
    waiting = rooms[name].uses + rooms[name].hidden
    while waiting:
        if (next_room := waiting.pop()) in rooms and next_room not in seen:
            seen.add(next_room)
            waiting += rooms[next_room].uses
    return [room for room in rooms if room in seen]


def faults_of_file(file: Path, rooms: dict[str, Room], graph: dict[str, set[str]]) -> Iterator[str]:
    place = file.relative_to(ROOT)
    name = room_of(place, rooms)
    assert name
    seen = seen_by(name, rooms)
    for number, line in enumerate(file.read_text().splitlines(), 1):
        match = re.match(r'\s*#\s*include\s+"([^"]+)"', line)
        if not match:
            continue
        folder = str(Path(match[1]).parent)
        if folder == "." and (file.parent / match[1]).exists():  # C that is shipped elsewhere too.
            continue
        target = room_of(Path(match[1]), rooms)
        if target == name:
            continue
        if target and folder != rooms[name].folder:
            graph[rooms[name].folder].add(folder)
        if target not in seen:
            where = f"of room {target}" if target else "of no room"
            yield (
                f'{place}:{number}: room {name} includes "{match[1]}" {where}; it may see:\n'
                f"  {', '.join(seen) or 'no other room'} (uses in scripts/rooms.toml)"
            )


def faults(rooms: dict[str, Room]) -> Iterator[str]:
    graph: dict[str, set[str]] = {room.folder: set() for room in rooms.values()}
    for top in sorted({room.folder.partition("/")[0] for room in rooms.values()}):
        for file in sorted((ROOT / top).rglob("*.*")):
            place = file.relative_to(ROOT)
            folder = str(place.parent)
            if file.suffix not in (".h", ".cpp") or folder.startswith("prs/cli"):
                continue
            if folder not in graph:
                yield f"{place}: {folder} is no room; name it in scripts/rooms.toml"
                continue
            yield from faults_of_file(file, rooms, graph)
    for room in rooms.values():
        used = {rooms[name].folder for name in room.uses + room.hidden if name in rooms}
        graph[room.folder].update(used - {room.folder})
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        yield f"a circle of folders: {' <- '.join(error.args[1])}"
    sources = [f for folder in CPP_FOLDERS for f in (ROOT / folder).rglob("*") if f.suffix in CPP]
    tokens = sum(
        not match[0].lstrip().startswith(("//", "/*", "#"))
        for source in sources
        for match in TOKEN.finditer(source.read_text())
    )
    if tokens > MOST_TOKENS:
        yield f"{tokens} tokens of {MOST_TOKENS} in C and C++; shrink what stands twice"
    plots = "python/rollerscrew/plots"
    lines = sum(lines_of_code(file.read_text()) for file in (ROOT / plots).rglob("*.py"))
    if lines > MOST_PLOT_LINES:
        yield f"{plots}: {lines} lines of {MOST_PLOT_LINES}; shrink what stands twice"
    loose = [file for file in (ROOT / "prs").iterdir() if file.suffix in (".h", ".cpp")]
    if len(loose) > MOST_LOOSE_FILES:
        yield f"prs/: {len(loose)} loose files of {MOST_LOOSE_FILES}; move them into rooms"


def lines_of_code(source: str) -> int:
    """Lines of a Python source without docstrings, which say more to readers than they cost."""
    places = (ast.Module, ast.ClassDef, ast.FunctionDef)
    nodes = [node for node in ast.walk(ast.parse(source)) if isinstance(node, places)]
    docs = [node.body[0] for node in nodes if ast.get_docstring(node, clean=False)]
    return source.count("\n") - sum(doc.end_lineno - doc.lineno + 1 for doc in docs)


class Statement(NamedTuple):
    scope: str  # namespaces and classes around it, joined by "::"
    text: str
    line: int
    has_body: bool


def without_texts(code: str) -> str:
    """The code with its comments, texts and preprocessor lines blanked."""
    text, symbol = r'"(?:\\.|[^"\\\n])*"', r"(?<!\w)'(?:\\.|[^'\\\n])+'"
    skipped = rf'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|{text}|{symbol}'
    blank = lambda match: re.sub(r"[^\n]", " ", match[0])  # noqa: E731
    code = re.sub(skipped, blank, code, flags=re.S)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", blank, code, flags=re.M)


def statements(code: str) -> Iterator[Statement]:
    """What stands in namespaces and classes, without bodies of functions."""
    scopes: list[str | None] = []  # None: a body
    start, inside = 0, 0  # parentheses
    for match in re.finditer(r"[;{}()]", code):
        symbol, here = match[0], match.start()
        inside += (symbol == "(") - (symbol == ")")
        if inside > 0 or symbol in "()":
            continue
        if None not in scopes and symbol != "}":
            text = re.sub(r"\b(?:public|private|protected)\s*:", "", code[start:here])
            line = code.count("\n", 0, here) + 1 - text.strip().count("\n")
            names = [scope for scope in scopes if scope]
            yield Statement("::".join(names), " ".join(text.split()), line, symbol == "{")
        if symbol == "{":
            head = " ".join(code[start:here].split())
            space = re.match(r"(?:inline )?namespace\b ?([\w:]*)$", head)
            kind = re.match(
                r"(?:template ?<.*> ?)?(?:struct|class)\b.*?(\w+)(?: final)?(?: ?:.*)?$", head
            )
            open_scope = (space[1] or "(unnamed)") if space else kind[1] if kind else None
            scopes.append(open_scope if None not in scopes else None)
        elif symbol == "}" and scopes:
            scopes.pop()
        start = match.end()


def types_of(parameters: str) -> tuple[str, ...]:
    """Types of a list of parameters, without their names and defaults."""
    types, depth, part = [], 0, ""
    for symbol in parameters + ",":
        depth += (symbol in "<({[") - (symbol in ">)}]")
        if symbol != "," or depth > 0:
            part += symbol
            continue
        words = part.split("=")[0].split()
        if len(words) > 1 and re.fullmatch(r"\w+", words[-1]) and words[-2] != "const":
            words.pop()
        text = re.sub(r"\b\w+::", "", "".join(words))
        types.append(re.sub(r"([&*>])\w+$", r"\1", text))
        part = ""
    return tuple(types)


def declared(statement: Statement) -> tuple[str, ...] | None:
    """What identifies a function or type that a statement declares or defines."""
    text = statement.text
    if re.match(
        r"(?:extern template|template|using|typedef|friend|static_assert|namespace)\b", text
    ):
        return None
    place = "" if "(unnamed)" in statement.scope else statement.scope
    if not place or " = delete" in text or " = default" in text:
        return None
    if match := re.fullmatch(r"(?:struct|class|enum class)\s+(\w+)\b(?!.*\().*", text):
        return (f"{place}::{match[1]}",)
    match = re.search(r"([\w:~]+|operator ?[^\s\w(]+)\s*\((.*)\)", text)
    if not match or "=" in text[: match.start()] or not text[: match.start()].strip():
        return None
    parameters, depth = "", 0
    for symbol in match[2] + ")":
        depth += (symbol == "(") - (symbol == ")")
        if depth < 0:
            break
        parameters += symbol
    return (f"{place}::{match[1]}", *types_of(parameters))


def misplaced(rooms: dict[str, Room]) -> Iterator[str]:
    """What one room declares and only another one defines."""
    by_folder = {room.folder: name for name, room in reversed(rooms.items())}
    declarations: dict[tuple[str, ...], list[tuple[str, str]]] = {}
    definitions: dict[tuple[str, ...], set[str]] = {}
    for folder, name in by_folder.items():
        for file in sorted((ROOT / folder).glob("*.*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            for statement in statements(without_texts(file.read_text())):
                if not (what := declared(statement)):
                    continue
                if statement.has_body:
                    definitions.setdefault(what, set()).add(name)
                elif file.suffix == ".h":
                    place = f"{file.relative_to(ROOT)}:{statement.line}"
                    declarations.setdefault(what, []).append((name, place))
    for what, places in declarations.items():
        found = definitions.get(what, set())
        for name, place in places:
            lower = [room for room in found if room in seen_by(name, rooms)]
            if found and name not in found and not (len(what) == 1 and lower):
                yield f"{place}: room {name} declares {what[0]}, which room {min(found)} defines"


def hidden_name(statement: Statement) -> str | None:
    """What a statement of an anonymous namespace itself names, an alias apart."""
    text = re.sub(r"^template ?<.*?> ?(?=\w)|\[\[.*?\]\] ?", "", statement.text)
    macro_or_other = r"(?:using|namespace|static_assert|extern)\b|[A-Z_]+\(|\W|\w*$"
    if not statement.scope.endswith("(unnamed)") or re.match(macro_or_other, text):
        return None
    if match := re.match(r"(?:struct|class|enum(?: class)?)\s+(\w+)(?!.*\()", text):
        return match[1]
    match = re.search(r"(\w+)(?:\[\w*\])*\s*(?:\(|=|$)", text)
    return match[1] if match else None


def repeated(rooms: dict[str, Room]) -> Iterator[str]:
    """What two files name alike in anonymous namespaces, of which one may hide the other where both
    are compiled in one batch (prs/CMakeLists.txt)."""
    first: dict[tuple[str, str, str], Path] = {}
    for top in ("prs", "fe", "contact", "simd", "validation"):
        for file in sorted((ROOT / top).rglob("*.cpp")):
            place = file.relative_to(ROOT)
            library = top if top == "validation" else room_of(place, rooms) or str(place.parent)
            code = statements(without_texts(file.read_text()))
            for name in {(s.scope, name) for s in code if (name := hidden_name(s))}:
                other = first.setdefault((library, *name), place)
                if other != place:
                    yield f"{place}: `{name[1]}` stands in an anonymous namespace of {other} too"


def table(rooms: dict[str, Room]) -> str:
    lines = ["| room | holds | uses |", "| --- | --- | --- |"]
    for name, room in rooms.items():
        if room.folder.startswith("prs") and not name.endswith("_shown"):
            shown = [used for used in room.shown if used not in room.uses]
            uses = ", ".join(used for used in room.uses + room.hidden + shown if used in rooms)
            uses = uses or "nothing"
            lines.append(f"| `{room.folder}/` ({name}) | {room.purpose} | {uses} |")
    return "\n".join(lines) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--write", action="store_true", help="update the table in CONTRIBUTING.md")
    rooms = read_rooms()
    text = CONTRIBUTING.read_text()
    updated = re.sub(r"\| room \| holds \| uses \|\n(\|.*\n)*", lambda _: table(rooms), text)
    if parser.parse_args().write:
        CONTRIBUTING.write_text(updated)
        text = updated
    found = [*faults(rooms), *misplaced(rooms), *repeated(rooms)]
    if text != updated:
        found.append(
            "docs/CONTRIBUTING.md: its table is not that of scripts/rooms.toml;\n"
            "  scripts/check_rooms.py --write updates it"
        )
    print("\n".join(found), end="\n" if found else "", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
