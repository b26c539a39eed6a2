"""Values of a result document as attributes."""

from __future__ import annotations

import difflib
import json
import os
import re
import reprlib
import textwrap
import typing
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar, Self

import numpy as np
import numpy.typing as npt

from rollerscrew import _engine
from rollerscrew.values import checked_text

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes

    from rollerscrew.case import Case
    from rollerscrew.results import Analyses


class Look(typing.TypedDict, total=False):
    """How a picture looks: its name in the legend, its colour, the width of a new figure in mm."""

    label: str | None
    color: Any
    width: float | None


def in_words(word: str) -> str:
    """A word of a document as texts have it: loads that are `static` are those at rest."""
    return "at rest" if word == "static" else word.replace("_", " ")


#: So many names stand in the texts of records and designs, which are one line.
_MOST_NAMES = 6


def some_of(names: Sequence[str]) -> str:
    """The first names, and how many others there are."""
    more = len(names) - _MOST_NAMES
    return ", ".join(names[:_MOST_NAMES]) + (f", .. {more} others" if more > 0 else "")


#: Names with one underscore before them.
_PRIVATE = re.compile(r"_(?!_)")


def _no_numbers(count: int) -> npt.NDArray[np.float64]:
    """So many missing numbers, where the document has a list without entries or of null."""
    numbers = np.full(count, np.nan)
    numbers.flags.writeable = False
    return numbers


class Record:
    """An object of a result document: `record.axial_stiffness_N_per_um`, `record["nut"]`.

    Names and units are those of `prs --json`. Arrays of numbers are read-only arrays of numpy on
    the memory of the document, which lives as long as one of them does.

    A quantity may be absent: the case does not define it, or its computation failed. Its attribute,
    whose type says so, is None then, `record["nut"]` raises and says why, `get` gives its default.
    Records with the same content are equal.
    """

    __slots__ = ("_key", "_node", "_owner")
    _node: _engine.Node
    _key: str  #: That it stands under in its owner.
    _owner: Record | None

    def __init__(self, node: _engine.Node, key: str = "", owner: Record | None = None) -> None:
        object.__setattr__(self, "_node", node)
        object.__setattr__(self, "_key", key)
        object.__setattr__(self, "_owner", owner)

    def _attribute(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        if hasattr(type(self), name):  # A property that raised: let it say why.
            return object.__getattribute__(self, name)
        try:
            return self._wrapped(name, self._node.get(name))
        except (KeyError, TypeError):
            if name in types_of(type(self)).optional:
                return None
            raise AttributeError(self._absent(name)) from None

    if not TYPE_CHECKING:  # Type checkers know the names that are annotated.
        __getattr__ = _attribute

    def __getitem__(self, name: str) -> Any:
        try:
            return self._wrapped(name, self._node.get(name))
        except (KeyError, TypeError):  # The engine takes texts in UTF-8 alone.
            raise KeyError(self._absent(name)) from None

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"results are read-only; {name!r} was not set")

    def get(self, name: str, default: Any = None) -> Any:
        """The value, or `default` where the case does not define it."""
        return self[name] if name in self else default

    def keys(self) -> list[str]:
        return self._node.keys()

    def items(self) -> Iterator[tuple[str, Any]]:
        return ((name, self[name]) for name in self.keys())

    def __contains__(self, name: object) -> bool:
        try:
            return isinstance(name, str) and name in self._node
        except TypeError:
            return False

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __len__(self) -> int:
        return len(self.keys())

    def __dir__(self) -> list[str]:
        """Without the private names."""
        return [name for name in (*super().__dir__(), *self.keys()) if not _PRIVATE.match(name)]

    def __repr__(self) -> str:
        told = [self[key] for key in ("name", "loads", "status") if key in self]
        words = ", ".join(in_words(each) for each in told if isinstance(each, str))
        kind = f"{type(self).__name__} {words}".strip()
        return f"<{kind}: {some_of(self.keys())}>"

    def _repr_html_(self) -> str:
        from rollerscrew.html import record_html

        return record_html(self)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Record):
            return NotImplemented
        return self is other or (type(self) is type(other) and self._text() == other._text())

    def __hash__(self) -> int:
        return hash((type(self), self._text()))

    def _text(self) -> str:
        """The content as JSON."""
        return self._node.text()

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (type(self), self._text(), self._key)

    def to_dict(self) -> dict[str, Any]:
        """Plain dictionaries, lists and numbers, as far down as the record goes."""
        content: dict[str, Any] = json.loads(self._text())
        return content

    def _wrapped(self, name: str, value: Any) -> Any:
        if isinstance(value, list) and name in types_of(type(self)).arrays and not any(value):
            return _no_numbers(len(value))
        return self._wrap(value, types_of(type(self)).records.get(name, Values), name)

    def _wrap(self, value: Any, record: type[Record], name: str) -> Any:
        if isinstance(value, _engine.Node):
            return record(value, name, self)
        if isinstance(value, list):
            return [self._wrap(item, record, name) for item in value]
        return value

    def _absent(self, name: str) -> str:
        """Why there is no such value."""
        said = reprlib.repr(name)
        known = isinstance(name, str) and name in types_of(type(self)).optional
        status = self.get("status", "converged") if known else "converged"
        if status != "converged":
            why = "; ".join(self._reasons())
            return f"{said} is absent: {self._key or 'this'} ended with {status!r}" + (
                f": {why}" if why else ""
            )
        there = some_of(self.keys()) or "nothing"
        needs = self._needed(name) if known else ""
        hint = "" if known or not isinstance(name, str) else self._meant(name)
        said += f" is not defined by this case{needs and '; it ' + needs}; there is {there}"
        return said + hint

    def _needed(self, name: str) -> str:
        """`needs ..`: what the case lacks for a quantity, or another command that answers it."""
        from rollerscrew.reasons import Reasons

        path, top = name, self
        while top._owner is not None:
            place = f"load_cases[{top.get('name')}]" if top._key == "load_cases" else top._key
            path, top = f"{place}.{path}", top._owner
        if isinstance(top, Result) and "resolved_input" in top:
            is_record = name in types_of(type(self)).records
            told = Reasons(top._own_case(), top.command).lacking(path + "." * is_record)
            if told:
                return told
        return needs_of(type(self).__name__, name)

    def _meant(self, name: str) -> str:
        """`; did you mean ..?`: what has nearly that name, or stands further within."""
        own = [each for each in dir(self) if not each.startswith("_")]
        near = [each for each in own if name in each] or difflib.get_close_matches(name, own, 3)
        if name.startswith("plot_"):
            drawn = [each for each in own if each.startswith("plot_") and each != "plot_figure"]
            near = [each for each in drawn if name.rstrip("s") in each] or drawn
        for part in self.keys() if not near else []:
            value = self._node.get(part)
            place = part
            if isinstance(value, list) and value:
                place, value = f"{part}[0]", value[0]
            if isinstance(value, _engine.Node):
                near += [f"{place}.{key}" for key in value.keys() if name in key]
        return f"; did you mean {', '.join(near)}?" if near else ""

    def _reasons(self) -> list[str]:
        """Why it did not converge: its own reason, or what its owner warns of it."""
        if "reason" in self:
            return [str(self["reason"])]
        warnings = self._owner.get("warnings", []) if self._owner is not None else []
        return [text for text in warnings if f"{self._key}: " in text]


class Values(Record):
    """A record whose names depend on the case."""

    __slots__ = ()

    def __getattr__(self, name: str) -> Any:
        return self._attribute(name)


def _restored(kind: type[Record], text: str, key: str) -> Record:
    return kind(_engine.Node.of_text(text), key)


def _restored_result(kind: type[Result], text: str, case: Case | None) -> Result:
    result = kind.from_json(text)
    return result if case is None else result._of(case)


class _Types(typing.NamedTuple):
    """What the annotations of a record say."""

    records: dict[str, type[Record]]  #: `nut: InterfaceLoads`, `list[LoadCase]`.
    optional: frozenset[str]  #: What may be absent.
    arrays: frozenset[str]
    hints: dict[str, Any]  #: Of all keys, None apart.


_KNOWN: dict[type, _Types] = {}


def types_of(owner: type) -> _Types:
    """What the annotations of a class of records say."""
    if owner not in _KNOWN:
        _KNOWN[owner] = _read_types(owner)
    return _KNOWN[owner]


def _read_types(owner: type) -> _Types:
    records, optional, arrays, hints = {}, set(), set(), {}
    for name, hint in typing.get_type_hints(owner).items():
        if name.startswith("_"):
            continue
        within = typing.get_args(hint)
        if type(None) in within:
            optional.add(name)
            hint = next(each for each in within if each is not type(None))
        hints[name] = hint
        if typing.get_origin(hint) in (np.ndarray, npt.NDArray):  # The alias from NumPy 2.5 on.
            arrays.add(name)
        for candidate in (hint, *typing.get_args(hint)):
            if isinstance(candidate, type) and issubclass(candidate, Record):
                records[name] = candidate
    return _Types(records, frozenset(optional), frozenset(arrays), hints)


@cache
def results_schema() -> dict[str, Any]:
    """Every quantity of the results, as `prs schema results` prints it."""
    schema: dict[str, Any] = json.loads(_engine.results_schema())
    return schema


def explanation(path: str, blocks: Sequence[str]) -> str:
    """The quantities whose paths end in `path`, or all in these blocks of a document."""
    schema = results_schema()
    places: list[tuple[str, dict[str, Any]]] = []

    def add(record: str, before: str) -> None:
        for quantity in schema["records"][record]["quantities"]:
            own = f"{before}.{quantity['key']}"
            places.append((own, quantity))
            if "record" in quantity:
                add(quantity["record"], own + "[]" * (quantity["kind"] == "records"))

    for document in schema["documents"]:
        if path or document["path"].removesuffix("[]") in blocks:
            add(document["record"], document["path"])
    plain = re.sub(r"\[[^\]]*\]", "", path)
    for asked in (plain, plain.rpartition(".")[0]):  # `peak_pressure_MPa.max` of a study.
        found = [each for each in places if f".{each[0].replace('[]', '')}".endswith(f".{asked}")]
        if found or not path:
            break
    found = found if path else places
    if not found:
        near = difflib.get_close_matches(plain, [each["key"] for _, each in places], 3)
        meant = f"; did you mean {', '.join(dict.fromkeys(near))}?" if near else ""
        raise ValueError(f"path: got {path!r}; expected the path of a quantity of a result{meant}")
    text = ""
    for k, (place, quantity) in enumerate(found):
        text += place + "\n"
        if k + 1 < len(found) and found[k + 1][1] == quantity:
            continue  # What stands in several places is explained once.
        for key, before in _EXPLAINED.items():
            if quantity.get(key):
                text += textwrap.fill(
                    before + quantity[key], 100, initial_indent="  ", subsequent_indent="  ",
                    break_long_words=False, break_on_hyphens=False,
                ) + "\n"  # fmt: skip
    return text


_EXPLAINED = {
    "title": "", "unit": "unit: ", "meaning": "meaning: ", "validity": "valid: ",
    "source": "source: ",
}  # fmt: skip


def needs_of(record: str, name: str) -> str:
    """`needs measures.shaft`, where a quantity of a record says what a case must state for it."""
    quantities = results_schema()["records"].get(record, {}).get("quantities", [])
    for quantity in quantities:
        if quantity["key"] == name:
            return needs_in(quantity)
    return ""


def needs_in(quantity: Mapping[str, str]) -> str:
    """`needs ..` of the validity or the meaning of a quantity."""
    for said in (quantity.get("validity", ""), quantity.get("meaning", "")):
        for clause in said.split("; "):
            if clause.startswith("needs "):
                return clause
    return ""


#: Keys of every document, and those that the text of a result counts.
_OF_ALL = frozenset(
    "prs_version schema_version command case_file input_sha256 overrides assumptions "
    "resolved_input warnings load_cases".split()
)


def loads_of(document: Record) -> str:
    """Whether thread loads of a document are those at rest or running, or both; empty without."""
    records = [*document.get("load_cases", []), document.get("life"), document.get("preload")]
    told = [
        each.get("loads" if "name" in each else "thread_loads")
        for each in records
        if isinstance(each, Record)
    ]
    return " and ".join(dict.fromkeys(in_words(each) for each in told if each))


class Result(Record):
    """What a command answers: its document as attributes, as text, as data frames, as pictures."""

    __slots__ = ("_case", "_document")
    _document: _engine.Document
    _case: Any  # Case | None

    #: The block that a document of this kind has.
    _block: ClassVar[str] = "prs_version"

    #: The command that gives it; empty: any.
    _command: ClassVar[str] = ""

    prs_version: str
    schema_version: str
    command: str
    case_file: str
    #: Of what was computed: of the file and, where there are any, of overrides and history.
    input_sha256: str
    overrides: list[str] | None
    #: Choices of the model that matter for the case.
    assumptions: list[str] | None
    #: The case with overrides and defaults in place; `Case` takes it.
    resolved_input: Values

    def __init__(self, document: _engine.Document) -> None:
        object.__setattr__(self, "_document", document)
        object.__setattr__(self, "_case", None)
        object.__setattr__(self, "_key", "")
        object.__setattr__(self, "_owner", None)

    @property
    def converged(self) -> bool:
        """Whether all of it is an answer: the command would end with the status 0."""
        told = self._document.converged
        return _all_converged(self.to_dict()) if told is None else told

    @property
    def warnings(self) -> list[str]:
        """On the whole case, then those of each load case with its name."""
        said: list[str] = list(self.get("warnings", []))
        for case in self.get("load_cases", []):
            said += [f"load case {case['name']}: {text}" for text in case.get("warnings", [])]
        return said

    @classmethod
    def _answer(cls, case: Analyses, command: str) -> Self:
        """What a command of the engine answers for a case."""
        return cls(getattr(case._case, command)())._of(case)

    def _of(self, case: Analyses) -> Self:
        """The result with the case that gave it."""
        object.__setattr__(self, "_case", case)
        return self

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            if name == "_node":  # Made when it is first looked at.
                object.__setattr__(self, "_node", self._document.root)
                return self._node
            return self._attribute(name)

    def __repr__(self) -> str:
        cases, warned = self.get("load_cases", []), len(self.warnings)
        parts = []
        if cases:
            parts.append(f"{len(cases)} load case{'s' * (len(cases) > 1)}")
        if loads := loads_of(self):
            parts.append(f"loads {loads}")
        if warned:
            parts.append(f"{warned} warning{'s' * (warned > 1)}")
        own = [key for key in self.keys() if key not in _OF_ALL]
        return f"<{type(self).__name__}: {'; '.join([*parts, some_of(own)])}>"

    @classmethod
    def from_json(cls, text: str) -> Self:
        """The result that `to_json`, or the command line with `--json`, wrote.

        Raises ValueError where the text is no such document.
        """
        document = _engine.Document.from_text(checked_text("document", text))
        command = document.root.get("command") if "command" in document.root else cls._command
        if cls._command and command != cls._command:
            raise ValueError(
                f"no document of a {cls.__name__}: got one of the command {command!r}; expected "
                f"{cls._command!r}; `Result.from_json` reads any"
            )
        if cls._block not in document.root:
            raise ValueError(
                f"no document of a {cls.__name__}: got {', '.join(document.root.keys())}; expected "
                f"{cls._block!r} among them"
            )
        return cls(document)

    def to_json(self) -> str:
        """The document as the command line prints it with `--json`, byte for byte."""
        return self._document.text()

    def _text(self) -> str:
        return self._document.text()

    def report(
        self,
        file: str | os.PathLike[str],
        *,
        results: str | os.PathLike[str] | Sequence[str | os.PathLike[str]] = (),
    ) -> bool:
        """Writes one HTML page of everything that the case of the result requests: `Case.report`.

        That of a result which was read from JSON is its `resolved_input`.
        """
        return self._own_case().report(file, results=results)

    def explore(
        self,
        file: str | os.PathLike[str] | None = None,
        *,
        results: str | os.PathLike[str] | Sequence[str | os.PathLike[str]] = (),
    ) -> Path:
        """Writes that page and opens it in the browser: `Case.explore`."""
        return self._own_case().explore(file, results=results)

    def _own_case(self) -> Case:
        from rollerscrew.case import Case

        return self._case or Case(self.resolved_input, name=self.case_file)

    def figures(self) -> list[dict[str, Any]]:
        """Descriptions of the pictures of the result, for `rollerscrew.plots.draw`.

        Those that `prs --figures --json` writes; none of a result that was read from other JSON.
        """
        described: list[dict[str, Any]] = json.loads(self._pictured().figures())
        return described

    def _pictured(self) -> _engine.Document:
        """The document with its pictures; one that was sent here is answered once more for them."""
        if self._case is None or self._document.has_pictures or not self._command:
            return self._document
        again = getattr(self._case, self._command)()
        if again.to_json() == self.to_json():
            object.__setattr__(self, "_document", again._document)
        return self._document

    def plot_figure(
        self,
        name: str,
        ax: Axes | None = None,
        *,
        label: str | None = None,
        color: Any = None,
        width: float | None = None,
        **options: Any,
    ) -> Axes:
        """Draws one of the pictures by its name: `slip.plot_figure("slip_patches", load_case=1)`.

        All its panels into a new figure, or what they have in common into the axes given; `label`,
        `color` and `width` as `rollerscrew.plots.draw` has them. Raises ValueError where the result
        has no such picture, or nothing to draw.
        """
        from rollerscrew import plots

        chosen = {option: value for option, value in options.items() if value is not None}
        described = self._pictured().figure(name, json.dumps(chosen), ax is not None)
        return plots.draw(json.loads(described), ax, label=label, color=color, width=width)

    def explain(self, path: str = "") -> str:
        """What a quantity is, with unit, formula, validity and source: `prs --explain`.

        `path` is that of the quantity or its end: `slip.efficiency`, `efficiency`. Without one: all
        quantities of the result.
        """
        return explanation(checked_text("path", path), self.keys())

    def _repr_html_(self) -> str:
        from rollerscrew.html import result_html

        return result_html(self)

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored_result, (type(self), self.to_json(), self._case)


def _all_converged(value: Any) -> bool:
    """Whether nothing in a document says that it did not converge."""
    if isinstance(value, list):
        return all(map(_all_converged, value))
    if not isinstance(value, dict):
        return True
    if value.get("command") in ("study", "optimize"):  # Failed designs are rows.
        return True
    return value.get("converged") is not False and all(
        _all_converged(item) for key, item in value.items() if key != "resolved_input"
    )
