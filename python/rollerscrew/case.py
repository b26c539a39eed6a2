"""A case: what a file of the command line describes."""

from __future__ import annotations

import math
import os
import reprlib
import tempfile
import webbrowser
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import Any, Self

from rollerscrew import _engine
from rollerscrew.designs import Designs, evaluate, study_rows, thread_count
from rollerscrew.progress import Progress, progress_callback
from rollerscrew.records import Command
from rollerscrew.results import Analyses, DerivativesResult, OptimizationResult, StudyResult
from rollerscrew.values import case_text, checked_text, override_text

_FILE = "<case>"


class Case(Analyses):
    """A planetary roller screw with its loads, as a case file describes it.

    >>> case = Case.from_yaml("configs/01_config_1_to_3.yaml")
    >>> case.with_({"mechanism.rollers": 9}).solve().load_cases[0].axial_stiffness_N_per_um

    `blocks` are those of a file: dictionaries whose values are texts with their unit (`"45 kN"`),
    pint quantities, numbers, lists. Cases do not change; `with_` gives another one. They may be
    shared between threads, pickled and sent to other processes.

    Raises InputError, with the text of `prs check`, where something is wrong. For a case from
    dictionaries line numbers are those of `text`.
    """

    __slots__ = ("_case",)

    def __init__(self, blocks: Mapping[str, Any], *, name: str = _FILE) -> None:
        if not isinstance(blocks, Mapping):
            raise TypeError(
                f"got {type(blocks).__name__}; expected a dictionary of blocks such as "
                "{'mechanism': {..}}; `Case.from_yaml` reads a file"
            )
        self._case = _engine.Case(_source(name, case_text(blocks), [], _folder(name)))

    @classmethod
    def from_yaml(
        cls, file: str | os.PathLike[str], *, set: Mapping[str, Any] | None = None
    ) -> Self:
        """The case of a file, with values replaced as `--set` does it."""
        overrides = _overrides({} if set is None else set)
        return cls._from_source(_engine.Source.load(_file_name(file), overrides))

    @classmethod
    def from_text(cls, text: str, *, name: str = _FILE) -> Self:
        """The case of a YAML text; `name` stands for the file in messages."""
        return cls._from_source(_source(name, text, [], _folder(name)))

    @classmethod
    def _from_source(cls, source: _engine.Source) -> Self:
        case = cls.__new__(cls)
        case._case = _engine.Case(source)
        return case

    def with_(self, values: Mapping[str, Any] | None = None, /, **blocks: Any) -> Self:
        """The case with other values: `case.with_({"load_cases[0].axial_force": "30 kN"})`.

        Paths are those of `--set`; texts are taken as they would stand in the file. Whole blocks
        may be given by their names: `case.with_(operation={"speed": "400 rpm"})`.
        """
        source = self._case.source
        changed = [*_overrides({} if values is None else values), *_overrides(blocks)]
        return self._from_source(
            _source(source.name, source.text, [*source.overrides, *changed], source.folder)
        )

    @property
    def name(self) -> str:
        """The file, as it was given."""
        return self._case.source.name

    @property
    def text(self) -> str:
        """The YAML text, without `overrides`."""
        return self._case.source.text

    @property
    def overrides(self) -> list[str]:
        """What `with_` changed: `path=value` each."""
        return list(self._case.source.overrides)

    def report(
        self,
        file: str | os.PathLike[str],
        *,
        results: str | os.PathLike[str] | Sequence[str | os.PathLike[str]] = (),
    ) -> bool:
        """Writes one HTML page of all that the case asks for, to read, print and hand over.

        Of its study and its optimization the page shows what `prs study` or `prs optimize` left in
        one of the folders `results`. False where something on the page did not converge.
        """
        folders = [results] if isinstance(results, str | os.PathLike) else results
        return self._case.report(_file_name(file), [_file_name(folder) for folder in folders])

    def explore(
        self,
        file: str | os.PathLike[str] | None = None,
        *,
        results: str | os.PathLike[str] | Sequence[str | os.PathLike[str]] = (),
    ) -> Path:
        """Writes the page of `report` and opens it in the browser, where its sliders move values.

        Without `file` into a new folder for temporary files. Returns where the page is.
        """
        page = Path(tempfile.mkdtemp(prefix="prs-")) / "case.html" if file is None else Path(file)
        self.report(page, results=results)
        webbrowser.open(page.resolve().as_uri())
        return page

    def export_fmu(
        self,
        file: str | os.PathLike[str],
        *,
        force: float | None = None,
        speed: float | None = None,
        load_case: str | None = None,
    ) -> list[str]:
        """Writes a co-simulation unit of FMI 2.0, as `prs export --fmu` does; its warnings.

        `force` [N] and `speed` [rad/s] are the largest of the curves, else those of the case. The
        conditions are those of `load_case`, else of the first.
        """
        return self._export(file, ".fmu", force, speed, load_case)

    def export_modelica(
        self,
        file: str | os.PathLike[str],
        *,
        force: float | None = None,
        speed: float | None = None,
        load_case: str | None = None,
    ) -> list[str]:
        """Writes a Modelica package of the same curves; its warnings."""
        return self._export(file, ".mo", force, speed, load_case)

    def _export(
        self,
        file: str | os.PathLike[str],
        ending: str,
        force: float | None,
        speed: float | None,
        load_case: str | None,
    ) -> list[str]:
        name = _file_name(file)
        if not name.endswith(ending):
            raise ValueError(f"file: got {name!r}; expected a name that ends in {ending}")
        for what, value in (("force", force), ("speed", speed)):
            if value is not None and not (math.isfinite(value) and value > 0.0):
                raise ValueError(f"{what}: got {value!r}; expected a finite number > 0")
        return self._case.export_model(name, force, speed, load_case)

    def study(
        self,
        *,
        executor: Executor | None = None,
        threads: int | None = None,
        progress: Progress = None,
    ) -> StudyResult | DerivativesResult:
        """Runs the block `study` of the case: all its designs, on `threads` threads.

        With an `executor` of `concurrent.futures` (processes, Dask's `Client.get_executor()`, MPI
        pools) its workers answer the designs. The result does not depend on either. `progress` is
        called with the designs done and those of the whole study; True shows a line on a terminal.

        A design that no mechanism can have, or that does not converge, is a row with its reason.
        The plan `derivatives` gives a DerivativesResult.
        """
        study, rows = study_rows(self._case.source, executor, threads, progress)
        if rows is None:
            return DerivativesResult(study.derivatives())._of(self)
        return StudyResult(rows.document(), None, study, rows)._of(self)

    def optimize(
        self, *, threads: int | None = None, progress: Progress = None
    ) -> OptimizationResult:
        """Searches the designs that the block `optimize` of the case aims at."""
        source = self._case.source
        document, chosen = _engine.optimize(
            source, thread_count(threads), progress_callback(progress)
        )
        if chosen is None:
            return OptimizationResult(document)._of(self)
        best = _source(f"{source.name} (optimized)", chosen, [], source.folder)
        return OptimizationResult(document, Case._from_source(best))._of(self)

    def evaluate(
        self,
        inputs: Mapping[str, Any],
        responses: Sequence[str] | None = None,
        *,
        command: Command = "solve",
        threads: int | None = None,
        progress: Progress = None,
    ) -> Designs:
        """Answers many designs in one call: one for each element of the arrays in `inputs`.

        >>> case.evaluate({"mechanism.lead": (leads, "mm"), "mechanism.rollers": rollers},
        ...               ["axial_stiffness_N_per_um", "screw.peak_pressure_MPa.max"])

        `inputs` gives each path, as `--set` takes it, an array of numbers with its unit, a pint
        array, or a list of what may stand there; single values are those of all designs.
        `responses` are paths into the document of the command: those of the first load case may
        leave `load_cases[0].` out, arrays take `[k]`, `.max`, `.min` and `.mean`. Without them
        those that a study records are.

        Warns of inputs that move no load and no stiffness, as the case overrides what they give.
        Raises InputError where a value cannot stand at its path, and ValueError for numbers that
        are not finite or lengths that differ.
        """
        return evaluate(self._case.source, inputs, responses, command, threads, progress)

    def __reduce__(self) -> tuple[Any, ...]:
        name, text, overrides, folder = self._parts()
        return _restore, (type(self), name, text, list(overrides), folder)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Case):
            return NotImplemented
        return self._parts() == other._parts()

    def __hash__(self) -> int:
        return hash(self._parts())

    def _parts(self) -> tuple[str, str, tuple[str, ...], str]:
        source = self._case.source
        return source.name, source.text, tuple(source.overrides), source.folder

    def __repr__(self) -> str:
        changed = "".join(f", {override}" for override in self.overrides)
        return f"<Case {self.name}{changed}>"


def _restore(kind: type[Case], name: str, text: str, overrides: list[str], folder: str) -> Case:
    return kind._from_source(_source(name, text, overrides, folder))


def _source(name: str, text: str, overrides: list[str], folder: str) -> _engine.Source:
    """A case that looks for the files it names in `folder`."""
    return _engine.Source.of_text(
        checked_text("name", name), checked_text("text", text), overrides, folder
    )


def _folder(name: str) -> str:
    return os.path.abspath(os.path.dirname(checked_text("name", name)))


def _file_name(file: str | os.PathLike[str]) -> str:
    name = checked_text("file", os.fspath(file))
    if "\0" in name:
        raise ValueError(f"file: got {name!r}; expected a path without the character NUL")
    return name


def _overrides(values: Mapping[str, Any]) -> list[str]:
    if not isinstance(values, Mapping):
        raise TypeError(
            f"set: got {reprlib.repr(values)}; expected a dictionary such as "
            "{'mechanism.rollers': 9}"
        )
    return [f"{checked_text('path', path)}={override_text(item)}" for path, item in values.items()]


def explore(case: Case, file: str | os.PathLike[str] | None = None) -> Path:
    """Writes the live page of a case and opens it in the browser: `Case.explore`."""
    return case.explore(file)
