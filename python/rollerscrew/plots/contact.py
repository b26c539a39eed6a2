"""Pictures of the contacts: where they lie, how large their ellipses are."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from rollerscrew.plots._canvas import (
    BLUE,
    DASHES,
    GREEN,
    GREY,
    REFERENCE,
    SINGLE,
    VERMILLION,
    WIDE,
    Canvas,
    canvas,
    colour_bar,
    legend,
    numbers,
    width_of,
)
from rollerscrew.plots._cases import INTERFACES, loads_of, require_loads

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rollerscrew.records import Contacts, InterfaceLoads, LoadCase

_PARTS = {"screw": BLUE, "roller": GREY, "nut": GREEN}
_MOST_IN_A_ROW = 24
_LEAST_STEP_MM = 5.0  # So that the numbers of threads have room.
_SCALE_BARS_MM = (0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0)


def contact_points(contact: Contacts, ax: Axes | None = None) -> Axes:
    """Pitch circles of screw, one roller and nut seen along the axis in mm, with the contacts.

    The legend gives each contact's radius and angle on the screw or nut, and on the roller.
    """
    missing = [side for side in INTERFACES if "radius_on_body_mm" not in contact[side]]
    if missing:
        raise ValueError(f"there is no contact point at the {' and the '.join(missing)}")
    centre = contact.centre_distance_mm
    radii = {part: 0.5 * contact.pitch_diameter_mm[part] for part in _PARTS}
    reach = max(radii["nut"], centre + radii["roller"])
    half = 1.14 * radii["roller"]
    left = float(np.sqrt(max(radii["screw"] ** 2 - half**2, 0.0))) - 0.5 * radii["roller"]
    right = reach + 0.14 * radii["roller"]
    # Labels take about 13 mm of the width and 13 mm of the height.
    with canvas(ax, SINGLE, (SINGLE - 13.0) * 2.0 * half / (right - left) + 13.0) as on:
        axes = on.ax
        turn = np.linspace(0.0, 2.0 * np.pi, 721)
        for part, colour in _PARTS.items():
            middle = centre if part == "roller" else 0.0
            axes.plot(
                middle + radii[part] * np.cos(turn),
                radii[part] * np.sin(turn),
                color=colour,
                linestyle=DASHES[3],
                linewidth=0.9,
                label=f"pitch circle, {part}",
            )
        axes.axhline(0.0, **REFERENCE)
        axes.plot([centre], [0.0], marker="+", color="black", markersize=5, label="roller axis")
        marks = []
        for side, marker, colour in (("screw", "o", VERMILLION), ("nut", "s", VERMILLION)):
            x, y = _contact_point(contact, side)
            for start in (0.0, centre):
                axes.plot([start, x], [0.0, y], color="black", linewidth=0.5, zorder=1.5)
            point = contact[side]
            marks += axes.plot(
                [x],
                [y],
                marker=marker,
                linestyle="none",
                color=colour,
                markerfacecolor=colour if side == "screw" else "white",
                zorder=3,
                label=(
                    f"contact with the {side}\n"
                    f"{side}: {_polar(point.radius_on_body_mm, point.angle_on_body_deg)}\n"
                    f"roller: {_polar(point.radius_on_roller_mm, point.angle_on_roller_deg)}"
                ),
            )
        _label_parts(on, centre, radii, half)
        axes.set_aspect("equal", anchor="N")
        axes.set_xlim(left, right)
        axes.set_ylim(-half, half)
        axes.set_xlabel("x, from the screw axis to the roller axis (mm)")
        axes.set_ylabel("y (mm)")
        if on.own:
            legend(on, marks, columns=2, handlelength=1.0, columnspacing=0.8)
        else:
            axes.legend(
                marks,
                [f"contact with the {side}" for side in INTERFACES],
                loc="center",
                bbox_to_anchor=(centre, -0.5 * radii["roller"]),
                bbox_transform=axes.transData,
                framealpha=0.8,
            )
        return axes


def _contact_point(contact: Contacts, side: str) -> tuple[float, float]:
    angle = np.radians(contact[side].angle_on_body_deg)
    radius = contact[side].radius_on_body_mm
    return float(radius * np.cos(angle)), float(radius * np.sin(angle))


def _polar(radius_mm: float, angle_deg: float) -> str:
    turned = (angle_deg + 180.0) % 360.0 - 180.0 + 0.0
    angle = f"{abs(turned) if abs(turned) < 5e-3 else turned:.2f}°".replace("-", "−")
    return f"{radius_mm:.3f} mm, {angle}"


def _label_parts(on: Canvas, centre: float, radii: dict[str, float], half: float) -> None:
    """Names the circles beside them, where they leave the picture."""
    low = -0.93 * half
    for part, side in (("screw", "right"), ("nut", "left")):
        x = float(np.sqrt(max(radii[part] ** 2 - low**2, 0.0)))
        gap = 0.05 * radii["roller"] * (1.0 if side == "left" else -1.0)
        on.ax.text(x + gap, low, part, color=_PARTS[part], ha=side, va="center")
    on.ax.text(centre, 0.45 * radii["roller"], "roller", color="#555555", ha="center", va="center")


def ellipses(load_case: LoadCase, ax: Axes | None = None) -> Axes:
    """Contact ellipses of all threads to scale in mm, screw above nut, major axes horizontal.

    Colours are peak pressures in MPa. Many threads are wrapped into several rows.
    """
    require_loads([load_case])
    sides = [side for side in INTERFACES if "semi_major_mm" in loads_of(load_case, side)]
    if not sides:
        raise ValueError(
            f"load case {load_case.name!r} has no contact ellipses: its contacts are given by "
            "Hertz constants and angles alone"
        )
    loads = {side: loads_of(load_case, side) for side in sides}
    threads = max(len(each.semi_major_mm) for each in loads.values())
    most = _MOST_IN_A_ROW if ax is None else max(4, int(width_of(ax) / _LEAST_STEP_MM))
    per_row = -(-threads // -(-threads // most))
    rows = -(-threads // per_row)
    major = max(float(np.nanmax(numbers(each.semi_major_mm))) for each in loads.values())
    minor = max(float(np.nanmax(numbers(each.semi_minor_mm))) for each in loads.values())
    if not major > 0.0:
        raise ValueError(f"no thread of load case {load_case.name!r} carries load")
    step, height = 2.25 * major, 2.0 * minor + 1.3 * major
    width = per_row * step
    ups = {side: -place * (rows + 0.3) * height for place, side in enumerate(sides)}
    lowest = min(ups.values()) - (rows - 1) * height - minor
    top, bottom = minor + 0.9 * major, lowest - 1.4 * major
    # Labels and margins take about 14 mm of the width, the colour bar 13 mm of the height.
    with canvas(ax, WIDE, (WIDE - 14.0) * (top - bottom) / width + 13.0) as on:
        _draw_ellipses(on, loads, ups, per_row, (step, height), minor + 0.42 * major)
        _scale_bar(on, major, width - 0.5 * step, lowest - 0.85 * major)
        on.ax.set_aspect("equal")
        on.ax.set_xlim(-0.5 * step, width - 0.5 * step)
        on.ax.set_ylim(bottom, top)
        on.ax.set_xticks([])
        on.ax.set_yticks([up - 0.5 * (rows - 1) * height for up in ups.values()], sides)
        on.ax.tick_params(length=0)
        for spine in on.ax.spines.values():
            spine.set_visible(False)
        return on.ax


def _draw_ellipses(
    on: Canvas,
    loads: dict[str, InterfaceLoads],
    ups: dict[str, float],
    per_row: int,
    spacing: tuple[float, float],
    number_at: float,
) -> None:
    from matplotlib.collections import PatchCollection
    from matplotlib.patches import Ellipse

    patches, values = [], []
    step, height = spacing
    for side, each in loads.items():
        sizes = zip(numbers(each.semi_major_mm), numbers(each.semi_minor_mm), strict=True)
        for thread, (a, b) in enumerate(sizes):
            x = (thread % per_row) * step
            y = ups[side] - (thread // per_row) * height
            patches.append(Ellipse((x, y), 2.0 * a, 2.0 * b, label=f"{side}, thread {thread + 1}"))
            on.ax.text(x, y + number_at, str(thread + 1), ha="center", va="center", fontsize=6)
        values.append(numbers(each.peak_pressure_MPa))
    collection = PatchCollection(patches, cmap="viridis", edgecolor="black", linewidth=0.3)
    collection.set_array(np.concatenate(values))
    on.ax.add_collection(collection)
    colour_bar(
        on, collection, "Peak pressure (MPa)", location="bottom", shrink=0.5, pad=0.02, aspect=30
    )


def _scale_bar(on: Canvas, major: float, right: float, y: float) -> None:
    length = max((bar for bar in _SCALE_BARS_MM if bar <= 2.0 * major), default=_SCALE_BARS_MM[0])
    left = right - length - 0.12 * major
    on.ax.plot([left, left + length], [y, y], color="black", linewidth=1.6, solid_capstyle="butt")
    on.ax.text(left - 0.25 * major, y, f"{length:g} mm", ha="right", va="center", fontsize=7)


__all__ = ["contact_points", "ellipses"]
