"""What comes with the package: cases to begin with, lists to choose from.

All but the lists of units and lubricants are answers of the program `prs`, which stands in the
package; the environment variable PRS_EXECUTABLE names another one.
"""

from __future__ import annotations

import json
import os
import re
import reprlib
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, get_args

import numpy as np

from rollerscrew import _engine
from rollerscrew.case import Case
from rollerscrew.errors import InputError
from rollerscrew.values import is_quantity, is_with_unit, override_text

if TYPE_CHECKING:
    import pandas as pd

Type = Literal["standard", "inverted", "recirculating"]

#: A number with its unit: `"25 mm"`, `(25, "mm")` or a quantity of pint.
Length = Any


def new(
    type: Type = "standard",
    screw_diameter: Length | None = None,
    lead: Length | None = None,
    *,
    starts: int | None = None,
    rollers: int | None = None,
    nut_diameter: Length | None = None,
    nut_length: Length | None = None,
    roller_diameter: Length | None = None,
    roller_profile_radius: Length | None = None,
    load: Any | None = None,
    speed: Any | None = None,
    lubricant: str | None = None,
    temperature: Any | None = None,
    mechanism: Literal["sector", "full"] | None = None,
) -> Case:
    """A complete case of a screw, of which little need be known, as `prs new` writes it.

    >>> rs.new("standard", screw_diameter="25 mm", lead="5 mm")

    Without diameter and lead it is an example. What is not given follows by rule: `case.inputs()`
    has every value with what it rests on, `case.text` says it in comments, `case.to_yaml(file)`
    writes it. Raises InputError where nothing can have these numbers.

    Parameters
    ----------
    type : {"standard", "inverted", "recirculating"}, optional
        Rollers that keep their place on the nut, on the screw, or with grooves, led back.
    screw_diameter, lead, nut_diameter, nut_length : length, optional
        `"25 mm"`, `(25, "mm")` or a quantity of pint.
    roller_diameter, roller_profile_radius : length, optional
        The diameter for recirculating screws only.
    starts, rollers : int, optional
        Starts of the screw; rollers around it.
    load, speed, temperature : optional
        A force, a speed of rotation, a temperature of the lubricant, each with its unit.
    lubricant : str, optional
        A name of `lubricants()`.
    mechanism : {"sector", "full"}, optional
        One roller with its share, or all of them.

    Returns
    -------
    Case
    """
    given = dict(locals())
    if type not in get_args(Type):
        known = ", ".join(get_args(Type))
        raise InputError(f"type: got {reprlib.repr(type)}; expected one of {known}")
    options: list[str] = []
    for name, value in given.items():
        if name != "type" and value is not None:
            options += ["--" + name.replace("_", "-"), _option_text(name, value)]
    sizes = [override_text(each) for each in (screw_diameter, lead) if each is not None]
    name = f"<{type} {' x '.join(sizes)}>" if sizes else f"<new {type}>"
    return Case.from_text(_answer("new", type, "-", *options), name=name)


def lesson(which: int | str) -> Case:
    """A lesson by its number or its name: `lesson(4)`, `lesson("flight_spectrum")`.

    Parameters
    ----------
    which : int or str
        Number or name.

    Returns
    -------
    Case

    Raises
    ------
    InputError
        Where there is no such lesson.
    """
    asked = str(which).removesuffix(".yaml")
    for name in lessons():
        number, _, word = name.partition("_")
        if asked in (name, word) or (asked.isdigit() and int(asked) == int(number)):
            return Case.from_yaml(_shared("lessons") / f"{name}.yaml")
    raise InputError(
        f"lesson: got {which!r}; expected the number or the name of a lesson that is a case, "
        "listed by `rollerscrew.lessons()`"
    )


def lessons() -> dict[str, str]:
    """Names of the lessons that are cases, each with what it is about."""
    found = {}
    for file in sorted(_shared("lessons").glob("[0-9]*.yaml")):
        text = file.read_text(encoding="utf-8")
        if "\nmechanism:" in text:
            title = text.partition("\n")[0]
            found[file.stem] = title.partition(": ")[2].strip().removesuffix(".")
    return found


def units() -> pd.DataFrame:
    """Units of the input, one row per quantity."""
    from rollerscrew.frames import frame_of

    quantities = json.loads(_engine.units())["quantities"]
    return frame_of(
        {
            "quantity": each["quantity"],
            "example": each["example"],
            "units": ", ".join(" = ".join(spellings) for spellings in each["units"] if spellings),
        }
        for each in quantities
    )


def lubricants() -> pd.DataFrame:
    """Lubricants that are known by name, with their source."""
    from rollerscrew.frames import frame_of

    return frame_of(json.loads(_engine.lubricants())["lubricants"])


def configurations(
    screw_diameter: Length | None = None,
    lead: Length | None = None,
    *,
    nut_diameter: Length | None = None,
    type: Type | None = None,
    starts: int | None = None,
    roller_starts: int | None = None,
    rollers: int | None = None,
    gap: Length | None = None,
    flank_angle: Any | None = None,
    roller_profile_radius: Length | None = None,
) -> pd.DataFrame:
    """The geometries that a diameter and a lead allow, one row each: `prs configurations`.

    Parameters
    ----------
    screw_diameter, lead, nut_diameter, gap, roller_profile_radius : length
        `"25 mm"`, `(25, "mm")` or a quantity of pint; lead and one diameter are needed.
    type : {"standard", "inverted", "recirculating"}, optional
        All without it.
    starts, roller_starts, rollers : int, optional
        All that fit without them.
    flank_angle : angle, optional
        45 deg without it.

    Returns
    -------
    pandas.DataFrame

    Raises
    ------
    InputError
        Where nothing can have these numbers.
    """
    from rollerscrew.frames import frame_of

    given = dict(locals())
    given.pop("frame_of")
    options: list[str] = []
    for name, value in given.items():
        if value is not None:
            options += ["--" + name.replace("_", "-"), _option_text(name, value)]
    document = json.loads(_answer("configurations", "--json", *options))
    return frame_of(_flat(each) for each in document["configurations"])


def _flat(values: dict[str, Any], before: str = "") -> dict[str, Any]:
    flat: dict[str, Any] = {}
    for name, value in values.items():
        if isinstance(value, dict):
            flat |= _flat(value, f"{before}{name}_")
        elif not isinstance(value, list):
            flat[before + name] = value
    return flat


def _option_text(name: str, value: Any) -> str:
    is_number = isinstance(value, int | float | np.number)
    if isinstance(value, str) or is_number or is_quantity(value) or is_with_unit(value):
        return override_text(value)
    raise TypeError(f"{name}: got {value!r}; expected a number with its unit, such as '25 mm'")


def _program() -> Path:
    told = os.environ.get("PRS_EXECUTABLE")
    if told:
        return Path(told)
    from rollerscrew_cli import program

    return program()


def _answer(*arguments: str) -> str:
    """What the program prints; what it refuses is an InputError."""
    import subprocess

    run = subprocess.run(
        [_program(), *arguments], capture_output=True, encoding="utf-8", check=False
    )
    if run.returncode == 0:
        return run.stdout
    refused = run.stderr.strip().removeprefix("prs: error: ")
    if run.returncode == 2:
        raise InputError(_as_arguments(refused))
    raise RuntimeError(refused or f"prs ended with the status {run.returncode}")


def _as_arguments(text: str) -> str:
    """What the program says of its options, as an error of Python's arguments."""
    text = re.sub(r"; see `prs help \w+`", "", text)
    text = re.sub(r"; expected `prs [^`]*`", "; expected it as an argument", text)
    text = text.replace("`prs list lubricants`", "`rollerscrew.lubricants()`")
    text = text.replace("TYPE: ", "type: ").replace(", then the FILE", "")
    text = re.sub(r'`--([a-z-]+) "', lambda found: f'`{found[1].replace("-", "_")}="', text)
    return re.sub(r"(?<!got )--([a-z][a-z-]*)", lambda found: found[1].replace("-", "_"), text)


def _shared(name: str) -> Path:
    """A folder of data that comes with the program."""
    own = os.environ.get("PRS_SHARE")
    program = _program().resolve()
    above = program.parent.parent
    for folder in [Path(own)] if own else [above / "share" / "prs", above.parent / "share" / "prs"]:
        if (folder / name).is_dir():
            return folder / name
    raise FileNotFoundError(f"no folder {name!r} in {above / 'share' / 'prs'}; install it again")


def live_parts_folder() -> str:
    """The folder of the engine and the scripts of live pages; empty where there is none."""
    try:
        return str(_shared("web"))
    except FileNotFoundError:
        return ""
