"""A case: what a file of the command line describes."""

from __future__ import annotations

import copy
import csv
import errno
import io
import json
import math
import os
import re
import reprlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from numbers import Real
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Self, TypeVar, overload

from rollerscrew import _engine
from rollerscrew.designs import (
    Designs,
    OnError,
    SourceParts,
    batches,
    evaluate,
    history_columns,
    parts_of,
    study_rows,
    thread_count,
)
from rollerscrew.errors import InputError, warn_caller
from rollerscrew.frames import frame_of
from rollerscrew.function import Function, function_of
from rollerscrew.progress import Progress, progress_callback
from rollerscrew.reasons import COMMANDS, Reasons, response_in
from rollerscrew.record import Record, Result, in_words, some_of
from rollerscrew.records import Command
from rollerscrew.results import (
    Analyses,
    CompareResult,
    DerivativesResult,
    FitResult,
    LifeResult,
    OptimizationResult,
    StudyResult,
)
from rollerscrew.values import case_text, checked, checked_text, number_text, override_text

if TYPE_CHECKING:
    from concurrent.futures import Executor

    import pandas as pd

_FILE = "<case>"

#: Name of a history that is given as arrays. Messages put no folder before a name in such brackets.
_HISTORY = "<history>"

#: Options of a history; others are those of `life`.
_OF_HISTORY = ("interval", "hysteresis", "bins")


class Case(Analyses):
    """A planetary roller screw with its loads, as a case file describes it.

    >>> case = Case.from_yaml("configs/01_config_1_to_3.yaml")
    >>> case.with_({"mechanism.rollers": 9}).solve().load_cases[0].axial_stiffness_N_per_um

    `blocks` are those of a file: dictionaries whose values are texts with their unit (`"45 kN"`),
    numbers and their unit (`(45, "kN")`), pint quantities, numbers, lists. `resolved_input` of a
    result is a case too. Cases do not change; `with_` gives another one. The files that a case
    names are read when it is made, and are part of it. Cases may be shared between threads, pickled
    and sent to other processes.

    `case["mechanism.lead"]` is a value as it was written, or its default; `inputs()` lists them,
    `responses()` what may be asked for.

    Raises InputError, with the text of `prs check`, where something is wrong. For a case from
    dictionaries line numbers are those of `text`.
    """

    __slots__ = ("_case", "_resolved")
    _resolved: dict[str, Any]

    def __init__(self, blocks: Mapping[str, Any] | Record, *, name: str = _FILE) -> None:
        files = None
        if isinstance(blocks, Record):
            files, blocks = _history_of(blocks), blocks.to_dict()
        if not isinstance(blocks, Mapping):
            raise TypeError(
                f"got {type(blocks).__name__}; expected a dictionary of blocks such as "
                "{'mechanism': {..}}; `Case.from_yaml` reads a file"
            )
        self._case = _engine.Case(_source(name, case_text(blocks), [], _folder(name), files))

    @classmethod
    def from_yaml(
        cls, file: str | os.PathLike[str], *, set: Mapping[str, Any] | None = None
    ) -> Self:
        """The case of a file, with values replaced as `--set` does it.

        Parameters
        ----------
        file : str or os.PathLike
            The case file.
        set : dict, optional
            Values by their paths.

        Returns
        -------
        Case

        Raises
        ------
        InputError, MissingFileError
            Where something in the file is wrong, or it is not there.
        """
        overrides = _overrides({} if set is None else set)
        return cls._from_source(_engine.Source.load(_file_name(file), overrides))

    @classmethod
    def from_text(cls, text: str, *, name: str = _FILE) -> Self:
        """The case of a YAML text; `name` stands for the file in messages.

        Parameters
        ----------
        text : str
            YAML, as a case file has it.
        name : str, optional
            Name in messages; its folder is where files are looked for.

        Returns
        -------
        Case
        """
        return cls._from_source(_source(name, text, [], _folder(name)))

    @classmethod
    def _from_source(cls, source: _engine.Source) -> Self:
        case = cls.__new__(cls)
        case._case = _engine.Case(source)
        return case

    def with_(self, values: Mapping[str, Any] | None = None, /, **blocks: Any) -> Self:
        """The case with other values: `case.with_({"load_cases[0].axial_force": "30 kN"})`.

        Paths are those of `--set`; texts are taken as they would stand in the file. Whole blocks
        may be given by their names, and take the place of what stands there:
        `case.with_(operation={"speed": "400 rpm"})`.

        Values that `rollerscrew.new` assumed stay as they are; where they cannot stand with the
        change, the InputError has the call of `new` that makes the case anew.

        Parameters
        ----------
        values : dict, optional
            Values by their paths: texts with a unit, `(5, "mm")`, pint quantities, numbers, lists.
        **blocks : dict
            Whole blocks by their names.

        Returns
        -------
        Case

        Raises
        ------
        InputError
            Where a value cannot stand at its path.
        """
        source = self._case.source
        changed = [*_overrides({} if values is None else values), *_overrides(blocks)]
        changed_source = _source(
            source.name, source.text, [*source.overrides, *changed], source.folder, source.files
        )
        try:
            return self._from_source(changed_source)
        except InputError as error:
            if anew := _made_anew(source.text, [*source.overrides, *changed], error):
                raise InputError(anew) from None
            for name, block in blocks.items():
                if isinstance(block, Mapping) and block and name in self:
                    path = f"{name}.{next(iter(block))}"
                    error.add_note(
                        f"{name}={{..}} takes the place of the whole block; "
                        f"`with_({{{path!r}: ..}})` changes one value of it"
                    )
            raise

    def __getitem__(self, path: str) -> Any:
        """The value at a path as it was written, `5 mm`, or its default; a block is a dictionary.

        Entries of lists have their place or their name: `load_cases[pull].axial_force`.
        """
        if not hasattr(self, "_resolved"):
            self._resolved = self.check().resolved_input.to_dict()
        value: Any = self._resolved
        for step in _steps(path):
            try:
                value = value[_place(value, step) if isinstance(value, list) else step]
            except (KeyError, IndexError, TypeError):
                meant = [each.path for each in self.check().input if each.path.endswith(f".{step}")]
                hint = f"; did you mean {', '.join(map(repr, meant[:3]))}?" if meant else ""
                raise KeyError(
                    f"{path!r}: this case has no {step!r} there{_there(value)}{hint}"
                ) from None
        return copy.deepcopy(value)

    def __contains__(self, path: object) -> bool:
        try:
            self[path]  # type: ignore[index]
        except (KeyError, TypeError):
            return False
        return True

    def inputs(self) -> pd.DataFrame:
        """Every input of the case: path, value, whether it is a default, and what it rests on.

        Returns
        -------
        pandas.DataFrame
        """
        return self.check().to_frame()

    def number(self, path: str, unit: str = "") -> float:
        """The number at a path in a unit: `case.number("mechanism.lead", "mm")`.

        Parameters
        ----------
        path : str
            Path of an input that is a number.
        unit : str, optional
            Unit of the answer; of a bare number none.

        Returns
        -------
        float

        Raises
        ------
        KeyError
            Where the case has no such path.
        ValueError
            Where the value has no such unit.
        """
        value = self[path]
        text = value if isinstance(value, str) else repr(value)
        number = _engine.number_in(text, checked_text("unit", unit))
        if number is None:
            raise ValueError(
                f"{path}: got {reprlib.repr(value)} and the unit {unit!r}; expected a unit that "
                "the value can be converted to; `rollerscrew.units()` lists them"
            )
        return number

    @overload
    def to_yaml(self) -> str: ...
    @overload
    def to_yaml(self, file: str | os.PathLike[str]) -> None: ...
    def to_yaml(self, file: str | os.PathLike[str] | None = None) -> str | None:
        """The text of the case with what `with_` changed written into it, comments and all.

        Written to `file`, if one is given, for `Case.from_yaml`; the files that the case names are
        written beside it.
        Raises ValueError where a change has no place of its own in the text, as a new list has.

        Parameters
        ----------
        file : str or os.PathLike, optional
            Where the text is written.

        Returns
        -------
        str or None
            The text, where no file is given.
        """
        source = self._case.source
        text = source.written()
        if text is None:
            parts = (source.name, source.text)
            alone = (
                each
                for each in source.overrides
                if _source(*parts, [each], source.folder, source.files).written() is None
            )
            change = next(alone, ", ".join(source.overrides))
            raise ValueError(
                f"{reprlib.repr(change)[1:-1]} cannot be written into the text in its place; write "
                "the resolved case, `Case(case.check().resolved_input).to_yaml(file)`, which has "
                "no comments"
            )
        if file is None:
            return text
        path = Path(_file_name(file))
        for name, content in (source.files or {}).items():
            if not os.path.isabs(name):
                (path.parent / name).parent.mkdir(parents=True, exist_ok=True)
                (path.parent / name).write_bytes(content)
        path.write_text(text, encoding="utf-8")
        return None

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
        """Writes one HTML page of everything that the case requests, to read, print and hand over.

        Of its study and its optimization the page shows what `prs study` or `prs optimize` left in
        one of the folders `results`. False where something on the page did not converge.
        Warns where the page is static because the package has no engine of live pages. Raises
        OSError where the page cannot be written.

        Parameters
        ----------
        file : str or os.PathLike
            The page, `.html`.
        results : path or list of paths, optional
            Folders of results of the command line.

        Returns
        -------
        bool
        """
        from rollerscrew.library import live_parts_folder

        folders = [results] if isinstance(results, str | os.PathLike) else results
        live_parts = live_parts_folder()
        if absent := _engine.live_parts_absent(live_parts):
            warn_caller(f"the page is static: {absent}")
        expected = "a folder, or a list of folders"
        names = [_file_name(each) for each in checked("results", folders, Iterable, expected)]
        name = _file_name(file)
        return _written(lambda: self._case.report(name, names, live_parts))

    def explore(
        self,
        file: str | os.PathLike[str] | None = None,
        *,
        results: str | os.PathLike[str] | Sequence[str | os.PathLike[str]] = (),
    ) -> Path:
        """Writes the page of `report` and opens it in the browser, where its sliders move values.

        Without `file` into a new folder for temporary files. Returns where the page is.

        Parameters
        ----------
        file : str or os.PathLike, optional
            The page, `.html`.
        results : path or list of paths, optional
            Folders of results of the command line.

        Returns
        -------
        pathlib.Path
        """
        import tempfile
        import webbrowser

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
        conditions are those of `load_case`, else of the first. Raises OSError where the file cannot
        be written, as the other exports do.
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

    def export_mjcf(
        self,
        file: str | os.PathLike[str],
        *,
        force: float | None = None,
        speed: float | None = None,
        load_case: str | None = None,
        friction_load: float | None = None,
        play: Literal["joint"] | None = None,
    ) -> list[str]:
        """Writes the drive of the block `response` for MuJoCo; its warnings.

        The friction is that under `friction_load` [N], else under the root mean square force of
        the run of `response`. A Python module next to the file, `axis_friction.py` for
        `axis.xml`, computes the friction by force and sense. `play="joint"` makes play and
        elasticity a joint of their own.
        """
        if play not in (None, "joint"):
            raise ValueError(f"play: got {play!r}; expected 'joint' or None")
        return self._export(file, ".xml", force, speed, load_case, friction_load, play == "joint")

    def export_urdf(
        self,
        file: str | os.PathLike[str],
        *,
        force: float | None = None,
        speed: float | None = None,
        load_case: str | None = None,
        friction_load: float | None = None,
    ) -> list[str]:
        """Writes the drive of the block `response` as URDF; its warnings."""
        return self._export(file, ".urdf", force, speed, load_case, friction_load)

    def _export(
        self,
        file: str | os.PathLike[str],
        ending: str,
        force: float | None,
        speed: float | None,
        load_case: str | None,
        friction_load: float | None = None,
        play_joint: bool = False,
    ) -> list[str]:
        name = _file_name(file)
        if not name.endswith(ending):
            raise ValueError(f"file: got {name!r}; expected a name that ends in {ending}")
        given = (("force", force), ("speed", speed), ("friction_load", friction_load))
        for what, value in given:
            if value is not None and not (
                isinstance(value, Real) and math.isfinite(value) and value > 0.0
            ):
                raise ValueError(f"{what}: got {value!r}; expected a finite number > 0")
        if load_case is not None:
            checked_text("load_case", load_case)
        options = (force, speed, load_case, friction_load, play_joint)
        return _written(lambda: self._case.export_model(name, *options))

    def study(
        self,
        *,
        executor: Executor | None = None,
        threads: int | None = None,
        progress: Progress = None,
    ) -> StudyResult | DerivativesResult:
        """Runs the block `study` of the case: all its designs, on `threads` threads.

        >>> case.with_(study={"command": "solve", "factors": [{"path": "mechanism.rollers",
        ...                   "values": [8, 9, 10]}]}).study().to_frame()

        With an `executor` of `concurrent.futures` (processes, Dask's `Client.get_executor()`, MPI
        pools) its workers answer the designs. The result does not depend on either. `progress` is
        called with the designs done and those of the whole study; True shows a line on a terminal.

        A design that no mechanism can have, or that does not converge, is a row with its reason.
        The plan `derivatives` gives a DerivativesResult.

        Parameters
        ----------
        executor : concurrent.futures.Executor, optional
            Answers the designs in place of threads.
        threads : int, optional
            1 to 4096; without it one per processor.
        progress : bool or callable, optional
            Called with the designs done and those of the whole.

        Returns
        -------
        StudyResult or DerivativesResult

        Raises
        ------
        InputError
            Where the case has no block `study`.
        """
        study, rows = study_rows(self._case.source, executor, threads, progress)
        if rows is None:
            return DerivativesResult(study.derivatives())._of(self)
        return StudyResult(rows.document(), None, study, rows)._of(self)

    def life(
        self, *, history: Mapping[str, Any] | pd.DataFrame | None = None, **options: Any
    ) -> LifeResult:
        """Life under a load history or spectrum, static safety.

        `history` takes the place of that of the file: arrays `force` and, where they are known,
        `position` or `speed`, and `time`, each with its unit: `{"force": (forces, "kN"), ..}`; or a
        frame with such columns, their units in the names: `force_kN`. The index of a frame counts
        as a column where it has such a name, and as the time where it holds times. `options` are
        those of the block `life.history`: `interval`, `hysteresis`, `bins`; and of `life`, of which
        a case without that block needs the roller's `position` on the nut.

        Warns where the history has no time and hours are therefore those of motion at
        `operation.speed`.

        Parameters
        ----------
        history : dict or pandas.DataFrame, optional
            Arrays with their units.
        **options : Any
            Keys of `life.history` and of `life`.

        Returns
        -------
        LifeResult
        """
        if history is None and options:
            raise TypeError(
                f"{', '.join(options)}: got options of a history, and no history; "
                "`with_` changes that of the case"
            )
        case = self if history is None else self._with_history(history, options)
        result = LifeResult._answer(case, "life")
        own = case["life"] if history is not None and "operation.speed" in case else None
        if own and "period" not in own and not {"time", "interval"} & set(own["history"]):
            warn_caller(
                "history: got no time; hours are those of motion at operation.speed, "
                f'{case["operation.speed"]}; give `time`, such as {{"time": (times, "s")}}, or the '
                'time between two rows, `interval="0.1 s"`'
            )
        return result

    def _with_history(self, history: Any, options: Mapping[str, Any]) -> Self:
        columns = history_columns(history)
        rows = zip(*(numbers for numbers, _ in columns.values()), strict=True)
        text = ",".join(columns) + "\n"
        text += "".join(",".join(map(number_text, row)) + "\n" for row in rows)
        named = {name: {"column": name, "unit": unit} for name, (_, unit) in columns.items()}
        name, case, overrides, folder, _ = self._parts()
        own = self["life"] if "life" in self else {}
        life = {key: value for key, value in own.items() if key not in ("history", "spectrum")}
        kept = {key: value for key, value in options.items() if key not in _OF_HISTORY}
        block = {"file": _HISTORY, **named}
        block |= {key: value for key, value in options.items() if key in _OF_HISTORY}
        changed = [*overrides, f"life={override_text({**life, **kept, 'history': block})}"]
        return self._from_source(_source(name, case, changed, folder, {_HISTORY: text.encode()}))

    def compare(self, reference: Any = None, **options: Any) -> CompareResult:
        """The models of the bodies side by side, and against references.

        `influence` is among them where the case asks for it, or where its matrices are kept.
        `reference` takes the place of the block `references` of the case: a frame, or arrays by the
        names of columns, `thread` or `force_kN`, `load_case`, and responses; several in a list.
        `options` are the keys of that block: `tolerance="10 % of the mean"`.

        >>> case.compare({"thread": [1, 2], "screw.load_rate_percent": [7.9, 6.9]})

        Parameters
        ----------
        reference : dict, pandas.DataFrame or list of them, optional
            Columns by their names.
        **options : Any
            Keys of the block `references`.

        Returns
        -------
        CompareResult
        """
        if reference is None and options:
            raise TypeError(
                f"{', '.join(options)}: got options of a reference, and no reference; "
                "`with_` changes those of the case"
            )
        return CompareResult._answer(
            self if reference is None else self._with_references(reference, options), "compare"
        )

    def _with_references(self, reference: Any, options: Mapping[str, Any]) -> Self:
        name, text, overrides, folder, files = self._parts()
        frames = reference if isinstance(reference, list) else [reference]
        given, blocks = dict(files or {}), []
        for k, columns in enumerate(map(_with_index, frames), start=1):
            stem = "reference" if len(frames) == 1 else f"reference {k}"
            given[f"<{stem}>"] = _csv_of(stem, columns)
            blocks.append({"file": f"<{stem}>", "name": stem, **options})
        changed = [*overrides, f"references={override_text(blocks)}"]
        return self._from_source(_source(name, text, changed, folder, given))

    def fit(self, data: Mapping[str, Any] | None = None) -> FitResult:
        """Unknown inputs from measured curves, with their uncertainty: the block `fit`.

        `data` takes the place of the files of curves, by their names: a frame, or arrays by the
        names of columns.

        Parameters
        ----------
        data : dict, optional
            Readings by the names of the curves.

        Returns
        -------
        FitResult
        """
        return FitResult._answer(self if data is None else self._with_curves(data), "fit")

    def _with_curves(self, data: Mapping[str, Any]) -> Self:
        name, text, overrides, folder, files = self._parts()
        given = dict(files or {})
        # Where texts of files are given, a check opens no curves.
        bare = _source(name, text, list(overrides), folder, given)
        curves = self._from_source(bare)["fit"]["curves"]
        names = [curve.get("name", f"curve-{k + 1}") for k, curve in enumerate(curves)]
        changed = [*overrides]
        expected = "readings by the names of the curves"
        for curve, columns in checked("data", data, Mapping, expected).items():
            if curve not in names:
                raise ValueError(f"{curve}: got no curve; expected one of {', '.join(names)}")
            at = names.index(curve)
            file = f"<data[{curve!r}]>" if len(curve) < 80 else f"<data of curve {at + 1}>"
            given[file] = _csv_of(f"data[{curve!r}]", columns)
            changed.append(f"fit.curves[{at}].file={json.dumps(file, ensure_ascii=False)}")
        return self._from_source(_source(name, text, changed, folder, given))

    def optimize(
        self, *, threads: int | None = None, progress: Progress = None
    ) -> OptimizationResult:
        """Searches the designs that the block `optimize` of the case aims at.

        Limits of `constraints` may have a unit, which is converted to that of the response:
        `{"response": "screw.peak_pressure_MPa.max", "at_most": (4, "GPa")}`.

        >>> case.with_(optimize={"command": "solve", "variables": [{"path": "mechanism.flank_angle",
        ...     "from": "40 deg", "to": "50 deg"}], "objectives": [{"minimize":
        ...     "screw.peak_pressure_MPa.max"}]}).optimize().best_case

        Parameters
        ----------
        threads : int, optional
            1 to 4096; without it one per processor.
        progress : bool or callable, optional
            Called with the designs done and those of the whole.

        Returns
        -------
        OptimizationResult
        """
        source = self._case.source
        document, chosen = _engine.optimize(
            source, thread_count(threads), progress_callback(progress)
        )
        if chosen is None:
            return OptimizationResult(document)._of(self)
        best = _source(f"{source.name} (optimized)", chosen, [], source.folder, source.files)
        return OptimizationResult(document, Case._from_source(best))._of(self)

    def evaluate(
        self,
        inputs: Mapping[str, Any] | pd.DataFrame,
        responses: Sequence[str] | None = None,
        *,
        command: Command | Literal["preload"] = "solve",
        threads: int | None = None,
        progress: Progress = None,
        on_error: OnError = "raise",
    ) -> Designs:
        """Answers many designs in one call: one for each element of the arrays in `inputs`.

        >>> case.evaluate({"mechanism.lead": (leads, "mm"), "mechanism.rollers": rollers},
        ...               ["axial_stiffness_N_per_um", "screw.peak_pressure_MPa.max"])

        `inputs` gives each path, as `--set` takes it, an array of numbers with its unit, a pint
        array, or a list of what may stand there; single values are those of all designs. A frame
        does, too, with units in the names of its columns: `mechanism.lead_mm`; its index is kept.
        `responses` are paths into the document of the command, see `Case.responses`: those of the
        first load case may leave `load_cases[0].` out, others name theirs
        (`load_cases[pull].axial_stiffness_N_per_um`), arrays are taken whole or with `[k]`, `.max`,
        `.min` or `.mean`. Without them those that a study records are. `preload` has no such
        default, and goes design by design, on one thread and without progress: studies have no plan
        of it, so that a design takes as long as a `preload()` of its own.

        Warns of inputs that move no load and no stiffness, as the case overrides what they give.
        Raises InputError where a value cannot stand at its path, and ValueError for a number that
        is not finite, which with `on_error="row"` are rows with their reason; and ValueError for
        lengths that differ.

        Parameters
        ----------
        inputs : dict or pandas.DataFrame
            Values by their paths; arrays have one length.
        responses : list of str, optional
            Paths into the document of the command.
        command : str, optional
            contact, solve, slip, life, measures, response or preload.
        threads : int, optional
            1 to 4096; without it one per processor.
        progress : bool or callable, optional
            Called with the designs done and those of the whole.
        on_error : {"raise", "row"}, optional
            What a design does whose inputs cannot stand in the case.

        Returns
        -------
        Designs
        """
        return evaluate(self, inputs, responses, command, threads, progress, on_error)

    def evaluate_to_parquet(
        self,
        file: str | os.PathLike[str],
        inputs: Mapping[str, Any] | pd.DataFrame | Iterable[Mapping[str, Any] | pd.DataFrame],
        responses: Sequence[str] | None = None,
        *,
        batch: int = 100_000,
        **options: Any,
    ) -> int:
        """Writes the frames of `evaluate` into a Parquet file, batch by batch; how many designs.

        `inputs` are those of `evaluate`, or an iterable of such batches, of which one is in memory
        at a time. Raises ValueError where there is no design. Needs pyarrow.

        Parameters
        ----------
        file : str or os.PathLike
            The Parquet file.
        inputs : dict, pandas.DataFrame or iterable of them
            As `evaluate` takes them.
        responses : list of str, optional
            As `evaluate` takes them.
        batch : int, optional
            Designs that are in memory at a time.
        **options : Any
            Others of `evaluate`.

        Returns
        -------
        int
            How many designs were written.
        """
        import pyarrow
        import pyarrow.parquet

        count, writer = 0, None
        try:
            for piece in batches(inputs, batch):
                frame = self.evaluate(piece, responses, **options).to_frame()
                table = pyarrow.Table.from_pandas(frame, preserve_index=False)
                writer = writer or pyarrow.parquet.ParquetWriter(_file_name(file), table.schema)
                writer.write_table(table)
                count += len(frame)
        finally:
            if writer is not None:
                writer.close()
        if writer is None:
            raise ValueError("inputs: got no batch; expected at least one design")
        return count

    def function(
        self,
        inputs: Sequence[str] | Mapping[str, str],
        responses: Sequence[str] | Mapping[Command, Sequence[str]],
        command: Command | None = None,
    ) -> Function:
        """The case as a function of numbers, compiled once.

        >>> f = case.function(["mechanism.lead", "load_cases[0].axial_force"],
        ...                   ["axial_stiffness_N_per_um"])
        >>> f(f.x0), f.jacobian(f.x0)

        `f(x)` of the n inputs of one design gives its m responses, of k x n gives k x m. Numbers
        are in the units of the documents, `f.units`: mm, N, deg; `{path: unit}` asks for others.
        `f.designs(x)` has status and reason of designs that fail.

        Without `command` each response is that of the command that has it, `solve` where several
        do; `responses` may also name them: `{"life": ["life.system.l10_hours"], "solve": [..]}`.

        Parameters
        ----------
        inputs : list of str, or dict of paths and units
            What x has, in this order.
        responses : list of str, or dict of commands and such lists
            What f(x) has, in this order.
        command : str, optional
            contact, solve, slip, life, measures or response.

        Returns
        -------
        Function

        Raises
        ------
        InputError, ValueError
            Where a path is none, or the case does not define the response; the message says why.
        """
        return function_of(self, inputs, responses, command)

    def responses(self, command: Command | Literal["preload"] = "solve") -> pd.DataFrame:
        """What `evaluate` may answer for this case by a command, one row per path.

        `loads` says whether a response rests on loads at rest or on running ones, with the friction
        of a screw that turns. `defined` says whether the command answers it for this case; where
        not, `needs` says which other command does, or what the case must state.

        Parameters
        ----------
        command : str, optional
            contact, solve, slip, life, measures, response or preload.

        Returns
        -------
        pandas.DataFrame
            With the columns path, unit, title, loads, defined, needs.
        """
        if command not in COMMANDS:
            raise ValueError(f"command: got {command!r}; expected {' | '.join(COMMANDS)}")
        result: Result = getattr(self, command)()
        if command == "preload":
            return frame_of(_preload_responses(result["preload"], "preload"))
        reasons = Reasons(self, command)
        rows = []
        for path in _engine.known_responses():
            title, unit = _engine.response_title(path)
            defined = response_in(result, path) is not None
            needs = "" if defined else reasons.of(path)
            row = {"path": path, "unit": unit, "title": title}
            loads = _loads_of_response(result, path) if defined else ""
            rows.append({**row, "loads": loads, "defined": defined, "needs": needs})
        return frame_of(rows)

    def __reduce__(self) -> tuple[Any, ...]:
        name, text, overrides, folder, files = self._parts()
        kept = None if files is None else dict(files)
        return _restore, (type(self), name, text, list(overrides), folder, kept)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Case):
            return NotImplemented
        return self._parts() == other._parts()

    def __hash__(self) -> int:
        return hash(self._parts())

    def _parts(self) -> SourceParts:
        return parts_of(self._case.source)

    def _repr_html_(self) -> str:
        from rollerscrew.html import case_html

        return case_html(self)

    def __repr__(self) -> str:
        changed = [override[:60] + ".." * (len(override) > 60) for override in self.overrides]
        return f"<Case {', '.join(filter(None, (self.name, some_of(changed))))}>"


def _restore(
    kind: type[Case],
    name: str,
    text: str,
    overrides: list[str],
    folder: str,
    files: dict[str, bytes] | None,
) -> Case:
    return kind._from_source(_source(name, text, overrides, folder, files))


#: What the head of a case that `new` made calls given: the argument, and where it stands.
_OF_NEW = {
    "screw diameter": ("screw_diameter", "mechanism.pitch_diameter.screw"),
    "lead": ("lead", "mechanism.lead"),
    "starts": ("starts", "mechanism.starts.screw"),
    "rollers": ("rollers", "mechanism.rollers"),
    "nut diameter": ("nut_diameter", "structure.nut.outer_diameter"),
    "nut length": ("nut_length", "structure.nut.length"),
    "roller diameter": ("roller_diameter", "mechanism.pitch_diameter.roller"),
    "profile radius": ("roller_profile_radius", "mechanism.profile.roller.convex"),
    "load": ("load", "load_cases[0].axial_force"),
    "speed": ("speed", "operation.speed"),
    "lubricant": ("lubricant", "lubricant.name"),
    "its temperature": ("temperature", "lubricant.temperature"),
}

_HEAD_OF_NEW = re.compile(
    r"# An? (standard|inverted|recirculating) .*\n#\n# Given: ((?:.*\n# )+?)What was not"
)


def _made_anew(text: str, overrides: list[str], error: InputError) -> str:
    """An error about a value that `new` assumed, with the call that makes the case anew."""
    head = _HEAD_OF_NEW.match(text)
    changed = dict(each.split("=", 1) for each in overrides)
    if head is None or any(error.path.startswith(path) for path in changed):
        return ""
    arguments: dict[str, str] = {}
    for item in head[2].replace("\n# ", " ").strip(" .").split(", "):
        for words, (argument, _) in _OF_NEW.items():
            if re.fullmatch(rf"{words} .*|\d+ {words}", item):
                arguments[argument] = item.removeprefix(words).removesuffix(words).strip()
    for argument, path in _OF_NEW.values():
        if path in changed:
            arguments[argument] = changed.pop(path)
    if len(changed) == len(overrides):
        return ""
    call = f"rollerscrew.new({head[1]!r}"
    for argument, value in arguments.items():
        call += f", {argument}={value if value.isdigit() else repr(value)}"
    call += f").with_({changed})" if changed else ")"
    return "\n".join(
        f"{line}; it was assumed for the values of before: make the case anew, `{call}`"
        for line in str(error).splitlines()
    )


def _with_index(columns: Any) -> Any:
    """A frame with the columns `thread` and `load_case` where its index holds them."""
    names = getattr(getattr(columns, "index", None), "names", [])
    held = [name for name in names if name in ("thread", "load_case") and name not in columns]
    return columns.reset_index(held) if held else columns


def _csv_of(name: str, columns: Any) -> bytes:
    """Arrays by the names of columns, or a frame, as a CSV file."""
    if not hasattr(columns, "columns"):
        checked(name, columns, Mapping, "a frame, or arrays by the names of columns")
    arrays = {
        str(key): list(checked(f"{name}[{key!r}]", columns[key], Iterable, "an array"))
        for key in columns
    }
    if len({len(values) for values in arrays.values()}) > 1:
        lengths = ", ".join(f"{key} has {len(values)}" for key, values in arrays.items())
        raise ValueError(f"{name}: got {lengths} values; expected as many of each column")
    table = io.StringIO()
    rows = zip(*arrays.values(), strict=True)
    csv.writer(table, lineterminator="\n").writerows([list(arrays), *rows])
    return table.getvalue().encode()


def _source(
    name: str,
    text: str,
    overrides: list[str],
    folder: str,
    files: dict[str, bytes] | None = None,
) -> _engine.Source:
    """A case that looks in `folder` for files that it names and that are not in `files`."""
    return _engine.Source.of_text(
        checked_text("name", name), checked_text("text", text), overrides, folder, files
    )


def _history_of(resolved: Record) -> dict[str, bytes] | None:
    """The history that a resolved case names, where arrays gave it: no file has it."""
    case = getattr(resolved._owner, "_case", None)
    content = None if case is None else (case._case.source.files or {}).get(_HISTORY)
    if content is None:
        return None
    return {resolved["life"]["history"]["file"]: content}


def _preload_responses(record: Record, path: str) -> Iterator[dict[str, Any]]:
    """The numbers of a preload, with their paths."""
    for name, value in record.items():
        place = f"{path}.{name}"
        if isinstance(value, Record):
            yield from _preload_responses(value, place)
        elif isinstance(value, list):
            for k, each in enumerate(value):
                if isinstance(each, Record):
                    yield from _preload_responses(each, f"{place}[{k}]")
        elif isinstance(value, int | float) and not isinstance(value, bool):
            title, unit = _engine.response_title(place)
            row = {"path": place, "unit": unit, "title": title, "loads": "at rest"}
            yield {**row, "defined": True, "needs": ""}


def _loads_of_response(result: Result, path: str) -> str:
    """`at rest` or `running`, of what rests on thread loads."""
    block = path.partition(".")[0]
    if block in ("life", "preload"):
        return in_words(result[block].get("thread_loads", ""))
    return "" if block in result else in_words(result["load_cases"][0].get("loads", ""))


_STEP = re.compile(r"\.?([^.\[\]]+)|\[([^\[\]]+)\]")


def _steps(path: str) -> list[str]:
    """`load_cases[0].axial_force` -> `load_cases`, `0`, `axial_force`."""
    if not isinstance(path, str):
        raise TypeError(f"path: got {path!r}; expected a text such as 'mechanism.lead'")
    found = list(_STEP.finditer(path))
    if not found or "".join(each.group(0) for each in found) != path:
        raise KeyError(f"{path!r}; expected a path such as 'load_cases[0].axial_force'")
    return [each.group(1) or each.group(2) for each in found]


def _there(value: Any) -> str:
    """What a path may go on with."""
    if isinstance(value, dict):
        return f"; there is {', '.join(value)}"
    if isinstance(value, list):
        names = [str(each.get("name", k)) for k, each in enumerate(value) if isinstance(each, dict)]
        return f"; there are {len(value)} entries" + (f", {', '.join(names)}" if names else "")
    return f", which is {reprlib.repr(value)}"


def _place(entries: list[Any], step: str) -> int:
    """The place of an entry by its number or its name."""
    if step.isdigit():
        return int(step)
    names = [entry.get("name") if isinstance(entry, dict) else None for entry in entries]
    return names.index(step) if step in names else len(entries)


def _folder(name: str) -> str:
    return os.path.abspath(os.path.dirname(checked_text("name", name)))


def _file_name(file: str | os.PathLike[str], what: str = "file") -> str:
    name = checked_text(what, os.fspath(checked(what, file, str | os.PathLike, "a path")))
    if "\0" in name:
        raise ValueError(f"{what}: got {name!r}; expected a path without the character NUL")
    return name


W = TypeVar("W")


def _written(write: Callable[[], W]) -> W:
    """What the engine returns that writes a file; what the system refuses is an OSError."""
    try:
        return write()
    except RuntimeError as error:
        text = str(error)
        if not text.startswith("cannot write "):
            raise
        codes = [code for code in errno.errorcode if text.endswith(f": {os.strerror(code)}")]
        raise OSError(*codes[:1], text) from None


def _overrides(values: Mapping[str, Any]) -> list[str]:
    if not isinstance(values, Mapping):
        raise TypeError(
            f"set: got {reprlib.repr(values)}; expected a dictionary such as "
            "{'mechanism.rollers': 9}"
        )
    return [f"{checked_text('path', path)}={override_text(item)}" for path, item in values.items()]


def explore(case: Case, file: str | os.PathLike[str] | None = None) -> Path:
    """Writes the live page of a case and opens it in the browser: `Case.explore`."""
    checked("case", case, Case, "a Case")
    return case.explore(file)
