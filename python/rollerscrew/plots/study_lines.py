"""Pictures of studies: a response over the factors."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from rollerscrew.plots._canvas import (
    BLUE,
    COLOURS,
    DASHES,
    MARKERS,
    REFERENCE,
    VERMILLION,
    WIDE,
    Canvas,
    canvas,
    colour_bar,
    key,
    legend,
    note,
    shown,
)
from rollerscrew.plots._designs import Input, hold, inputs_of, is_geometric, owners
from rollerscrew.plots._names import response_name
from rollerscrew.plots._responses import (
    contributions,
    response_values,
)

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.lines import Line2D

    from rollerscrew.results import StudyResult

_MOST_LINES = 6
_MOST_SPIDER_LINES = 12

#: How lines tell the values of the second, third and fourth factor apart.
_LINE_LOOKS: tuple[tuple[str, Sequence[Any]], ...] = (
    ("color", COLOURS[:_MOST_LINES]),
    ("linestyle", DASHES),
    ("marker", MARKERS[:4]),
)


def study_lines(result: StudyResult, response: str | None = None, ax: Axes | None = None) -> Axes:
    """A response over the numeric factor with most values, lines for the values of the others.

    Of a study that varies one of several factors at a time: change of the response over the factors
    relative to the file, both in percent or, where factors vary widely, over their ratio on a
    logarithmic scale. Of a sampled study: the designs over the factor that contributes most.
    """
    chosen, values = response_values(result, response)
    inputs = inputs_of(result)
    factors = [each for each in inputs if each.is_factor]
    if result.study.plan == "grid":
        return _grid_lines(chosen, values, factors, ax)
    if result.study.plan == "one_at_a_time":
        whose = owners(result, inputs)
        if len(factors) == 1:
            return _one_factor(chosen, values, factors[0], ax)
        return _spider(chosen, values, factors, whose, ax)
    return _cloud(result, chosen, values, factors, ax)


def _axis_factor(factors: Sequence[Input], rows: npt.NDArray[np.int_]) -> Input:
    """The numeric factor with most values, the first of several; a factor of words at worst."""
    return max(factors, key=lambda each: (each.is_numeric, len(each.levels(rows))))


def _grid_lines(
    response: str, values: npt.NDArray[np.float64], factors: list[Input], ax: Axes | None
) -> Axes:
    rows = np.arange(1, len(values))
    x = _axis_factor(factors, rows)
    others = [each for each in factors if each is not x and len(each.levels(rows)) > 1]
    others.sort(key=lambda each: -len(each.levels(rows)))
    drawn, held = others[: len(_LINE_LOOKS)], others[len(_LINE_LOOKS) :]
    rows, notes = hold(held, rows)
    levels = [each.levels(rows) for each in drawn]
    scaled = bool(drawn) and drawn[0].is_numeric and len(levels[0]) > _MOST_LINES
    for place, (each, (_, choices)) in enumerate(zip(drawn, _LINE_LOOKS, strict=False)):
        if len(levels[place]) > len(choices) and not (scaled and place == 0):
            notes.append(f"{shown(each.label, 28)}: {len(choices)} of {len(levels[place])} values")
            levels[place] = _spread(levels[place], len(choices))
    with canvas(ax) as on:
        looks = _looks(levels, scaled)
        for combination in itertools.product(*(range(len(each)) for each in levels)):
            style: dict[str, Any] = {} if drawn else {"color": BLUE, "marker": "o"}
            at = rows
            for place, level in enumerate(combination):
                style |= looks[place][level]
                at = at[drawn[place].values[at] == levels[place][level]]
            label = ", ".join(
                drawn[place].text(levels[place][level]) for place, level in enumerate(combination)
            )
            _line_over(on, x, at, values, label or response_name(response).text, style)
        _factor_axis(on, x, rows)
        on.ax.set_ylabel(response_name(response).label)
        handles: list[Artist] = []
        for place, each in enumerate(drawn):
            if scaled and place == 0:
                colour_bar(on, _scale(levels[0]), each.title)
                continue
            for level, look in zip(levels[place], looks[place], strict=True):
                of_marker = place == 2
                entry = {"color": "black", "linestyle": "none" if of_marker else "-", **look}
                handles.append(key(each.text(level), **entry))
        note(on, notes)
        legend(on, handles)
        return on.ax


def _looks(levels: Sequence[Sequence[Any]], scaled: bool) -> list[list[dict[str, Any]]]:
    """What each value of each factor does to a line: its colour, its dashes, its marks."""
    looks: list[list[dict[str, Any]]] = []
    for place, (each, (name, choices)) in enumerate(zip(levels, _LINE_LOOKS, strict=False)):
        if scaled and place == 0:
            scale = _scale(each)
            looks.append([{name: scale.to_rgba(level), "linewidth": 0.9} for level in each])
            continue
        looks.append([{name: choices[k]} for k in range(len(each))])
        if name == "linestyle":
            for look in looks[-1][1:]:
                look["markerfacecolor"] = "white"
    if looks and len(looks) < len(_LINE_LOOKS) and not scaled:
        for k, look in enumerate(looks[0]):
            look["marker"] = MARKERS[k]
    return looks


def _scale(levels: Sequence[float]) -> ScalarMappable:
    """Colours by the values of a factor."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LogNorm, Normalize

    norm = LogNorm if is_geometric(levels) else Normalize
    return ScalarMappable(norm(min(levels), max(levels)), "viridis")


def _line_over(
    on: Canvas,
    x: Input,
    rows: npt.NDArray[np.int_],
    values: npt.NDArray[np.float64],
    label: str,
    style: dict[str, Any],
) -> None:
    """Interrupted where a design has no answer."""
    if x.is_numeric:
        rows = rows[np.argsort(x.values[rows], kind="stable")]
        at = x.values[rows]
    else:
        levels = x.levels(rows)
        at = np.array([levels.index(value) for value in x.values[rows]])
        style = {**style, "linestyle": "none"}
    on.ax.plot(at, values[rows], label=label, **style)


def _factor_axis(on: Canvas, x: Input, rows: npt.NDArray[np.int_]) -> None:
    levels = x.levels(rows)
    on.ax.set_xlabel(x.title)
    if not x.is_numeric:
        on.ax.set_xticks(range(len(levels)), [shown(str(level), 20) for level in levels])
        on.ax.set_xlim(-0.5, len(levels) - 0.5)
    elif is_geometric(levels):
        on.ax.set_xscale("log")
    elif not x.unit and all(level == round(level) for level in levels) and len(levels) <= 15:
        on.ax.set_xticks(levels)


def _base_mark(on: Canvas, x: Input, value: float) -> list[Line2D]:
    """The file's own design; nothing where it has no number or no answer."""
    if not (x.is_numeric and isinstance(x.base, float | int) and np.isfinite(value)):
        return []
    return on.ax.plot(
        [x.base],
        [value],
        marker="D",
        linestyle="none",
        color=VERMILLION,
        markerfacecolor="white",
        markersize=5.0,
        label="as in the file",
    )


def _one_factor(
    response: str, values: npt.NDArray[np.float64], factor: Input, ax: Axes | None
) -> Axes:
    rows = np.arange(1, len(values))
    with canvas(ax) as on:
        style = {"color": BLUE, "marker": "o"}
        _line_over(on, factor, rows, values, response_name(response).text, style)
        _factor_axis(on, factor, rows)
        on.ax.set_ylabel(response_name(response).label)
        legend(on, _base_mark(on, factor, values[0]))
        return on.ax


def _spider(
    response: str,
    values: npt.NDArray[np.float64],
    factors: list[Input],
    whose: npt.NDArray[np.int_],
    ax: Axes | None,
) -> Axes:
    if not np.isfinite(values[0]) or values[0] == 0.0:
        raise ValueError(
            f"{response} of the file as it stands is {'0' if values[0] == 0.0 else 'not known'}: "
            "expected a number that changes can be relative to"
        )
    change = 100.0 * (values / values[0] - 1.0)
    lines, left_out = [], []
    for each in factors:
        rows = np.flatnonzero(whose == each.factor)
        base = each.base
        if each.is_numeric and isinstance(base, float | int) and base != 0.0 and len(rows):
            lines.append((each, *_relative(each, float(base), rows, change)))
        else:
            left_out.append(each.label)
    if not lines:
        raise ValueError("no factor is a number other than 0 in the file")
    lines.sort(key=lambda line: -float(np.ptp(line[2][np.isfinite(line[2])])))
    left_out += [each.label for each, _, _ in lines[_MOST_SPIDER_LINES:]]
    lines = lines[:_MOST_SPIDER_LINES]
    ratios = np.concatenate([ratio for _, ratio, _ in lines])
    by_logarithm = bool(ratios.min() > 0.0 and ratios.max() > 8.0 * ratios.min())
    with canvas(ax, WIDE, 72.0) as on:
        on.ax.axhline(0.0, **REFERENCE)
        on.ax.axvline(1.0 if by_logarithm else 0.0, **REFERENCE)
        handles: list[Artist] = []
        for place, (each, ratio, moved) in enumerate(lines):
            handles += on.ax.plot(
                ratio if by_logarithm else 100.0 * (ratio - 1.0),
                moved,
                color=COLOURS[place % len(COLOURS)],
                linestyle=DASHES[(place // len(COLOURS)) % len(DASHES)],
                marker=MARKERS[place % len(MARKERS)],
                markerfacecolor=COLOURS[place % len(COLOURS)] if place < len(COLOURS) else "white",
                label=shown(each.label, 30),
            )
        if by_logarithm:
            _ratio_axis(on, ratios)
        else:
            on.ax.set_xlabel("Change of the factor (%)")
        on.ax.set_ylabel(f"Change of {shown(response_name(response).text, 36)} (%)")
        if left_out:
            names = "\n".join(shown(name, 26) for name in left_out)
            handles.append(key(f"not shown:\n{names}", linestyle="none"))
        legend(on, handles, beside=True)
        return on.ax


def _relative(
    each: Input, base: float, rows: npt.NDArray[np.int_], change: npt.NDArray[np.float64]
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Values over that of the file, ascending, and changes; the file's own among them."""
    ratio = np.append(each.values[rows], base) / base
    moved = np.append(change[rows], change[0])
    ratio, first = np.unique(ratio, return_index=True)
    return ratio, moved[first]


def _ratio_axis(on: Canvas, ratios: npt.NDArray[np.float64]) -> None:
    from matplotlib.ticker import FixedLocator, NullLocator

    on.ax.set_xscale("log")
    decades = range(-6, 7)
    for digits in ((1.0, 2.0, 5.0), (1.0, 3.0), (1.0,)):
        steps = [digit * 10.0**decade for decade in decades for digit in digits]
        inside = [step for step in steps if ratios.min() * 0.99 <= step <= ratios.max() * 1.01]
        if len(inside) <= 7:
            break
    on.ax.xaxis.set_major_locator(FixedLocator(inside))
    on.ax.xaxis.set_minor_locator(NullLocator())
    on.ax.set_xticks(inside, [f"{step:g}" for step in inside])
    on.ax.set_xlabel("Factor over its value in the file")


def _cloud(
    result: StudyResult,
    response: str,
    values: npt.NDArray[np.float64],
    factors: list[Input],
    ax: Axes | None,
) -> Axes:
    ranked = {path: value for path, value, _ in contributions(result, response)}
    numeric = [each for each in factors if each.is_numeric] or factors
    x = max(numeric, key=lambda each: abs(ranked.get(each.path, 0.0)))
    rows = np.arange(1, len(values))
    with canvas(ax) as on:
        style = {"color": BLUE, "marker": ".", "linestyle": "none", "markersize": 2.0}
        if len(rows) > 1000:
            style["alpha"] = 0.6
        style["markeredgewidth"] = 0.0
        _line_over(on, x, rows, values, "designs", style)
        mark = _base_mark(on, x, values[0])
        _factor_axis(on, x, rows)
        on.ax.set_ylabel(response_name(response).label)
        legend(on, [key("designs", color=BLUE, marker=".", linestyle="none"), *mark])
        return on.ax


def _spread(levels: list[Any], most: int) -> list[Any]:
    """Up to so many levels, evenly spread, both ends among them."""
    if len(levels) <= most:
        return levels
    return [levels[k * (len(levels) - 1) // (most - 1)] for k in range(most)]


__all__ = ["study_lines"]
