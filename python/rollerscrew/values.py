"""Python values as the texts that a case consists of."""

from __future__ import annotations

import json
import math
import operator
import re
import reprlib
from collections.abc import Mapping
from typing import Any

import numpy as np

from rollerscrew import _engine

#: SI units of every dimension that cases know, for quantities in a unit that they do not.
_SI_UNITS = (
    "m", "N", "Pa", "kg/m^3", "Pa s", "m^2/s", "1/Pa", "N/m^1.5", "N/m", "N m", "s", "K", "1/K",
    "rad/s", "rad", "kg", "m/s", "kg m^2", "Hz", "N s/m", "N m s/rad", "s/m", "W", "N m/A",
    "ohm", "V", "A", "W/K", "W/(m K)", "J/K", "J/(kg K)",
)  # fmt: skip

#: Case files nest at most so many levels.
_MOST_LEVELS = 64

#: No number of a case needs more digits.
_MOST_DIGITS = 400

#: Whole numbers below it are exact as floats.
_MOST_EXACT = 2**53

#: Texts that files write without quotes: `45 kN`, `3.6e5 N/mm^1.5`.
_QUANTITY = re.compile(r"[-+]?[0-9.][-+0-9.eE]* [A-Za-zµ°%1][A-Za-z0-9µ°%/^. ]*")

#: Words that files write without quotes: `bars`, `mechanism.rollers`, ..
_WORD = re.compile(r"[A-Za-z][A-Za-z0-9_.-]*")

#: .. but for those that YAML takes for something else.
_NO_WORDS = {"null", "true", "false", "yes", "no", "on", "off", "y", "n", "nan", "inf"}


def is_quantity(value: Any) -> bool:
    """Of pint, which need not be installed."""
    return hasattr(value, "magnitude") and hasattr(value, "units") and hasattr(value, "to")


def checked_text(what: str, text: Any) -> str:
    """The text, as one that UTF-8 can hold."""
    checked(what, text, str, "a text")
    try:
        text.encode()
    except UnicodeEncodeError as error:
        raise ValueError(
            f"{what}: got half of a character, {text[error.start]!a}, at place {error.start}; "
            "expected text that can be written in UTF-8"
        ) from None
    return str.__str__(text)


def checked(what: str, value: Any, kind: Any, expected: str) -> Any:
    """The value of an argument, which is of a kind."""
    if not isinstance(value, kind):
        raise TypeError(f"{what}: got {reprlib.repr(value)}; expected {expected}")
    return value


def place_among(count: int, what: str, place: Any) -> int:
    """A place among so many, from 0, or from -1 backwards."""
    if not hasattr(place, "__index__"):
        raise TypeError(f"{what}: got {reprlib.repr(place)}; expected a place, counted from 0")
    index = operator.index(place)
    if not -count <= index < count:
        raise IndexError(f"{what}: got {place}; there are {count}, counted from 0")
    return range(count)[index]


def number_text(number: float) -> str:
    """With the fewest digits that read back to the same number."""
    if math.isnan(number):
        return ".nan"
    if math.isinf(number):
        return ".inf" if number > 0 else "-.inf"
    return float.__repr__(number)


def _is_rotation(quantity: Any) -> bool:
    """Whether an angle is in it: pint holds that of 10 Hz and 10 rad/s to be the same."""
    return "radian" in str(quantity.to_root_units().units)


def unit_and_magnitude(quantity: Any) -> tuple[str, Any]:
    """A unit that cases know, and the magnitude of a pint quantity in it; `` for a bare number."""
    if quantity.dimensionless and not _is_rotation(quantity):
        return "", quantity.to("dimensionless").magnitude
    written = f"{quantity.units:~C}".replace("**", "^").replace("*", " ").replace("°", "deg")
    if "/" in written:  # A difference only ever stands below: 1/K.
        written = written.replace("Δdeg", "")
    if _engine.knows_unit(written):
        return written, quantity.magnitude
    if str(quantity.units).startswith("delta_"):
        return written, quantity.magnitude  # A difference is no temperature.
    for unit in _SI_UNITS:
        pint_unit = unit.replace("^", "**").replace(" ", "*").replace("K", "kelvin")
        if unit.startswith("rad") and not _is_rotation(quantity):
            continue
        if quantity.is_compatible_with(pint_unit):
            return unit, quantity.to(pint_unit).magnitude
    return written, quantity.magnitude


def plain(value: Any, level: int = 0) -> Any:
    """Numbers, texts, lists and dictionaries; quantities become texts such as `45 kN`."""
    if level > _MOST_LEVELS:
        raise ValueError(
            f"got lists or dictionaries that are nested more than {_MOST_LEVELS} levels deep, or "
            "contain themselves; expected what a case file could hold"
        )
    if is_with_unit(value):
        return _texts_with_unit(*value)
    if is_quantity(value):
        unit, magnitude = unit_and_magnitude(value)
        if np.ndim(magnitude) > 0:
            return [
                plain(type(value)(item, value.units), level + 1)
                for item in np.asarray(value.magnitude)
            ]
        number = number_text(float(magnitude))
        return f"{number} {unit}" if unit else float(magnitude)
    if isinstance(value, np.floating):
        return float(value)
    if isinstance(value, np.ndarray | np.bool_ | np.integer | np.str_):
        return plain(value.tolist(), level + 1)
    if isinstance(value, Mapping):
        items = {_plain_key(key): plain(item, level + 1) for key, item in value.items()}
        for limit in ("at_most", "at_least") if "response" in items else ():
            if isinstance(items.get(limit), str):
                items[limit] = _in_unit_of(items["response"], items[limit])
        return items
    if isinstance(value, list | tuple):
        return [plain(item, level + 1) for item in value]
    if value is None or isinstance(value, bool):
        return value
    if isinstance(value, int):
        return _plain_int(value)
    if isinstance(value, float):
        return float(value)
    if isinstance(value, str):
        return checked_text("value", value)
    raise TypeError(
        f"got {reprlib.repr(value)} of type {type(value).__name__}; expected a number, a text with "
        "its unit such as '45 kN', a pint quantity, or lists and dictionaries of them"
    )


def _in_unit_of(response: Any, text: str) -> Any:
    """`4 GPa` as the number that limits of a response are, in its own unit: 4000 of MPa."""
    if not isinstance(response, str):
        return text
    number = _engine.number_in(text, _engine.response_title(response)[1])
    return text if number is None else number


def is_with_unit(value: Any) -> bool:
    """A number, or numbers, and their unit: `(5, "mm")`; without one `(9, "")`."""
    if not (isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str)):
        return False
    is_unit = not value[1] or _engine.knows_unit(value[1])
    return is_unit and not isinstance(value[0], str | bool | Mapping)


def _texts_with_unit(numbers: Any, unit: str) -> Any:
    """`5 mm`, or a list of such texts."""
    array = np.asarray(numbers)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"got {reprlib.repr(numbers)} with the unit {unit!r}; expected numbers")
    if not unit:
        return plain(array.tolist())
    if array.ndim > 0:
        return [_texts_with_unit(number, unit) for number in array]
    if array.dtype.kind in "iu":
        return f"{int(array)} {unit}"
    return f"{number_text(float(array))} {unit}"


def _plain_key(key: Any) -> str:
    if not isinstance(key, str):
        raise TypeError(f"got the key {reprlib.repr(key)}; expected texts such as 'mechanism'")
    return checked_text("key", key)


def _plain_int(number: int) -> int:
    if abs(number) >= 10**_MOST_DIGITS:
        raise ValueError(f"got a whole number of more than {_MOST_DIGITS} digits")
    return int(number)


def override_text(value: Any) -> str:
    """What `--set PATH=` takes: texts as they are, everything else in the flow style of YAML."""
    value = plain(value)
    return value if isinstance(value, str) else _flow(value)


def _flow(value: Any) -> str:
    if isinstance(value, bool) or value is None or isinstance(value, int):
        return json.dumps(value)
    if isinstance(value, float):
        is_whole = value.is_integer() and abs(value) < _MOST_EXACT and value != 0.0
        return str(int(value)) if is_whole else number_text(value)  # Counts take `9`, not `9.0`.
    if isinstance(value, str):
        return value if _is_plain_text(value) else json.dumps(value, ensure_ascii=False)
    if isinstance(value, list):
        return "[" + ", ".join(map(_flow, value)) + "]"
    return "{" + ", ".join(f"{_flow(key)}: {_flow(item)}" for key, item in value.items()) + "}"


def _is_plain_text(text: str) -> bool:
    if _QUANTITY.fullmatch(text):
        return True
    return len(text) <= 100 and bool(_WORD.fullmatch(text)) and text.lower() not in _NO_WORDS


def case_text(blocks: Mapping[str, Any]) -> str:
    """The YAML text of a case, one line per value, so that messages can name the line."""
    return _block(plain(blocks), 0) or "{}\n"


def _block(value: Any, depth: int) -> str:
    margin = "  " * depth
    if isinstance(value, dict) and value:
        lines = []
        for key, item in value.items():
            if isinstance(item, dict) and item:
                lines.append(f"{margin}{_flow(key)}:\n{_block(item, depth + 1)}")
            else:
                lines.append(f"{margin}{_flow(key)}: {_flow(item)}\n")
        return "".join(lines)
    return ""
