"""Pictures of the design measures."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from rollerscrew.plots._canvas import BLUE, GREY, WIDE, canvas, colours, legend, shown
from rollerscrew.plots._cases import force_text, sweeps

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from rollerscrew.records import LoadCase
    from rollerscrew.results import MeasuresResult

_MOST_CASES = 6
_PARTS = ("screw", "roller", "nut")
_HATCHES = ("", "////", "....", "\\\\\\\\", "xxxx", "----")


def stiffness_terms(result: MeasuresResult, ax: Axes | None = None) -> Axes:
    """Compliances in µm/kN: contacts, teeth, body sections of one pitch, the screw's shaft.

    Contacts depend on the load and have a bar a load case; of a sweep the largest load. Teeth are
    those of all contacts together, the roller's at both interfaces.
    """
    groups = sweeps(result.load_cases, _has_contacts)
    chosen = [group.last for group in groups][:_MOST_CASES]
    named = [f"{shown(case.name, 20)}, {force_text(case)}" for case in chosen]
    if chosen and len({tuple(compliance for _, compliance in _contacts(c)) for c in chosen}) == 1:
        chosen, named = chosen[:1], ["all load cases"]
    bars: list[tuple[str, list[float]]] = []
    for side in ("screw", "nut"):
        found = [dict(_contacts(case)) for case in chosen]
        known = [each[side] for each in found if side in each]
        if known and len(known) == len(chosen):
            bars.append((f"contacts, {'screw–roller' if side == 'screw' else 'roller–nut'}", known))
    bars += [(name, [value]) for name, value in _of_bodies(result, chosen)]
    if not bars:
        raise ValueError("no stiffness among the measures: expected loads, structure or `shaft`")
    with canvas(ax, WIDE, 12.0 + 5.0 * len(bars) * max(1.0, 0.6 * len(chosen))) as on:
        palette = [*colours(len(chosen)), GREY] if len(chosen) > 1 else [BLUE]
        widest = max(max(values) for _, values in bars)
        thick = 0.76 / max(len(chosen), 1)
        handles: list[Artist] = []
        ticks = []
        for place, (_, values) in enumerate(bars):
            offsets = (np.arange(len(values)) - 0.5 * (len(values) - 1)) * thick
            of_cases = len(values) == len(chosen) and place < 2
            for k, (offset, value) in enumerate(zip(offsets, values, strict=True)):
                drawn = on.ax.barh(
                    place + offset,
                    value,
                    thick if of_cases else 0.6,
                    color=palette[k if of_cases else -1],
                    hatch=_HATCHES[k] if of_cases else "",
                    edgecolor="black",
                    linewidth=0.4,
                    label=named[k] if of_cases else "_",
                )
                if of_cases and place == 0:
                    handles.append(drawn)  # type: ignore[arg-type]
                on.ax.text(
                    value + 0.01 * widest, place + offset, f"{value:.3g}", va="center", fontsize=6.5
                )
            ticks.append(place)
        on.ax.set_yticks(ticks, [name for name, _ in bars])
        on.ax.tick_params(axis="y", length=0)
        on.ax.invert_yaxis()
        on.ax.set_xlim(0.0, 1.12 * widest)
        on.ax.set_xlabel("Compliance (µm/kN)")
        legend(on, handles if len(handles) > 1 else [])
        return on.ax


def _has_contacts(case: LoadCase) -> bool:
    return "measures" in case and any(True for _ in _contacts(case))


def _contacts(case: LoadCase) -> Iterator[tuple[str, float]]:
    """Compliance of all contacts of an interface together."""
    for side in ("screw", "nut"):
        stiffness = case.measures.get(f"hertz_stiffness_{side}_N_per_um")
        if stiffness:
            yield side, 1e3 / stiffness


def _of_bodies(result: MeasuresResult, cases: list[LoadCase]) -> Iterator[tuple[str, float]]:
    measures = result.measures
    for part in _PARTS:
        stiffness = measures.get(f"tooth_stiffness_{part}_N_per_um")
        contacts = _contact_count(cases)
        if stiffness and contacts:
            times = 2.0 if part == "roller" else 1.0
            yield f"teeth, {part}", 1e3 * times / (stiffness * contacts)
    for part in _PARTS:
        stiffness = measures.get(f"section_stiffness_{part}_N_per_um")
        if stiffness:
            what = "rollers" if part == "roller" else part
            yield f"body over one pitch, {what}", 1e3 / stiffness
    if stiffness := measures.get("shaft_stiffness_N_per_um"):
        yield "shaft of the screw", 1e3 / stiffness


def _contact_count(cases: list[LoadCase]) -> float:
    """Rollers times contacts of each, from what the threads of one roller carry."""
    for case in cases:
        if "screw" in case:
            carried = case.screw.axial_load_N
            return abs(case.axial_force_N) / float(abs(carried.sum())) * len(carried)
    return 0.0


__all__ = ["stiffness_terms"]
