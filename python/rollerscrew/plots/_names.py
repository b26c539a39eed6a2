"""Paths of responses and factors as people write them."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from rollerscrew.plots._canvas import sentence, shown

#: How units end names, and how they are written; longer ones before their own ends.
_UNITS = {
    "_N_per_mm1_5": "N/mm^1.5",
    "_mm_per_rad": "mm/rad",
    "_kN_per_kg": "kN/kg",
    "_W_per_mm2": "W/mm²",
    "_N_per_um": "N/µm",
    "_mm_per_s": "mm/s",
    "_kg_per_m": "kg/m",
    "_kg_mm2": "kg mm²",
    "_per_mm": "1/mm",
    "_revolutions": "revolutions",
    "_percent": "%",
    "_hours": "h",
    "_mPas": "mPa s",
    "_Nmm": "N mm",
    "_Nm": "N m",
    "_cm3": "cm³",
    "_MPa": "MPa",
    "_rpm": "rpm",
    "_deg": "deg",
    "_km": "km",
    "_kg": "kg",
    "_mm": "mm",
    "_um": "µm",
    "_nm": "nm",
    "_W": "W",
    "_N": "N",
    "_h": "h",
}
_BLOCKS = ("slip", "contact", "measures", "life")
_PARTS = ("screw", "roller", "nut", "carrier_roller", "carrier_screw", "carrier_nut")
_SUMMARIES = ("max", "min", "mean")
_INDEX = re.compile(r"(?P<name>.*)\[(?P<index>\d+)\]")
_OVER_THREADS = re.compile(r"(slip\.)?(screw|nut)\.")


@dataclass(frozen=True)
class Name:
    """What a response is called, and its unit; empty where it has none."""

    text: str
    unit: str

    @property
    def label(self) -> str:
        """`Axial stiffness (N/µm)`."""
        name = sentence(shown(self.text, 44))
        return f"{name} ({self.unit})" if self.unit else name


def response_name(path: str) -> Name:
    """`max screw peak pressure` in MPa for `screw.peak_pressure_MPa.max`."""
    over_threads = _OVER_THREADS.match(path) is not None
    name, unit = "", ""
    keys = path.split(".")
    for place, key in enumerate(keys):
        key, index = _split_index(key, over_threads)
        key, found = _split_unit(key)
        unit = found or unit
        if key in _BLOCKS and place + 1 < len(keys):
            continue
        leads = key in _PARTS or (key in _SUMMARIES and place + 1 == len(keys))
        name = f"{key}{index} {name}" if leads else f"{name} {key}{index}"
        name = name.strip()
    return Name(name.replace("_", " "), unit)


def _split_index(key: str, over_threads: bool) -> tuple[str, str]:
    found = _INDEX.fullmatch(key)
    if not found:
        return key, ""
    if over_threads:
        return found["name"], f", thread {int(found['index']) + 1}"
    return found["name"], f"[{found['index']}]"


def _split_unit(key: str) -> tuple[str, str]:
    for end, unit in _UNITS.items():
        if key.endswith(end) and key != end:
            return key.removesuffix(end), unit
    return key, ""


def unit_text(unit: str) -> str:
    return re.sub(r"\bu(?=m\b)", "µ", unit)


def path_texts(paths: Iterable[str]) -> list[str]:
    """The last words of each path, as many as tell them apart."""
    split = [re.sub(r"[_]", " ", path).split(".") for path in paths]
    texts = []
    for words in split:
        count = min(2, len(words))
        while count < len(words) and sum(w[-count:] == words[-count:] for w in split) > 1:
            count += 1
        texts.append(" ".join(words[-count:]))
    return texts
