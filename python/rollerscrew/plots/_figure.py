"""Axes of a new figure in the style of a paper, one per panel."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rollerscrew.plots._legend import stands_beside

if TYPE_CHECKING:
    from matplotlib.axes import Axes

STYLE = Path(__file__).with_name("paper.mplstyle")

#: Widths of a figure, mm, by the columns of its panels: one column of a paper, one and a half, two.
_WIDTHS_MM = {1: 88.0, 2: 136.0}
_WIDEST_MM = 180.0
_LEAST_PANEL_MM = (40.0, 60.0)  #: Panels with less stand below each other; with own axes or bars.
_WIDTH_LIMITS_MM = (40.0, 500.0)
_ASPECT = 0.64
_ASPECT_IN_SPACE = 0.85
_LEAST, _MOST = 0.1, 1.0  #: Of what is to scale: the other axis is widened.
_LABELS_MM = (13.0, 10.0)  #: What labels and ticks take of the width and height.
_TITLE_MM = 4.5
_BAR_MM = 15.0  #: Width of a colour bar at the side of the panels, height of one under them.
_LOW = 0.3  #: Height over width of panels whose colour bar stands below them.
_LONG_TICK = 12  #: Characters.


def of_width(
    description: Mapping[str, Any], width: float | None, ax: Axes | None
) -> Mapping[str, Any]:
    """The description for a new figure of a width in mm, with the columns that have room in it."""
    if width is None:
        return description
    if ax is not None:
        raise ValueError("width: got it with `ax`; given axes have the size of their figure")
    least, most = _WIDTH_LIMITS_MM
    if not least <= width <= most:
        raise ValueError(f"width: got {width}; expected {least:g} to {most:g}, in mm")
    alone = "colours" in description or any("y" in panel for panel in description["panels"])
    columns = max(1, min(_columns(description), int(width / _LEAST_PANEL_MM[alone])))
    return {**description, "columns": columns, "width_mm": float(width)}


@contextmanager
def new_axes(description: Mapping[str, Any]) -> Iterator[list[Axes]]:
    """Axes for the panels; closed again where drawing them fails."""
    import matplotlib
    import matplotlib.pyplot as plt

    with plt.style.context(STYLE):
        figure = plt.figure(figsize=_inches(description))
        # A notebook's backend turns it on with its first figure; the style would turn it off.
        interactive = matplotlib.is_interactive()
        try:
            axes = _axes(figure, description)
            for ax in axes:
                keep_ticks(ax)
            yield axes
        except BaseException:
            plt.close(figure)
            raise
    matplotlib.interactive(interactive)


def _columns(description: Mapping[str, Any]) -> int:
    return min(int(description.get("columns", 1)), len(description["panels"]))


def _rows(description: Mapping[str, Any]) -> int:
    columns, panels = _columns(description), len(description["panels"])
    if description.get("overview") and columns > 1:
        return -(-(panels - 1) // (columns - 1))
    return -(-panels // columns)


def panel_axis(description: Mapping[str, Any], panel: int, which: str) -> Mapping[str, Any]:
    axis: Mapping[str, Any] = description["panels"][panel].get(which, description.get(which, {}))
    return axis


def panel_aspect(description: Mapping[str, Any]) -> float:
    """Height of a panel over its width."""
    if description.get("aspect"):
        return float(description["aspect"])
    if any("surface" in panel for panel in description["panels"]):
        return _ASPECT_IN_SPACE
    x, y = (panel_axis(description, 0, which) for which in "xy")
    if description.get("to_scale") and all(
        key in axis for axis in (x, y) for key in ("from", "to")
    ):
        return float(min(max(abs((y["to"] - y["from"]) / (x["to"] - x["from"])), _LEAST), _MOST))
    return _ASPECT


def bar_stands_below(description: Mapping[str, Any]) -> bool:
    """Whether the colour bar stands below the panels, not beside them."""
    return panel_aspect(description) < _LOW


def _inches(description: Mapping[str, Any]) -> tuple[float, float]:
    columns, rows = _columns(description), _rows(description)
    ticks = panel_axis(description, 0, "y").get("ticks", [])
    beside = max((len(tick.get("text", "")) for tick in ticks), default=0)
    wide = stands_beside(description) or beside > _LONG_TICK or panel_aspect(description) < 0.4
    width = description.get("width_mm") or _WIDTHS_MM.get(max(columns, 1 + wide), _WIDEST_MM)
    labelled = columns if any("y" in panel for panel in description["panels"]) else 1
    room = width - labelled * _LABELS_MM[0] - (1.2 * beside if beside > 4 else 0.0)
    bar = _BAR_MM * ("colours" in description)
    below = bar_stands_below(description)
    room -= bar * (not below) + 40.0 * stands_beside(description)
    panel = room / (columns - 1 + float(description.get("overview") or 1.0))
    labelled = rows if any("x" in panel for panel in description["panels"]) else 1
    titled = any(panel.get("title") for panel in description["panels"])
    lines = 2 if panel < _LEAST_PANEL_MM[0] else 1  # Of titles, which are as long in narrow panels.
    height = rows * (panel * panel_aspect(description) + lines * _TITLE_MM * titled + 2.0)
    return width / 25.4, (height + bar * below + lines * labelled * _LABELS_MM[1]) / 25.4


def _axes(figure: Any, description: Mapping[str, Any]) -> list[Axes]:
    """Panels with the axes of the figure share them; only outer ones have labels."""
    columns, rows, panels = _columns(description), _rows(description), description["panels"]
    overview = float(description.get("overview") or 0.0) if columns > 1 else 0.0
    grid = figure.add_gridspec(
        rows, columns, width_ratios=[overview or 1.0, *[1.0] * (columns - 1)]
    )
    axes: list[Axes] = []
    first: dict[str, Axes] = {}
    for place, panel in enumerate(panels):
        if overview:
            row, column = divmod(place - 1, columns - 1)
            cell = grid[row, column + 1] if place else grid[:, 0]
        else:
            cell = grid[divmod(place, columns)]
        if "surface" in panel:
            axes.append(figure.add_subplot(cell, projection="3d"))
            continue
        shared = {}
        for which in "xy":
            if which not in panel and not description.get("to_scale"):
                shared[f"share{which}"] = first.get(which)
        ax = figure.add_subplot(cell, **shared)
        axes.append(ax)
        if "sharex" in shared and place + columns < len(panels):
            ax.tick_params(labelbottom=False)
        if shared.get("sharey") and place % columns:
            ax.tick_params(labelleft=False)
        for which in "xy":
            if f"share{which}" in shared:
                first.setdefault(which, ax)
    return axes


def keep_ticks(ax: Axes) -> None:
    """Ticks are made when a figure is drawn, by which time the style is no longer in effect."""
    import matplotlib

    style: Any = matplotlib.rcParams
    for axis, which in product("xy", ("major", "minor")):
        look = {key: style[f"{axis}tick.{key}"] for key in ("direction", "labelsize")}
        look |= {"length": style[f"{axis}tick.{which}.size"]}
        look |= {"width": style[f"{axis}tick.{which}.width"]}
        ax.tick_params(axis=axis, which=which, **look)  # type: ignore[arg-type]
