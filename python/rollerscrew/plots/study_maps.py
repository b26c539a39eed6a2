"""Pictures of studies: maps over two factors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from rollerscrew.plots._canvas import (
    VERMILLION,
    Canvas,
    canvas,
    colour_bar,
    figure_of,
    framed,
    legend,
    note,
    numbers,
    shown,
)
from rollerscrew.plots._designs import Input, hold, inputs_of, is_geometric
from rollerscrew.plots._names import response_name
from rollerscrew.plots._responses import (
    response_values,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rollerscrew.results import StudyResult

_MOST_DOTS = 400


def study_map(
    result: StudyResult,
    response: str | None = None,
    x: str | None = None,
    y: str | None = None,
    ax: Axes | None = None,
) -> Axes:
    """A response of a grid over two numeric inputs, as filled contours.

    Without `x` and `y` the two with most values. Other factors are held at the file's value or,
    where the grid does not have it, at the nearest one; the title names them.
    """
    if result.study.plan != "grid":
        raise ValueError(
            f"a map needs `plan: grid` with two factors of numbers; this is {result.study.plan}"
        )
    chosen, values = response_values(result, response)
    inputs = inputs_of(result)
    rows = np.arange(1, len(values))
    across, up = _map_axes(inputs, rows, x, y)
    held = [
        each
        for each in inputs
        if each.is_factor
        and each.factor not in (across.factor, up.factor)
        and len(each.levels(rows)) > 1
    ]
    rows, notes = hold(held, rows)
    at_x, at_y = across.levels(rows), up.levels(rows)
    grid = np.full((len(at_y), len(at_x)), np.nan)
    places = (np.searchsorted(at_y, up.values[rows]), np.searchsorted(at_x, across.values[rows]))
    grid[places] = values[rows]
    return _contours(grid, across, up, at_x, at_y, response_name(chosen).label, notes, ax)


def _map_axes(
    inputs: list[Input], rows: npt.NDArray[np.int_], x: str | None, y: str | None
) -> tuple[Input, Input]:
    usable = [each for each in inputs if each.is_numeric and len(each.levels(rows)) > 1]
    chosen = [_input_named(usable, name) if name is not None else None for name in (x, y)]
    for place in (0, 1):
        if chosen[place] is not None:
            continue
        other = chosen[1 - place]
        free = [e for e in usable if e.is_factor and (other is None or e.factor != other.factor)]
        if not free or (other is None and len(free) < 2):
            raise ValueError(
                "a map needs two factors of numbers with several values each; there is "
                + (", ".join(each.path for each in usable if each.is_factor) or "none")
            )
        if other is None:
            first, second = sorted(free, key=lambda each: -len(each.levels(rows)))[:2]
            in_order = first.factor < second.factor
            chosen = [first, second] if in_order else [second, first]
        else:
            chosen[place] = max(free, key=lambda each: len(each.levels(rows)))
    across, up = chosen
    assert across is not None and up is not None
    if across.factor == up.factor:
        raise ValueError(f"{across.path} and {up.path} vary together: expected two factors")
    return across, up


def _input_named(usable: list[Input], name: str) -> Input:
    for each in usable:
        if name in (each.path, each.label):
            return each
    known = ", ".join(each.path for each in usable) or "none"
    raise KeyError(f"no factor of numbers {name!r}; there is {known}")


def _contours(
    grid: npt.NDArray[np.float64],
    across: Input,
    up: Input,
    at_x: Sequence[float],
    at_y: Sequence[float],
    label: str,
    notes: list[str],
    ax: Axes | None,
) -> Axes:
    if not np.isfinite(grid).any():
        raise ValueError("no design of the map has an answer")
    from matplotlib.ticker import MaxNLocator

    shown_grid = np.ma.masked_invalid(grid)
    with canvas(ax, height_mm=70.0) as on:
        if np.ptp(shown_grid.compressed()) == 0.0:
            filled: Any = on.ax.pcolormesh(at_x, at_y, shown_grid, shading="nearest")
        else:
            levels = MaxNLocator(10, steps=[1, 2, 2.5, 5, 10]).tick_values(
                shown_grid.min(), shown_grid.max()
            )
            filled = on.ax.contourf(at_x, at_y, shown_grid, levels=levels, cmap="viridis")
            on.ax.contour(
                at_x, at_y, shown_grid, levels=filled.levels, colors="white", linewidths=0.35
            )
        if grid.size <= _MOST_DOTS:
            _dots(on, grid, at_x, at_y)
        for axis, levels in (("x", at_x), ("y", at_y)):
            if is_geometric(levels):
                getattr(on.ax, f"set_{axis}scale")("log")
        on.ax.set_xlim(min(at_x), max(at_x))
        on.ax.set_ylim(min(at_y), max(at_y))
        on.ax.set_xlabel(across.title)
        on.ax.set_ylabel(up.title)
        colour_bar(on, filled, label)
        framed(on)
        note(on, notes)
        return on.ax


def _dots(
    on: Canvas, grid: npt.NDArray[np.float64], at_x: Sequence[float], at_y: Sequence[float]
) -> None:
    """Where designs stand; crosses where they have no answer."""
    x, y = np.meshgrid(at_x, at_y)
    known = np.isfinite(grid)
    on.ax.plot(
        x[known], y[known], ".", color="black", markersize=1.6, markeredgewidth=0.0, clip_on=False,
        label="designs",
    )  # fmt: skip
    if not known.all():
        refused = on.ax.plot(
            x[~known], y[~known], "x", color="#888888", markersize=2.6, markeredgewidth=0.6,
            clip_on=False, label="designs without answer",
        )  # fmt: skip
        if on.own:
            legend(on, refused)
        else:
            on.ax.legend(
                handles=refused, loc="lower right", bbox_to_anchor=(1.0, 1.0), frameon=False
            )


def study_envelope(result: StudyResult, ax: Axes | None = None) -> Axes:
    """The envelope of several measures over two factors, with the points that the study names."""
    if "envelope" not in result:
        raise ValueError("the study has no envelope: expected `study.envelope` in the case")
    envelope = result.envelope
    inputs = {each.path: each for each in inputs_of(result)}
    across, up = (inputs[axis["path"]] for axis in envelope.axes)
    at_x, at_y = (np.asarray(axis["numbers"], dtype=np.float64) for axis in envelope.axes)
    grid = _envelope_values(result, len(at_x), len(at_y)).T
    order_x, order_y = np.argsort(at_x), np.argsort(at_y)
    grid = grid[np.ix_(order_y, order_x)]
    at_x, at_y = at_x[order_x], at_y[order_y]
    ax = _contours(grid, across, up, list(at_x), list(at_y), "Envelope", [], ax)
    marks = {
        str(point.name): (
            float(point.settings[across.path]["number"]),
            float(point.settings[up.path]["number"]),
        )
        for point in envelope.get("points", [])
        if "settings" in point
    }
    for name, at in marks.items():
        ax.plot(
            *at,
            marker="D",
            linestyle="none",
            color=VERMILLION,
            markeredgecolor="white",
            markersize=5.0,
            clip_on=False,
            zorder=5,
            label=shown(name),
        )
    _name_marks(ax, marks)
    return ax


def _name_marks(ax: Axes, marks: dict[str, tuple[float, float]]) -> None:
    """Names beside marks, on the side where they meet no other mark or name, nor leave the axes."""
    point = figure_of(ax).dpi / 72.0  # Pixels.
    places = {name: ax.transData.transform(at) for name, at in marks.items()}
    inside = ax.get_window_extent()
    taken = [(x - 4.0 * point, y - 4.0 * point, x + 4.0 * point, y + 4.0 * point)
             for x, y in places.values()]  # fmt: skip
    for name, (x, y) in places.items():
        text = shown(name, 18)
        wide, high = 4.6 * point * len(text), 10.0 * point
        sides = []
        for right, up in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            left = x + (7.0 * point if right > 0 else -7.0 * point - wide if right else -0.5 * wide)
            low = y + (5.0 * point if up > 0 else -5.0 * point - high if up else -0.5 * high)
            box = (left, low, left + wide, low + high)
            out = max(
                inside.x0 - box[0], box[2] - inside.x1, inside.y0 - box[1], box[3] - inside.y1
            )
            hits = sum(_overlap(box, other) for other in taken)
            sides.append((max(out, 0.0) + 10.0 * point * hits, right, up, box))
        _, right, up, box = min(sides, key=lambda side: side[0])
        taken.append(box)
        ax.annotate(
            text,
            marks[name],
            (6 * right, 5 * up),
            textcoords="offset points",
            fontsize=7.5,
            ha={1: "left", -1: "right", 0: "center"}[right],
            va={1: "bottom", -1: "top", 0: "center"}[up],
            bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "alpha": 0.8, "linewidth": 0},
            zorder=6,
        )


def _overlap(a: tuple[float, ...], b: tuple[float, ...]) -> bool:
    return bool(a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3])


def _envelope_values(result: StudyResult, count_x: int, count_y: int) -> npt.NDArray[np.float64]:
    """Nodes of the first factor x those of the second; documents of large grids leave them out."""
    envelope = result.envelope
    if "values" in envelope:
        return numbers(envelope["values"])
    designs = result.all_designs
    if len(designs) != count_x * count_y + 1:
        raise ValueError(
            "the document holds no envelope values: it leaves out those of large grids"
        )
    product = envelope.combine == "product"
    combined = np.full(len(designs), 1.0 if product else 0.0)
    for measure in envelope.measures:
        relative = designs[measure.response] / measure.normalised_by
        combined = (
            combined * relative**measure.weight if product else combined + measure.weight * relative
        )
    return combined[1:].reshape(count_x, count_y)


__all__ = ["study_envelope", "study_map"]
