"""The looks of a description's styles: colours, dashes, marks, colour scales."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.cm import ScalarMappable

#: The palette is that of Okabe and Ito, told apart by any colour vision.
COLOURS = {
    "blue": "#0072B2",
    "vermillion": "#D55E00",
    "green": "#009E73",
    "purple": "#CC79A7",
    "orange": "#E69F00",
    "sky": "#56B4E9",
    "ink": "#000000",
    "grey": "#7F7F7F",
    "reference": "#555555",
    "muted": "#A0A0A0",
    "bad": "#C02020",
}
_DASHES: dict[str, Any] = {
    "none": "none",
    "solid": "-",
    "dashed": (0, (4, 1.5)),
    "dotted": (0, (1, 1.2)),
    "dash_dotted": (0, (4, 1.2, 1, 1.2)),
}
_MARKS = {"none": ""} | dict(
    zip("circle square triangle diamond down plus cross star".split(), "os^Dv+x*", strict=True)
)
_MARK_SIZES = {"star": 2.2, "plus": 1.4, "cross": 1.3}
_WEIGHTS = {"thin": 0.6, "normal": 1.0, "strong": 1.6}
_POINT_WEIGHTS = {"thin": 0.45, "normal": 1.0, "strong": 1.4}

#: Lines of more points have about a dozen marks, the last one too; clouds of more small ones.
_MOST_MARKS = 40
_MOST_LARGE_POINTS = 400


def is_points(style: Mapping[str, Any]) -> bool:
    """Marks without a line."""
    return style.get("shape", "line") == "line" and style.get("dash") == "none"


def colour_of(style: Mapping[str, Any]) -> Any:
    from matplotlib.colors import to_rgb

    named = style.get("colour", "ink")
    colour = np.array(to_rgb(COLOURS.get(named, named) if isinstance(named, str) else named))
    return tuple(0.35 * colour + 0.65 if style.get("pale") else colour)


def line_look(style: Mapping[str, Any], points: int = 0) -> dict[str, Any]:
    """Options of `Axes.plot`, in widths and sizes of the style of matplotlib in effect."""
    import matplotlib

    rc: Any = matplotlib.rcParams
    colour, mark = colour_of(style), style.get("mark", "none")
    look: dict[str, Any] = {
        "color": colour,
        "linestyle": _DASHES[style.get("dash", "solid")],
        "linewidth": _WEIGHTS[style.get("weight", "normal")] * rc["lines.linewidth"],
        "marker": _MARKS[mark],
        "markersize": rc["lines.markersize"] * _MARK_SIZES.get(mark, 1.0),
        "markerfacecolor": "white" if style.get("open") else colour,
    }
    if is_points(style):
        look["markersize"] *= _POINT_WEIGHTS[style.get("weight", "normal")]
        if points > _MOST_LARGE_POINTS:
            look |= {"markersize": 0.6 * look["markersize"], "markeredgewidth": 0.0, "alpha": 0.7}
    elif points > _MOST_MARKS:
        look["markevery"] = sorted({*range(0, points, points // 12), points - 1})
    return look


def legend_key(style: Mapping[str, Any], title: str) -> Artist:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    if style.get("shape") == "area":
        return Patch(facecolor=colour_of(style), edgecolor="black", linewidth=0.4, label=title)
    look = line_look(style)
    if style.get("shape") == "arrows":
        look |= {"marker": ">", "markevery": [1]}
    return Line2D([], [], label=title, **look)


def colour_scale(colours: Mapping[str, Any], contours: bool) -> ScalarMappable:
    """Colours of values; in bands where the description, or a map of contours, has levels."""
    from matplotlib import colormaps
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import BoundaryNorm, LogNorm, Normalize

    low, high = scale_range(colours)
    levels = scale_levels(colours, contours)
    shades = colormaps["viridis"]
    if len(levels) > 1:
        return ScalarMappable(BoundaryNorm(levels, shades.N), shades)
    if colours.get("logarithmic"):
        return ScalarMappable(LogNorm(low, high), shades)
    return ScalarMappable(Normalize(low, high), shades)


def scale_range(colours: Mapping[str, Any]) -> tuple[float, float]:
    low, high = float(colours.get("from", 0.0)), float(colours.get("to", 1.0))
    return (low, high) if high > low else (low, 1.001 * low if low > 0.0 else low + 1.0)


def scale_levels(colours: Mapping[str, Any], contours: bool) -> Sequence[float]:
    from matplotlib.ticker import MaxNLocator

    low, high = scale_range(colours)
    if "levels" in colours:
        return list(colours["levels"])
    if colours.get("whole") and high - low < 256:
        return list(np.arange(round(low) - 0.5, round(high) + 1.0))
    if contours:
        return list(MaxNLocator(10, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high))
    return []
