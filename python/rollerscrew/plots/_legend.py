"""Legends, titles and colour bars, where they cover nothing."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from rollerscrew.plots._again import KEYS, LIMITS, TITLES, leave_room
from rollerscrew.plots._style import legend_key, scale_levels, scale_range

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.figure import Figure

_HANDLE_MM = 10.0
_CHARACTER_MM = 1.45
_TITLE_CHARACTER_MM = 1.55
_POINTS = 7.5
_ROW_MM = 3.8
_MOST_ABOVE = 9  #: More entries than these stand beside the panel.
_BESIDE_MM = 48.0


def shown(text: str, most: int = 200) -> str:
    """A text as it stands: no formula, not hidden, not too long."""
    lines = "\n".join(textwrap.fill(line, most) for line in text.splitlines())
    return (f" {lines}" if lines.startswith("_") else lines).replace("$", r"\$")


def axis_text(axis: Mapping[str, Any], most: int = 200) -> str:
    """`Lead (mm)`."""
    label, unit = axis.get("label", ""), axis.get("unit", "")
    return shown(f"{label} ({unit})" if unit else label, most)


def size_of(ax: Axes) -> tuple[float, float]:
    """Width and height of axes, mm."""
    box, unit = ax.get_window_extent(), 25.4 / figure_of(ax).dpi
    return float(box.width) * unit, float(box.height) * unit


def figure_of(ax: Axes) -> Figure:
    """The whole figure, also of axes in a part of one."""
    part: Any = ax.figure
    figure: Figure = part.figure
    return figure


def characters(width_mm: float) -> int:
    """How many of a title stand in a line."""
    return max(16, int(width_mm / _TITLE_CHARACTER_MM))


def keys(description: Mapping[str, Any]) -> list[Artist]:
    styles = description.get("styles", [])
    return [
        legend_key(styles[entry["style"]], shown(entry["title"], 44))
        for entry in description.get("legend", [])
    ]


def stands_beside(description: Mapping[str, Any]) -> bool:
    """Whether the legend of a new figure stands beside its panel, not above."""
    entries, is_free = len(description.get("legend", [])), "width_mm" not in description
    return len(description["panels"]) == 1 and entries > _MOST_ABOVE and is_free


def legend_of_figure(figure: Figure, description: Mapping[str, Any]) -> None:
    """Title and legend of a new figure, which grows by what stands above its panels."""
    beside = stands_beside(description)
    _legend_outside(figure, keys(description), description.get("title", ""), beside)


def legend_of_compared(ax: Axes, grows: bool) -> None:
    """Moves title and legend of the only axes of a figure out of them; beside, where it grows."""
    handles, titles = getattr(ax, KEYS, []), getattr(ax, TITLES, [])
    if (made := ax.get_legend()) is not None:
        made.remove()
    ax.set_title("")
    leave_room(ax)
    figure = figure_of(ax)
    beside = grows and len(handles) > _MOST_ABOVE
    if beside:
        figure.set_figwidth(figure.get_figwidth() + _BESIDE_MM / 25.4)
    _legend_outside(figure, handles, titles[0] if len(titles) == 1 else "", beside)


def _legend_outside(figure: Figure, handles: list[Artist], title: str, beside: bool) -> None:
    width = 25.4 * figure.get_figwidth()
    title = shown(title, characters(width))
    rows: float = title.count("\n") + 1 if title else 0
    if handles:
        labels = [str(handle.get_label()) for handle in handles]
        columns = 1 if beside else _columns(width, labels)
        if not beside:
            rows += -(-len(labels) // columns) * max(label.count("\n") + 1 for label in labels)
        figure.legend(
            handles=handles,
            title=None if beside else title,
            ncols=columns,
            loc="outside right center" if beside else "outside upper center",
        )
    if title and (beside or not handles):
        figure.suptitle(title)
    figure.set_figheight(figure.get_figheight() + rows * _ROW_MM / 25.4)


def legend_within(ax: Axes, description: Mapping[str, Any], covers: bool) -> None:
    """Title and legend of given axes: the upper limit is moved to make room.

    Of a map, or what is to scale (`covers`), limits stay.
    """
    import matplotlib
    from matplotlib.font_manager import FontProperties

    panel = description["panels"][0]
    points = FontProperties(size=matplotlib.rcParams["legend.fontsize"]).get_size_in_points()
    width = size_of(ax)[0] * _POINTS / points
    title = ", ".join(filter(None, (description.get("title"), panel.get("title"))))
    titles = list(dict.fromkeys([*getattr(ax, TITLES, []), title]))
    title = titles[0] if len(titles) == 1 else ""  # Of several pictures, what they share.
    ax.set_title(shown(title, characters(width)), fontsize=points)
    handles = list(getattr(ax, KEYS, []))
    told = {str(handle.get_label()) for handle in handles}
    handles += [each for each in keys(description) if str(each.get_label()) not in told]
    _label_for_legends(ax, handles)
    setattr(ax, TITLES, titles)
    setattr(ax, KEYS, handles)
    if not handles:
        return
    small = 0.75 if len(handles) > _MOST_ABOVE else 1.0
    columns = _columns(width / small, [str(handle.get_label()) for handle in handles])
    made = ax.legend(
        handles=handles, loc="upper center", ncols=columns, framealpha=0.8, fontsize=small * points
    )
    if covers:
        return
    taken = 1.1 * made.get_window_extent().height / ax.get_window_extent().height + 0.03
    scale = ax.yaxis.get_transform()
    limits = ax.get_ylim()
    low, high = scale.transform(np.array(limits))
    raised = low + (high - low) / (1.0 - min(taken, 0.65))
    ax.set_ylim(top=float(scale.inverted().transform(np.array([raised]))[0]), auto=None)
    setattr(ax, LIMITS, (limits, ax.get_ylim()))


def _label_for_legends(ax: Axes, handles: Iterable[Artist]) -> None:
    """Lines without points for keys that no artist has, so that `ax.legend()` shows them, too."""
    from matplotlib.lines import Line2D

    labelled = set(ax.get_legend_handles_labels()[1])
    for handle in handles:
        if isinstance(handle, Line2D) and str(handle.get_label()) not in labelled:
            key = Line2D([], [])
            key.update_from(handle)
            key.set_label(handle.get_label())
            ax.add_line(key)


def _columns(width_mm: float, labels: Iterable[str]) -> int:
    lengths = [max(map(len, label.split("\n"))) for label in labels]
    columns = max(1, int(width_mm / (_HANDLE_MM + _CHARACTER_MM * max(lengths))))
    rows = -(-len(lengths) // columns)
    return -(-len(lengths) // rows)


def colour_bar(
    axes: Sequence[Axes],
    scale: ScalarMappable,
    colours: Mapping[str, Any],
    contours: bool,
    below: bool,
) -> Any:
    """A colour bar beside the panels, or below them where they are low."""
    from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullLocator

    where: dict[str, Any] = {"location": "right"}
    if below:
        where = {"location": "bottom", "shrink": 0.5, "pad": 0.02, "aspect": 30}
    title = axis_text(colours, characters(size_of(axes[0])[not below]))
    bar = axes[0].figure.colorbar(scale, ax=list(axes), label=title, **where)
    levels = scale_levels(colours, contours)
    if colours.get("whole"):
        first, last = round(scale_range(colours)[0]), round(scale_range(colours)[1])
        step = 1 if last - first < 10 else 5 * -(-(last - first) // 40)
        bar.locator = FixedLocator(
            [first, *(k for k in range(first + 1, last + 1) if k % step == 0)]
        )
    elif colours.get("logarithmic"):
        bar.locator = LogLocator(subs=(1, 2, 5))
    elif levels:
        step = -(-len(levels) // 12)
        bar.locator = FixedLocator(list(levels[::step]))
    if colours.get("logarithmic") or levels:
        bar.formatter = FuncFormatter(lambda value, _: f"{value:.6g}".replace("-", "−"))
    bar.ax.minorticks_off()
    bar.long_axis.set_minor_locator(NullLocator())
    bar.update_ticks()
    return bar
