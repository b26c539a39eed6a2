"""Pictures of what matters: elasticities, contributions, scatter."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from rollerscrew.plots._canvas import (
    BLUE,
    DASHES,
    ORANGE,
    SKY,
    VERMILLION,
    WIDE,
    Canvas,
    canvas,
    legend,
    numbers,
    sentence,
    shown,
)
from rollerscrew.plots._names import path_texts, response_name
from rollerscrew.plots._responses import (
    chosen_response,
    contributions,
    of_response,
)

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes

    from rollerscrew.record import Record
    from rollerscrew.results import StudyResult

_MOST_BARS = 14


def elasticities(frame: pd.DataFrame, response: str | None = None, ax: Axes | None = None) -> Axes:
    """What 1 % of each factor does to a response, in percent; `frame` has a row a factor."""
    known = list(dict.fromkeys(frame["response"])) if len(frame) else []
    chosen = chosen_response(known, response)
    if "percent_per_percent" not in frame:
        raise ValueError(f"{chosen} has no elasticities: factors or response are 0 in the file")
    rows = frame[(frame["response"] == chosen) & frame["percent_per_percent"].notna()]
    if rows.empty:
        raise ValueError(f"{chosen} has no elasticities: factors or response are 0 in the file")
    values = rows["percent_per_percent"].to_numpy(dtype=np.float64)
    label = f"Change of {response_name(chosen).text} by +1 % of a factor (%)"
    return _ranked_bars(path_texts(rows["path"]), values, label, ax)


def study_histogram(
    result: StudyResult, response: str | None = None, ax: Axes | None = None
) -> Axes:
    """How many designs have which value of a response, with its 5, 50 and 95 % quantiles."""
    chosen = chosen_response(result.study.responses, response)
    statistics = result.summary.statistics.get(chosen)
    if statistics is None or "histogram" not in statistics:
        raise ValueError(f"{chosen} has no histogram: fewer than two designs, or all of one value")
    histogram = statistics.histogram
    counts = numbers(histogram.counts)
    edges = np.linspace(histogram["from"], histogram.to, len(counts) + 1)
    with canvas(ax) as on:
        on.ax.stairs(counts, edges, fill=True, color=SKY, label="designs")
        on.ax.stairs(counts, edges, color="black", linewidth=0.4)
        handles: list[Artist] = []
        marks = (
            ("0.05", DASHES[1], "5 %"),
            ("0.5", DASHES[0], "median"),
            ("0.95", DASHES[2], "95 %"),
        )
        for probability, dashes, name in marks:
            if probability in statistics.quantiles:
                value = statistics.quantiles[probability]
                handles.append(
                    on.ax.axvline(
                        value, color="black", linestyle=dashes, linewidth=0.9,
                        label=f"{name}: {value:.4g}",
                    )
                )  # fmt: skip
        base = _base_value(result, chosen)
        if base is not None and edges[0] <= base <= edges[-1]:
            handles += on.ax.plot(
                [base], [0.0], marker="^", linestyle="none", color=VERMILLION, markersize=6,
                clip_on=False, label=f"as in the file: {base:.4g}", zorder=4,
            )  # fmt: skip
        on.ax.set_ylim(0.0, 1.06 * counts.max())
        on.ax.set_xlabel(response_name(chosen).label)
        on.ax.set_ylabel("Designs")
        legend(on, handles)
        return on.ax


def _base_value(result: StudyResult, response: str) -> float | None:
    designs = result.all_designs
    if not len(designs) or not np.isfinite(designs[response][0]):
        return None
    return float(designs[response][0])


def study_contributions(
    result: StudyResult, response: str | None = None, ax: Axes | None = None
) -> Axes:
    """What each factor contributes to a response, in percent.

    Of a linear surface 100 |b| / sum |b| with the sign of b; of variance-based indices the shares
    of the variance, alone and with interactions.
    """
    chosen = chosen_response(result.study.responses, response)
    labels = {factor["path"]: factor["label"] for factor in result.study.factors}
    if indices := of_response(result, "sobol_indices", chosen):
        return _variance_bars(indices, labels, ax)
    found = contributions(result, chosen)
    if not found:
        reason = _surfaces(result).get("reason") if "response_surface" in result.summary else None
        raise ValueError(
            f"{chosen} has no linear surface: "
            + (reason or "expected a plan that draws samples, such as latin_hypercube")
        )
    values = np.array([value for _, value, _ in found])
    label = f"Contribution to {shown(response_name(chosen).text, 40)} (%)"
    title = f"linear surface, R² = {found[0][2]:.4f}"
    return _ranked_bars([labels[path] for path, _, _ in found], values, label, ax, title)


def _surfaces(result: StudyResult) -> Record:
    surfaces: Record = result.summary.response_surface
    return surfaces


def _variance_bars(indices: Record, labels: dict[str, str], ax: Axes | None) -> Axes:
    factors = list(indices["factors"])
    if not factors:
        raise ValueError("the response does not vary: there are no shares of its variance")
    factors.sort(key=lambda factor: -float(factor["total"]["value"]))
    factors = factors[:_MOST_BARS]
    places = np.arange(len(factors))
    with canvas(ax, WIDE, 20.0 + 6.0 * len(factors)) as on:
        handles: list[Artist] = []
        for name, offset, label, colour in (
            ("first", -0.2, "alone", BLUE),
            ("total", 0.2, "with interactions", ORANGE),
        ):
            bars = on.ax.barh(
                places + offset,
                [100.0 * factor[name]["value"] for factor in factors],
                0.38,
                xerr=[100.0 * factor[name].get("half_width_95", 0.0) for factor in factors],
                error_kw={"elinewidth": 0.7, "capsize": 1.5},
                color=colour,
                edgecolor="black",
                linewidth=0.4,
                label=label,
            )
            handles.append(bars)  # type: ignore[arg-type]
        _bar_names(on, [labels[factor["path"]] for factor in factors])
        on.ax.axvline(0.0, color="black", linewidth=0.6)
        on.ax.set_xlabel("Share of the variance (%), with 95 % intervals")
        legend(on, handles)
        return on.ax


def _ranked_bars(
    names: Sequence[str],
    values: npt.NDArray[np.float64],
    label: str,
    ax: Axes | None,
    title: str | None = None,
) -> Axes:
    """Signed bars, the longest on top, with their numbers."""
    order = np.argsort(-np.abs(values), kind="stable")[:_MOST_BARS]
    values = values[order]
    span = float(np.abs(values).max()) or 1.0
    with canvas(ax, 110.0, 14.0 + 4.6 * len(order)) as on:
        places = np.arange(len(order))
        falls = values < 0.0
        handles: list[Artist] = []
        for sign, colour, hatch, name in (
            (~falls, BLUE, "", "rises with the factor"),
            (falls, VERMILLION, "////", "falls"),
        ):
            if sign.any():
                bars = on.ax.barh(
                    places[sign], values[sign], 0.68, color=colour, hatch=hatch,
                    edgecolor="black", linewidth=0.4, label=name,
                )  # fmt: skip
                handles.append(bars)  # type: ignore[arg-type]
        for place, value in enumerate(values.tolist()):
            gap = 0.02 * span
            on.ax.text(
                value - gap if value < 0.0 else value + gap,
                place,
                f"{value:.3g}".replace("-", "−") if abs(value) >= 5e-4 else "0",
                ha="right" if value < 0.0 else "left",
                va="center",
                fontsize=6.5,
            )
        _bar_names(on, [names[k] for k in order])
        on.ax.axvline(0.0, color="black", linewidth=0.6)
        low = min(0.0, float(values.min()))
        high = max(0.0, float(values.max()))
        room = 0.16 * (high - low)
        on.ax.set_xlim(low - (room if low < 0.0 else 0.0), high + (room if high > 0.0 else 0.0))
        if on.own:
            on.ax.spines["left"].set_visible(False)
        on.ax.set_xlabel(label)
        on.ax.locator_params(axis="x", nbins=6)
        legend(on, handles, title=title)
        return on.ax


def _bar_names(on: Canvas, names: Sequence[str]) -> None:
    on.ax.set_yticks(range(len(names)), [sentence(shown(name, 34)) for name in names])
    on.ax.set_ylim(len(names) - 0.4, -0.6)
    on.ax.tick_params(axis="y", length=0)


__all__ = ["elasticities", "study_contributions", "study_histogram"]
