"""Pictures of lives and load cycles."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from rollerscrew.plots._canvas import (
    BLUE,
    REFERENCE,
    VERMILLION,
    canvas,
    colour_bar,
    framed,
    key,
    legend,
    numbers,
    thread_axis,
)
from rollerscrew.plots._cases import INTERFACES, SIDES
from rollerscrew.plots.loads import INTERFACE_STYLES

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from rollerscrew.records import Life

_DIRECTIONS = {"tension": (BLUE, "o"), "compression": (VERMILLION, "s")}

#: Threads that hardly ever carry would press the others together.
_LARGEST_RATIO = 1e5


def thread_lives(life: Life, ax: Axes | None = None) -> Axes:
    """Basic rating life L10 of each thread in revolutions, and that of the mechanism."""
    directions = [direction for direction in _DIRECTIONS if direction in life]
    if not life.converged or not directions:
        raise ValueError(
            f"there are no lives of threads: {life.get('status', 'no direction carries load')}"
        )
    with canvas(ax) as on:
        handles: list[Artist] = []
        threads = 0
        all_lives = []
        for direction in directions:
            colour, marker = _DIRECTIONS[direction]
            for side in INTERFACES:
                lives = numbers(life[direction][side].l10_revolutions)
                lives = np.where(np.isfinite(lives), lives, np.nan)
                threads = max(threads, len(lives))
                all_lives.append(lives)
                on.ax.plot(
                    np.arange(1, len(lives) + 1),
                    lives,
                    color=colour,
                    marker=marker,
                    label=f"{direction}, {SIDES[side]}",
                    **INTERFACE_STYLES[side],
                )
            handles.append(key(direction, color=colour, marker=marker))
        for side in INTERFACES:
            handles.append(key(SIDES[side], color="black", marker="o", **INTERFACE_STYLES[side]))
        system = life.system.get("l10_revolutions") if "system" in life else None
        if system is not None:
            line = on.ax.axhline(system, label="mechanism", **REFERENCE)
            handles.append(line)
        on.ax.set_yscale("log")
        lives = np.concatenate([*all_lives, [np.nan if system is None else system]])
        if np.isfinite(lives).any():
            least = float(np.nanmin(lives))
            on.ax.set_ylim(0.7 * least, min(1.4 * float(np.nanmax(lives)), _LARGEST_RATIO * least))
        thread_axis(on.ax, threads)
        on.ax.set_ylabel("Life L10 (revolutions)")
        legend(on, handles)
        return on.ax


def cycles(life: Life, ax: Axes | None = None) -> Axes:
    """Rainflow matrix: cycles of the axial load over their mean and range in kN."""
    if "cycles" not in life or "matrix" not in life.cycles:
        raise ValueError("there are no load cycles: expected a load history, not a spectrum")
    matrix = life.cycles.matrix
    count = numbers(matrix.count)
    if count.ndim != 2 or not (count > 0.0).any():
        raise ValueError("the load history has no cycles")
    from matplotlib.colors import LogNorm
    from matplotlib.ticker import FormatStrFormatter, LogLocator

    ranges = np.linspace(0.0, matrix.range_to_N, count.shape[0] + 1) / 1e3
    means = np.linspace(matrix.mean_from_N, matrix.mean_to_N, count.shape[1] + 1) / 1e3
    largest = float(count.max())
    least = float(count[count > 0.0].min())
    with canvas(ax, height_mm=68.0) as on:
        mesh = on.ax.pcolormesh(
            means,
            ranges,
            np.ma.masked_less_equal(count, 0.0),
            norm=LogNorm(least, largest if largest > least else 10.0 * least),
            cmap="viridis_r",
            rasterized=True,
        )
        on.ax.set_xlabel("Mean load (kN), compression < 0 < tension")
        on.ax.set_ylabel("Range of the load (kN)")
        colour_bar(
            on, mesh, "Cycles", ticks=LogLocator(subs=(1, 2, 5)), format=FormatStrFormatter("%g")
        )
        framed(on)
        return on.ax


__all__ = ["cycles", "thread_lives"]
