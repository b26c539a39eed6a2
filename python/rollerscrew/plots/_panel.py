"""One panel of a description drawn into axes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from rollerscrew.plots._figure import panel_axis
from rollerscrew.plots._legend import axis_text, characters, shown, size_of
from rollerscrew.plots._style import colour_of, is_points, line_look, scale_levels

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable

_SMALL = 0.78  #: Size of texts in a panel over that of the others.
_MOST_OUTLINED = 150  #: More areas in colours of values have no outlines.
_MOST_DIGITS = 44  #: Characters of tick texts that a column of a paper has room for.


def draw_panel(
    ax: Axes, description: Mapping[str, Any], place: int, scale: ScalarMappable | None
) -> None:
    panel = description["panels"][place]
    x, y = (panel_axis(description, place, which) for which in "xy")
    if "surface" in panel:
        _surface(ax, panel["surface"], x, y, scale)
        return
    for which, axis in (("x", x), ("y", y)):
        if axis.get("logarithmic"):
            getattr(ax, f"set_{which}scale")("log")
    if "map" in panel:
        _map(ax, panel["map"], description.get("colours", {}), scale)
    entries = reversed(description.get("legend", []))  # A label stands before what a line means.
    names = {each["style"]: shown(each["title"]) for each in entries}
    styles = description.get("styles", [])
    for series in panel.get("series", []):
        style = styles[series["style"]]
        _series(ax, series, style, scale, names.get(series["style"], "_"))
    ax.autoscale_view()
    for reference in panel.get("references", []):
        look = line_look(styles[reference["style"]])
        look |= {"marker": "", "zorder": 0.5, "label": names.get(reference["style"], "_")}
        line = ax.axvline if reference.get("vertical") else ax.axhline
        line(reference["at"], **look)
    for which, axis in (("x", x), ("y", y)):
        _axis(ax, which, axis)
    for label in _with_room(ax, panel.get("labels", [])):
        _label(ax, label, over="map" in panel)
    _show_marks_at_limits(ax)
    if description.get("to_scale"):
        ax.set_aspect("equal", adjustable="datalim")


def _show_marks_at_limits(ax: Axes) -> None:
    """Marks whose middle lies on the frame are drawn as a whole."""
    ends = np.sort([ax.get_xlim(), ax.get_ylim()], axis=1)
    for line in ax.get_lines():
        points = np.asarray(line.get_xydata(), dtype=np.float64)
        points = points[np.isfinite(points).all(axis=1)]
        inside = ((points >= ends[:, 0]) & (points <= ends[:, 1])).all()
        at_limit = (points == ends[:, 0]) | (points == ends[:, 1])
        if line.get_marker() not in ("", "None", None) and inside and at_limit.any():
            line.set_clip_on(False)


def _series(
    ax: Axes,
    series: Mapping[str, Any],
    style: Mapping[str, Any],
    scale: ScalarMappable | None,
    name: str,
) -> None:
    parts = [np.asarray(part, np.float64).reshape(-1, 2) for part in series.get("parts", [])]
    values = np.asarray(series.get("values", []), dtype=np.float64)
    shape = style.get("shape", "line")
    if not parts:
        return
    look: dict[str, Any] = {"zorder": 2.0 + 0.001 * len(ax.get_children()), "label": name}
    if shape == "arrows":
        tails, tips = np.array([part[0] for part in parts]), np.array([part[-1] for part in parts])
        ax.quiver(
            *tails.T, *(tips - tails).T, angles="xy", scale_units="xy", scale=1.0, width=0.003,
            color=colour_of(style), **look,
        )  # fmt: skip
        ax.update_datalim(np.vstack(parts))
    elif shape == "area":
        _areas(ax, parts, values, style, scale, look)
    elif not values.size:
        broken = np.vstack([row for part in parts for row in (part, [[np.nan, np.nan]])][:-1])
        ax.plot(*broken.T, **line_look(style, len(broken)), **look)
    elif is_points(style):
        x, y = np.vstack(parts).T
        of_points = np.repeat(values, [len(part) for part in parts])
        dots = line_look(style, len(of_points))
        look |= {"s": dots["markersize"] ** 2, "marker": dots["marker"], "linewidths": 0.0}
        ax.scatter(x, y, c=of_points, **_mapped(scale), **look)
    else:
        for part, value in zip(parts, values.tolist(), strict=True):
            lines = line_look(style, len(part)) | {"marker": ""}
            if scale is not None:
                lines["color"] = scale.to_rgba(value)
            ax.plot(*part.T, **lines, **look)


def _areas(
    ax: Axes,
    parts: list[npt.NDArray[np.float64]],
    values: npt.NDArray[np.float64],
    style: Mapping[str, Any],
    scale: ScalarMappable | None,
    look: dict[str, Any],
) -> None:
    from matplotlib.collections import PolyCollection

    outlined = not values.size or len(parts) <= _MOST_OUTLINED
    areas = PolyCollection(
        parts,
        facecolor=colour_of(style),
        edgecolor="black" if outlined else "face",
        linewidth=0.4 if outlined else 0.2,
        **look,
    )
    if values.size:
        areas.set(array=values, **_mapped(scale))
    ax.add_collection(areas)


def _mapped(scale: ScalarMappable | None) -> dict[str, Any]:
    return {} if scale is None else {"cmap": scale.get_cmap(), "norm": scale.norm}


def _map(
    ax: Axes, drawn: Mapping[str, Any], colours: Mapping[str, Any], scale: ScalarMappable | None
) -> None:
    x, y = (np.asarray(drawn[which], dtype=np.float64) for which in "xy")
    grid = np.ma.masked_invalid(np.asarray(drawn["values"], dtype=np.float64).T)
    look: dict[str, Any] = {**_mapped(scale), "zorder": 0.1}
    if drawn.get("cells"):
        ax.pcolormesh(x, y, grid, shading="nearest", rasterized=True, **look)
    elif grid.count():
        levels = scale_levels(colours, True)
        ax.contourf(x, y, grid, levels=levels, extend="neither", **look)
        inside = [level for level in levels if grid.min() < level < grid.max()]
        if inside:
            middle = 0.5 * (levels[0] + levels[-1])  # Lighter colours lie above.
            ink = ["white" if level < middle else "black" for level in inside]
            lines = ax.contour(x, y, grid, levels=inside, colors=ink, linewidths=0.4, zorder=0.2)
            ax.clabel(lines, fmt="%g", fontsize=_text_size())
    for spine in ax.spines.values():
        spine.set_visible(True)


def _text_size() -> float:
    import matplotlib
    from matplotlib.font_manager import FontProperties

    return _SMALL * FontProperties(size=matplotlib.rcParams["font.size"]).get_size_in_points()


def _with_room(ax: Axes, labels: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """The labels; of numbers in a row without room for all, 1 and every second, fifth or tenth."""
    numbers = [each for each in labels if each["text"].isdigit() and not each.get("in_panel")]
    steps = [b["x"] - a["x"] for a, b in pairwise(numbers) if a["y"] == b["y"]]
    if not steps:
        return list(labels)
    low, high = ax.get_xlim()
    apart = min(map(abs, steps)) / abs(high - low) * size_of(ax)[0]
    needed = 0.21 * _text_size() * (0.8 + max(len(each["text"]) for each in numbers))
    every = next((n for n in (1, 2, 5) if n * apart >= needed), 10)
    left_out = [each for each in numbers if each["text"] != "1" and int(each["text"]) % every]
    return [each for each in labels if each not in left_out]


def _label(ax: Axes, label: Mapping[str, Any], over: bool) -> None:
    anchor = label.get("anchor", "left")
    ax.text(
        label["x"],
        label["y"],
        shown(label["text"]),
        ha="center" if anchor == "centre" else anchor,
        va="center",
        transform=ax.transAxes if label.get("in_panel") else ax.transData,
        fontsize=_text_size(),
        zorder=1.9 if over else 5.0,  # Marks on a map stay visible.
        bbox={"boxstyle": "round,pad=0.15", "facecolor": "white", "alpha": 0.8, "linewidth": 0}
        if over
        else None,
    )


def _axis(ax: Axes, which: str, axis: Mapping[str, Any]) -> None:
    from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter

    drawn: Any = getattr(ax, f"{which}axis")
    limits: Any = getattr(ax, f"set_{which}lim")
    low, high = (axis.get(end) for end in ("from", "to"))
    if low is not None or high is not None:
        limits(low, high, auto=None)
    if axis.get("hidden"):
        drawn.set_ticks([])
        for side in ("left", "right") if which == "y" else ("bottom", "top"):
            ax.spines[side].set_visible(False)
        return
    visible = drawn.get_tick_params().get("labelbottom" if which == "x" else "labelleft", True)
    room = characters(size_of(ax)["xy".index(which)])
    drawn.set_label_text(axis_text(axis, room) if visible else "")
    ticks = axis.get("ticks", [])
    if ticks:
        texts = [shown(tick.get("text", ""), 40) for tick in ticks]
        at = [tick["at"] for tick in ticks]
        drawn.set_ticks(at, texts if any(texts) else [f"{each:g}" for each in at])
        drawn.set_ticks([], minor=True)
        if any(texts):
            drawn.set_tick_params(length=0)
            if not ax.spines["bottom"].get_visible():
                ax.spines["left"].set_visible(False)
            if which == "x":
                _turn(ax, texts)
    elif axis.get("whole"):
        drawn.set_major_locator(MaxNLocator("auto", integer=True, min_n_ticks=1))
    elif axis.get("logarithmic"):
        start, end = sorted(getattr(ax, f"get_{which}lim")())
        if end < 300.0 * start:
            drawn.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            drawn.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            drawn.set_minor_formatter(NullFormatter())


def _turn(ax: Axes, texts: Sequence[str]) -> None:
    """Texts below an axis that would run together."""
    longest = max(len(line) for text in texts for line in text.split("\n"))
    if longest * len(texts) <= _MOST_DIGITS * size_of(ax)[0] / 70.0:
        return
    upright = len(texts) > 8
    ax.tick_params(axis="x", labelrotation=90 if upright else 30)
    for text in ax.get_xticklabels():
        text.set_horizontalalignment("center" if upright else "right")
        text.set_rotation_mode("default" if upright else "anchor")


def _surface(
    ax: Any,
    surface: Mapping[str, Any],
    x: Mapping[str, Any],
    y: Mapping[str, Any],
    scale: ScalarMappable | None,
) -> None:
    if not hasattr(ax, "plot_surface"):
        raise ValueError('a surface needs axes with `projection="3d"`; leave `ax` out for a figure')
    across, up = np.meshgrid(surface["x"], surface["y"])
    grid = np.asarray(surface["values"], dtype=np.float64).T
    ax.plot_surface(
        across, up, grid, rcount=len(grid), ccount=len(grid[0]), edgecolor="white", linewidth=0.15,
        **_mapped(scale),
    )  # fmt: skip
    for point in surface.get("points", []):
        at = (point["x"], point["y"], point["z"])
        ax.plot(*([each] for each in at), "o", color="black", markersize=3.0, zorder=10)
        ax.text(*at, f" {shown(point['name'])}", fontsize=_text_size(), zorder=11)
    ax.text2D(0.0, 0.98, axis_text(surface["z"]), transform=ax.transAxes)  # Clear of the others.
    for which, axis in (("x", x), ("y", y), ("z", surface["z"])):
        if which != "z":
            getattr(ax, f"set_{which}label")(axis_text(axis, 26), labelpad=-4.0)
        getattr(ax, f"{which}axis").set_major_formatter("{x:g}")
        ax.tick_params(axis=which, pad=1.0 if which == "z" else -3.0, labelsize=_text_size())
        ax.locator_params(axis=which, nbins=4, integer=bool(axis.get("whole")))
        if "from" in axis or "to" in axis:
            getattr(ax, f"set_{which}lim")(axis.get("from"), axis.get("to"))
    ax.view_init(elev=28, azim=-125)
    ax.set_box_aspect((1.0, 1.0, 0.75), zoom=0.85)
