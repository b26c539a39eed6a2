"""What notebooks show of results and designs: headlines, warnings, a small picture."""

from __future__ import annotations

import base64
import html
import io
import json
from typing import TYPE_CHECKING, Any

from rollerscrew import _engine

if TYPE_CHECKING:
    from rollerscrew.designs import Designs
    from rollerscrew.record import Record, Result

#: Headlines: the record of a document or of its load cases, and quantities of it.
_HEADLINES = {
    "": ("status", "axial_force_N", "axial_displacement_um", "axial_stiffness_N_per_um"),
    "screw": ("peak_pressure_MPa",),
    "nut": ("peak_pressure_MPa",),
    "slip": ("status", "slip_ratio", "efficiency", "power_loss_W"),
    "life": ("l10_revolutions", "static_safety"),
    "preload": ("lost_motion_um",),
    "measures": ("dynamic_capacity_kN", "static_capacity_kN", "weight_kg"),
}
_MOST_ROWS = 8
_MOST_WARNINGS = 5


def result_html(result: Result) -> str:
    """A table of headlines, one row per load case, the warnings, and the first picture."""
    rows: list[tuple[str, Record]] = [
        (str(case["name"]), case) for case in result.get("load_cases", [])
    ]
    of_cases = [_headlines(case) for _, case in rows[:_MOST_ROWS]]
    parts = [f"<b>{type(result).__name__}</b>"]
    if not result.converged:
        parts.append(" <b>did not converge</b>")
    whole = {
        name: value
        for block in ("life", "preload", "measures")
        if block in result
        for name, value in _shown(result[block], _HEADLINES[block]).items()
    }
    if whole:
        parts.append(_table([("", whole)]))
    if of_cases:
        names = [name for name, _ in rows]
        parts.append(_table(list(zip(names, of_cases, strict=False))))
    if len(rows) > _MOST_ROWS:
        parts.append(f"and {len(rows) - _MOST_ROWS} other load cases")
    parts += [_warnings(result.warnings), _picture(result)]
    return "".join(parts)


def designs_html(designs: Designs) -> str:
    """How many designs converged, and the first of them."""
    head = f"<b>{len(designs)} designs</b>, {int(designs.converged.sum())} converged"
    table: str = designs[: min(len(designs), _MOST_ROWS)].to_frame().to_html(border=0)
    more = len(designs) - _MOST_ROWS
    return head + table + (f"and {more} others" if more > 0 else "")


def _headlines(case: Record) -> dict[str, str]:
    shown = _shown(case, _HEADLINES[""])
    for block in ("screw", "nut", "slip"):
        if block in case:
            for name, value in _shown(case[block], _HEADLINES[block]).items():
                shown[f"{block}: {name}"] = value
    return shown


def _shown(record: Record, names: tuple[str, ...]) -> dict[str, str]:
    """Titles with units, and numbers; of arrays their greatest."""
    shown = {}
    for name in names:
        if name not in record:
            continue
        value = record[name]
        title, unit = _engine.response_title(name)
        title = f"{title}, {unit}" if unit else title
        if isinstance(value, str):
            shown[title] = value
        else:
            shown[title] = f"{float(value if isinstance(value, int | float) else value.max()):.4g}"
    return shown


def _table(rows: list[tuple[str, dict[str, str]]]) -> str:
    names = list(dict.fromkeys(name for _, row in rows for name in row))
    head = "".join(f"<th>{html.escape(name)}</th>" for name in ["", *names])
    body = "".join(
        f"<tr><th>{html.escape(of)}</th>"
        + "".join(f"<td>{html.escape(row.get(name, ''))}</td>" for name in names)
        + "</tr>"
        for of, row in rows
    )
    return f"<table><tr>{head}</tr>{body}</table>"


def _warnings(warnings: list[str]) -> str:
    lines = "".join(f"<li>{html.escape(text)}</li>" for text in warnings[:_MOST_WARNINGS])
    more = len(warnings) - _MOST_WARNINGS
    return f"<ul>{lines}</ul>" * bool(lines) + (f"and {more} other warnings" if more > 0 else "")


def _picture(result: Any) -> str:
    """The first picture that the result has, small."""
    import matplotlib
    import matplotlib.pyplot as plt

    from rollerscrew import plots

    described = json.loads(result._document.figures() or "[]")
    if not described:
        return ""
    drawn = plt.isinteractive()
    plt.ioff()
    try:
        figure: Any = plots.draw(described[0]).figure
        file = io.BytesIO()
        figure.savefig(file, format="png", dpi=80)
        plt.close(figure)
    finally:
        matplotlib.interactive(drawn)
    data = base64.b64encode(file.getvalue()).decode("ascii")
    return f'<br><img alt="{html.escape(described[0]["name"])}" src="data:image/png;base64,{data}">'
