"""Values of a result document as attributes."""

from __future__ import annotations

import json
import os
import reprlib
import typing
from collections.abc import Iterator, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, ClassVar, Self

from rollerscrew import _engine
from rollerscrew.values import checked_text

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.axes import Axes

    from rollerscrew.case import Case
    from rollerscrew.results import Analyses


class Record:
    """An object of a result document: `record.axial_stiffness_N_per_um`, `record["nut"]`.

    Names and units are those of `prs --json`. Arrays of numbers are read-only arrays of numpy on
    the memory of the document, which lives as long as one of them does. A quantity that the case
    does not define is absent: asking for it raises, `get` gives its default.
    """

    __slots__ = ("_node",)
    _node: _engine.Node

    def __init__(self, node: _engine.Node) -> None:
        object.__setattr__(self, "_node", node)

    def _attribute(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        if hasattr(type(self), name):  # A property that raised: let it say why.
            return object.__getattribute__(self, name)
        try:
            return self._wrapped(name, self._node.get(name))
        except (KeyError, TypeError):
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
        return [*super().__dir__(), *self.keys()]

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {', '.join(self.keys())}>"

    def __copy__(self) -> Self:
        return self

    def __deepcopy__(self, memo: dict[int, Any]) -> Self:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        raise TypeError("part of a result cannot be pickled; pickle the result, or `to_dict()`")

    def to_dict(self) -> dict[str, Any]:
        """Plain dictionaries, lists and arrays, as far down as the record goes."""
        return {name: _plain(value) for name, value in self.items()}

    def _wrapped(self, name: str, value: Any) -> Any:
        owner: type = type(self)
        return _wrap(value, _record_types(owner).get(name, Values))

    def _absent(self, name: str) -> str:
        there = ", ".join(self.keys()) or "nothing"
        return f"{reprlib.repr(name)} is not defined by this case; there is {there}"


class Values(Record):
    """A record whose names depend on the case."""

    __slots__ = ()

    def __getattr__(self, name: str) -> Any:
        return self._attribute(name)


def _wrap(value: Any, record: type[Record]) -> Any:
    if isinstance(value, _engine.Node):
        return record(value)
    if isinstance(value, list):
        return [_wrap(item, record) for item in value]
    return value


def _plain(value: Any) -> Any:
    if isinstance(value, Record):
        return value.to_dict()
    if isinstance(value, list):
        return [_plain(item) for item in value]
    return value


@cache
def _record_types(owner: type) -> dict[str, type[Record]]:
    """The record that each annotation asks for: `nut: InterfaceLoads`, `list[LoadCase]`."""
    found = {}
    for name, hint in typing.get_type_hints(owner).items():
        for candidate in (hint, *typing.get_args(hint)):
            if isinstance(candidate, type) and issubclass(candidate, Record):
                found[name] = candidate
    return found


class Result(Record):
    """What a command answers: its document as attributes, as text, as data frames, as pictures."""

    __slots__ = ("_case", "_document")
    _document: _engine.Document
    _case: Any  # Case | None

    #: The block that a document of this kind has.
    _block: ClassVar[str] = "prs_version"

    prs_version: str
    schema_version: str
    command: str
    case_file: str
    input_sha256: str
    overrides: list[str]
    warnings: list[str]
    #: The case with overrides and defaults in place. That of the text is what `Case` takes.
    resolved_input: Values

    def __init__(self, document: _engine.Document) -> None:
        object.__setattr__(self, "_document", document)
        object.__setattr__(self, "_case", None)

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
        said = []
        if "load_cases" in self:
            said.append(f"{len(self['load_cases'])} load cases")
        if self.warnings:
            said.append(f"{len(self.warnings)} warnings")
        return f"<{type(self).__name__}: {', '.join([*said, *self.keys()])}>"

    @classmethod
    def from_json(cls, text: str) -> Self:
        """The result that `to_json`, or the command line with `--json`, wrote.

        Raises ValueError where the text is no such document.
        """
        document = _engine.Document.from_text(checked_text("document", text))
        if cls._block not in document.root:
            raise ValueError(
                f"no document of a {cls.__name__}: got {', '.join(document.root.keys())}; expected "
                f"{cls._block!r} among them"
            )
        return cls(document)

    def to_json(self) -> str:
        """The document as the command line prints it with `--json`, byte for byte."""
        return self._document.text()

    def report(
        self,
        file: str | os.PathLike[str],
        *,
        results: str | os.PathLike[str] | Sequence[str | os.PathLike[str]] = (),
    ) -> bool:
        """Writes one HTML page of all that the case of the result asks for: `Case.report`.

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

        return self._case or Case(self.resolved_input.to_dict(), name=self.case_file)

    def figures(self) -> list[dict[str, Any]]:
        """Descriptions of the pictures of the result, for `rollerscrew.plots.draw`.

        Those that `prs --figures --json` writes; none of a result that was read from other JSON.
        """
        described: list[dict[str, Any]] = json.loads(self._document.figures())
        return described

    def plot_figure(self, name: str, ax: Axes | None = None, **options: Any) -> Axes:
        """Draws one of the pictures by its name: `slip.plot_figure("slip_patches", load_case=1)`.

        All its panels into a new figure, or what they have in common into the axes given. Raises
        ValueError where the result has no such picture, or nothing to draw.
        """
        from rollerscrew import plots

        chosen = {option: value for option, value in options.items() if value is not None}
        described = self._document.figure(name, json.dumps(chosen), ax is not None)
        return plots.draw(json.loads(described), ax)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self).from_json, (self.to_json(),)
