"""Pictures of results, drawn with matplotlib as the engine describes them.

A description is a dictionary: panels with lines, areas, maps and labels, axes with their units, a
legend. `Result.figures` gives those of a result, `prs COMMAND FILE --figures --json` those of a
document; `prs schema figures` says what may stand in one. Matplotlib is imported with the first
picture.
"""

from __future__ import annotations

import reprlib
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from rollerscrew.plots._again import limits_of_both, next_colour, relabelled, shown_once, was_drawn
from rollerscrew.plots._figure import bar_stands_below, keep_ticks, new_axes, of_width
from rollerscrew.plots._legend import (
    characters,
    colour_bar,
    legend_of_compared,
    legend_of_figure,
    legend_within,
    shown,
    size_of,
)
from rollerscrew.plots._panel import draw_panel
from rollerscrew.plots._style import colour_scale

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def draw(
    description: Mapping[str, Any],
    ax: Axes | None = None,
    *,
    label: str | None = None,
    color: Any = None,
    width: float | None = None,
) -> Axes:
    """Draws a description and returns the axes, of several panels those of the first.

    Axes that are given keep their style; they take a description of one panel. Otherwise a new
    figure in the style of a paper is made. `label` stands in the legend; with `color`, or a second
    picture in the same axes, whose colour is then the next of their cycle, all lines have one
    colour and differ by their dashes.

    Parameters
    ----------
    description : dict
        One of `Result.figures()`.
    ax : matplotlib.axes.Axes, optional
        Where it is drawn; without it in a new figure.
    label : str, optional
        Name in the legend.
    color : optional
        A colour of matplotlib.
    width : float, optional
        Width of a new figure in mm: 85 for one column of a journal. Its panels stand below each
        other where they would be narrow, and its legend above them.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    TypeError
        Where the description is none.
    ValueError
        Where a picture of several panels is drawn into axes, or these are given a width.
    """
    if not isinstance(description, Mapping) or "panels" not in description:
        raise TypeError(f"description: got {reprlib.repr(description)}; expected one of figures()")
    if color is None and ax is not None and was_drawn(ax):
        color = next_colour(ax)
    description = of_width(relabelled(description, label, color), width, ax)
    if ax is None:
        with new_axes(description) as axes:
            _draw_panels(list(axes), description, own=True)
            legend_of_figure(axes[0].figure.figure, description)
        return shown_once(axes[0])
    if not hasattr(ax, "plot"):
        raise TypeError(f"ax: got {ax!r}; expected axes of matplotlib, or nothing")
    if len(description["panels"]) != 1:
        raise ValueError(
            f"ax: the picture has {len(description['panels'])} panels; axes take one, leave `ax` "
            "out for a figure"
        )
    with limits_of_both(ax):
        _draw_panels([ax], description, own=False)
    panel = description["panels"][0]
    legend_within(ax, description, covers="map" in panel or bool(description.get("to_scale")))
    return shown_once(ax)


def compare(
    results: Mapping[str, Any],
    picture: str,
    ax: Axes | None = None,
    *,
    width: float | None = None,
    **options: Any,
) -> Axes:
    """One picture of several results, each with a colour and its name in the legend.

    >>> compare({"11 rollers": a, "9 rollers": b}, "load_distribution")

    `picture` is what follows `plot_` in a method of the results, or the name of one of
    `result.figures()`; `options` are those of the method: `load_cases="pull"`.

    Parameters
    ----------
    results : dict
        Results by their names in the legend.
    picture : str
        Name of the picture.
    ax : matplotlib.axes.Axes, optional
        Where it is drawn; without it in a new figure.
    width : float, optional
        Width of a new figure in mm.
    **options : Any
        Those of the method that draws it.

    Returns
    -------
    matplotlib.axes.Axes

    Raises
    ------
    ValueError
        Where there is no such picture.
    """
    if not isinstance(results, Mapping) or not results:
        raise ValueError(
            f"results: got {reprlib.repr(results)}; expected a dictionary of names and results"
        )
    for name, result in results.items():
        if not hasattr(result, "plot_figure"):
            raise TypeError(
                f"results[{name!r}]: got {result!r}; expected what a command answers, such as "
                "`case.solve()`"
            )
        drawn = [each["name"] for each in result.figures()]
        if picture not in drawn and not hasattr(result, _method_of(picture)):
            own = [name for name in dir(type(result)) if name.startswith("plot_")]
            known = [name.removeprefix("plot_") for name in own if name != "plot_figure"]
            raise ValueError(
                f"picture: got {picture!r}; expected one of {type(result).__name__}: "
                f"{', '.join(dict.fromkeys([*known, *drawn]))}"
            )
    if ax is None:
        described: dict[str, Any] = {"panels": [{"x": {}, "y": {}}], "legend": []}
        with new_axes(of_width(described, width, ax)) as (ax,):
            compare(results, picture, ax, **options)
            legend_of_compared(ax, grows=width is None)
            return ax
    for name, result in results.items():
        look = {"ax": ax, "label": name, "color": next_colour(ax), "width": width}
        if hasattr(result, _method_of(picture)):
            getattr(result, _method_of(picture))(**look, **options)
        else:
            result.plot_figure(picture, **look, **options)
    return ax


def _method_of(picture: str) -> str:
    name = picture.removeprefix("plot_")
    return _METHODS.get(name, f"plot_{name}")


def _draw_panels(axes: list[Axes], description: Mapping[str, Any], own: bool) -> None:
    panels = description["panels"]
    colours = description.get("colours")
    contours = any("map" in panel and not panel["map"].get("cells") for panel in panels)
    scale = None if colours is None else colour_scale(colours, contours)
    for place, (ax, panel) in enumerate(zip(axes, panels, strict=True)):
        draw_panel(ax, description, place, scale)
        if own and len(panels) > 1 and panel.get("title"):
            ax.set_title(shown(panel["title"], characters(size_of(ax)[0])))
    if scale is not None and colours is not None:
        bar = colour_bar(axes, scale, colours, contours, below=bar_stands_below(description))
        if own:
            bar.outline.set_linewidth(0.6)
            keep_ticks(bar.ax)


#: Functions of a result and the options of its method, by their names.
_METHODS = {
    name: f"plot_{name.removeprefix('study_')}"
    for name in (
        "butterfly contact_points convergence cycles displacement elasticities ellipses friction "
        "front load_distribution power power_by_source pressures stiffness stiffness_terms "
        "study_contributions study_envelope study_histogram study_map"
    ).split()
} | {
    "designs": "plot",
    "preload_displacement": "plot_displacement",
    "preload_stiffness": "plot_stiffness",
    "study_lines": "plot",
    "thread_lives": "plot_lives",
}


def __getattr__(name: str) -> Callable[..., Axes]:
    if name not in _METHODS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

    def function(result: Any, *choice: Any, **options: Any) -> Axes:
        ax: Axes = getattr(result, _METHODS[name])(*choice, **options)
        return ax

    return function


__all__ = ["compare", "draw", *_METHODS]
