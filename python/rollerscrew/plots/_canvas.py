"""Axes in the style of a paper, colours, legends and labels."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

STYLE = Path(__file__).with_name("paper.mplstyle")

SINGLE = 88.0  #: Width of a column, mm.
WIDE = 136.0  #: Width of one and a half columns, mm.

#: Okabe and Ito, told apart by any colour vision.
BLUE, VERMILLION, GREEN = "#0072B2", "#D55E00", "#009E73"
PURPLE, ORANGE, SKY, BLACK, GREY = "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#7F7F7F"
COLOURS = (BLUE, VERMILLION, GREEN, PURPLE, ORANGE, SKY, BLACK, GREY)
MARKERS = ("o", "s", "^", "D", "v", "P", "X", "<")
DASHES: tuple[Any, ...] = ("-", (0, (4, 1.5)), (0, (1, 1.2)), (0, (4, 1.2, 1, 1.2)))

SOLID, DASHED = DASHES[0], DASHES[1]

#: Lines of reference: the mean, zero, the file's own value.
REFERENCE: dict[str, Any] = {"color": "#555555", "linewidth": 0.6, "zorder": 0.5}

_LEGEND_HANDLE_MM = 10.0
_LEGEND_CHARACTER_MM = 1.45
_LEGEND_POINTS = 7.5
_LEGEND_ROW_MM = 3.8
_MOST_CHARACTERS = 36


@dataclass(frozen=True)
class Canvas:
    """Axes to draw into; `own` where the figure was made here."""

    ax: Axes
    own: bool
    width_mm: float


@contextmanager
def canvas(ax: Axes | None, width_mm: float = SINGLE, height_mm: float = 58.0) -> Iterator[Canvas]:
    """The axes given, as they are, or those of a new figure in the style of a paper."""
    if ax is not None:
        if not hasattr(ax, "plot"):
            raise TypeError(f"ax: got {ax!r}; expected axes of matplotlib, or nothing")
        yield Canvas(ax, False, SINGLE)
        return
    import matplotlib
    import matplotlib.pyplot as plt

    with plt.style.context(STYLE):
        figure, new = plt.subplots(figsize=(width_mm / 25.4, height_mm / 25.4))
        # A notebook's backend turns it on with its first figure; the style would turn it off.
        interactive = matplotlib.is_interactive()
        try:
            keep_ticks(new)
            yield Canvas(new, True, width_mm)
        except BaseException:
            plt.close(figure)
            raise
    matplotlib.interactive(interactive)


def keep_ticks(ax: Axes) -> None:
    """Ticks are made when a figure is drawn, by which time the style is no longer in effect."""
    import matplotlib

    style: Any = matplotlib.rcParams
    axes: tuple[Literal["x", "y"], ...] = ("x", "y")
    kinds: tuple[Literal["major", "minor"], ...] = ("major", "minor")
    for axis in axes:
        for which in kinds:
            ax.tick_params(
                axis=axis,
                which=which,
                direction=style[f"{axis}tick.direction"],
                length=style[f"{axis}tick.{which}.size"],
                width=style[f"{axis}tick.{which}.width"],
                labelsize=style[f"{axis}tick.labelsize"],
            )


def shown(text: str, most: int = _MOST_CHARACTERS) -> str:
    """A name of the user's as text of a figure: in one line, not too long, no formula."""
    line = " ".join(text.split())
    if len(line) > most:
        line = line[: most - 1].rstrip() + "…"
    return line.replace("$", r"\$")


def sentence(text: str) -> str:
    """With a capital, unless a symbol stands first: `d_n`, `N_r`."""
    return text[0].upper() + text[1:] if text[:2].isalpha() and text[:2].islower() else text


def legend(
    on: Canvas,
    handles: Sequence[Artist],
    *,
    title: str | None = None,
    beside: bool = False,
    columns: int | None = None,
    **options: Any,
) -> None:
    """A legend outside the axes of a figure made here: above them, or `beside` them.

    The figure grows by what stands above the axes. In other axes the legend stands within, and the
    upper limit is moved to make room.
    """
    if not handles:
        return
    labels = [_visible(str(handle.get_label())) for handle in handles]
    if not on.own:
        _legend_within(on.ax, handles, labels, title)
        return
    figure = figure_of(on.ax)
    columns = 1 if beside else columns or _legend_columns(on.width_mm, labels)
    if not beside:
        lines = max(label.count("\n") + 1 for label in labels)
        rows = -(-len(labels) // columns) * lines + (title is not None)
        figure.set_figheight(figure.get_figheight() + rows * _LEGEND_ROW_MM / 25.4)
    figure.legend(
        list(handles),
        labels,
        title=title,
        ncols=columns,
        loc="outside right center" if beside else "outside upper center",
        **options,
    )


def _legend_within(
    ax: Axes, handles: Sequence[Artist], labels: Sequence[str], title: str | None
) -> None:
    import matplotlib
    from matplotlib.font_manager import FontProperties

    points = FontProperties(size=matplotlib.rcParams["legend.fontsize"]).get_size_in_points()
    columns = _legend_columns(width_of(ax) * _LEGEND_POINTS / points, labels)
    made = ax.legend(
        list(handles), list(labels), title=title, loc="upper center", ncols=columns, framealpha=0.8
    )
    taken = 1.1 * made.get_window_extent().height / ax.get_window_extent().height + 0.03
    scale = ax.yaxis.get_transform()
    low, high = scale.transform(np.array(ax.get_ylim()))
    raised = low + (high - low) / (1.0 - min(taken, 0.65))
    ax.set_ylim(top=float(scale.inverted().transform(np.array([raised]))[0]), auto=None)


def width_of(ax: Axes) -> float:
    """Width of axes, mm."""
    return float(ax.get_window_extent().width) / figure_of(ax).dpi * 25.4


def figure_of(ax: Axes) -> Figure:
    """The whole figure, also of axes in a part of one."""
    part: Any = ax.figure
    figure: Figure = part.figure
    return figure


def _visible(label: str) -> str:
    return f" {label}" if label.startswith("_") else label


def _legend_columns(width_mm: float, labels: Iterable[str]) -> int:
    lengths = [max(map(len, label.split("\n"))) for label in labels]
    columns = max(1, int(width_mm / (_LEGEND_HANDLE_MM + _LEGEND_CHARACTER_MM * max(lengths))))
    rows = -(-len(lengths) // columns)
    return -(-len(lengths) // rows)


def key(label: str, **style: Any) -> Line2D:
    """An entry of a legend that no single line stands for."""
    from matplotlib.lines import Line2D

    return Line2D([], [], label=label, **style)


def colour_bar(on: Canvas, mappable: ScalarMappable, label: str, **options: Any) -> None:
    bar = on.ax.figure.colorbar(mappable, ax=on.ax, label=label, **options)
    if on.own:
        bar.outline.set_linewidth(0.6)
        keep_ticks(bar.ax)


def framed(on: Canvas) -> None:
    """All four sides, around a map."""
    if on.own:
        for side in ("top", "right"):
            on.ax.spines[side].set_visible(True)


def shades(count: int) -> list[str]:
    """Colours of many lines in an order, from dark to light."""
    from matplotlib import colormaps
    from matplotlib.colors import to_hex

    return [to_hex(colormaps["viridis"](x)) for x in np.linspace(0.0, 0.92, count)]


def colours(count: int) -> list[str]:
    """As many colours, of the palette as long as it has them."""
    return list(COLOURS[:count]) if count <= len(COLOURS) else shades(count)


def marks_every(points: int) -> int:
    """So that a line carries about ten marks."""
    return max(1, -(-points // 10))


def thread_axis(ax: Axes, threads: int) -> None:
    """Whole threads, the first among the ticks."""
    if np.isfinite(ax.dataLim.x1):
        threads = max(threads, int(ax.dataLim.x1))
    step = 1 if threads <= 10 else 5 if threads <= 40 else 10 * -(-threads // 100)
    ticks = [1, *range(step, threads + 1, step)] if step > 1 else list(range(1, threads + 1))
    ax.set_xticks(ticks)
    ax.set_xlim(0.4, threads + 0.6)
    ax.set_xlabel("Thread, from the loaded end of the screw")


def numbers(values: Any) -> npt.NDArray[np.float64]:
    """An array of a document; what it does not define is NaN."""
    return np.asarray(values, dtype=np.float64)


def note(on: Canvas, notes: list[str]) -> None:
    if notes:
        on.ax.set_title(", ".join(notes), fontsize=7.5, loc="left")
