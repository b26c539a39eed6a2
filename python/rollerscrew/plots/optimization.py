"""Pictures of optimizations."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from rollerscrew.plots._canvas import (
    BLACK,
    BLUE,
    GREEN,
    ORANGE,
    REFERENCE,
    VERMILLION,
    Canvas,
    canvas,
    legend,
)
from rollerscrew.plots._names import response_name

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from rollerscrew.record import Record
    from rollerscrew.results import OptimizationResult

_LOOKS: dict[str, dict[str, Any]] = {
    "check": {"color": ORANGE, "marker": "s", "markerfacecolor": "none", "markersize": 4.6},
    "search": {"color": BLUE, "marker": "o"},
    "initial": {"color": BLACK, "marker": "D", "markerfacecolor": "white", "markersize": 5.0},
    "compromise": {
        "color": VERMILLION,
        "marker": "*",
        "markerfacecolor": "none",
        "markersize": 9.0,
    },
    "nearest": {"color": GREEN, "marker": "X", "markersize": 6.0, "markeredgewidth": 0.4},
}


def front(result: OptimizationResult, ax: Axes | None = None) -> Axes:
    """Feasible designs that none beats in the first two objectives, with the file's own design.

    Of one objective: its value over the number of the design at which it was found. The compromise,
    or the design nearest to the limits where none keeps them, is marked.
    """
    objectives = [next(iter(objective.items())) for objective in result.optimize.objectives]
    paths = [path for _, path in objectives][:2]
    groups = _groups(result, paths)
    if not any(points for name, _, points in groups if name != "initial"):
        raise ValueError("the search has no design with an answer")
    with canvas(ax) as on:
        handles = _single(on, groups) if len(paths) == 1 else _pair(on, groups)
        labels = [_axis_label(*objective) for objective in objectives[:2]]
        if len(paths) == 1:
            on.ax.set_xlabel("Design of the search")
            on.ax.set_ylabel(labels[0])
        else:
            on.ax.set_xlabel(labels[0])
            on.ax.set_ylabel(labels[1])
        legend(on, handles)
        return on.ax


def _axis_label(sense: str, path: str) -> str:
    return response_name(path).label + (", more is better" if sense == "maximize" else "")


#: Kind, label, and number of the design with its values, a tuple each.
_Group = tuple[str, str, list[tuple[float, ...]]]


def _groups(result: OptimizationResult, paths: Sequence[str]) -> list[_Group]:
    groups: list[_Group] = []
    for name in ("check", "search"):
        if name in result:
            search: Record = result[name]
            rows = search.get("front", [])
            groups.append((name, f"front, {search.get('algorithm', name)}", _points(rows, paths)))
    if "initial" in result:
        groups.append(("initial", "as in the file", _points([result.initial], paths)))
    if "compromise" in result:
        groups.append(("compromise", "compromise", _points([result.compromise], paths)))
    elif "nearest" in result:
        groups.append(("nearest", "nearest to the limits", _points([result.nearest], paths)))
    return groups


def _points(rows: Sequence[Record], paths: Sequence[str]) -> list[tuple[float, ...]]:
    found = []
    for row in rows:
        responses = row.get("responses", {})
        values = [responses.get(path) for path in paths]
        if all(value is not None and np.isfinite(value) for value in values):
            found.append((float(row.get("design", 0)), *map(float, values)))
    return found


def _pair(on: Canvas, groups: list[_Group]) -> list[Artist]:
    handles: list[Artist] = []
    for name, label, points in groups:
        if points:
            ordered = sorted(points, key=lambda point: point[1:])
            handles += on.ax.plot(
                [point[1] for point in ordered],
                [point[2] for point in ordered],
                linestyle="none",
                label=label,
                zorder=3 if name in ("search", "check") else 4,
                **_LOOKS[name],
            )
    return handles


def _single(on: Canvas, groups: list[_Group]) -> list[Artist]:
    handles: list[Artist] = []
    for name, label, points in groups:
        if not points:
            continue
        if name == "initial":
            on.ax.axhline(points[0][1], **REFERENCE)
        label = label.replace("front", "best")
        handles += on.ax.plot(
            [point[0] for point in points],
            [point[1] for point in points],
            linestyle="none",
            label=f"{label}: {points[0][1]:.4g}" if len(points) == 1 else label,
            zorder=3 if name in ("search", "check") else 4,
            **_LOOKS[name],
        )
    return handles


__all__ = ["front"]
