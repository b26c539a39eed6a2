"""What notebooks show of results and designs: headlines, warnings, a small picture."""

from __future__ import annotations

import base64
import html
import io
import json
import reprlib
from typing import TYPE_CHECKING, Any, cast

from rollerscrew import _engine
from rollerscrew.record import in_words

if TYPE_CHECKING:
    from rollerscrew.case import Case
    from rollerscrew.designs import Designs
    from rollerscrew.record import Record, Result
    from rollerscrew.results import CheckResult

#: Headlines: the record of a document or of its load cases, and quantities of it.
_HEADLINES = {
    "": ("status", "loads", "axial_force_N", "axial_displacement_um", "axial_stiffness_N_per_um"),
    "screw": ("peak_pressure_MPa",),
    "nut": ("peak_pressure_MPa",),
    "slip": ("status", "slip_ratio", "efficiency", "power_loss_W"),
    "life": ("static_safety",),
    "system": ("l10_revolutions", "l10_hours"),
    "preload": ("lost_motion_um",),
    "measures": ("dynamic_capacity_N", "static_capacity_N", "weight_kg"),
}
_MOST_ROWS = 8
_MOST_WARNINGS = 5


def case_html(case: Case) -> str:
    """The mechanism, what it is changed from and ready for, the warnings."""
    checked = case.check()
    changes = "".join(f"<li>{html.escape(each)}</li>" for each in case.overrides)
    mechanism = {
        value.path.removeprefix("mechanism."): value.value
        for value in checked.input
        if value.path.startswith("mechanism.") and not value.default
    }
    rows = [(name, {"": value}) for name, value in mechanism.items()]
    head = f"<b>{html.escape(case.name)}</b>" + f", changed:<ul>{changes}</ul>" * bool(changes)
    return head + _table(rows) + _readiness(checked) + _warnings(checked.warnings)


def _readiness(checked: CheckResult) -> str:
    ready, lacks = [], []
    for command, state in checked.commands.items():
        if state["ready"]:
            ready.append(command)
        else:
            why = [
                f"{said} {', '.join(state[key])}"
                for key, said in (("missing", "lacks"), ("wrong", "to change:"))
                if key in state
            ]
            lacks.append(f"{command} ({'; '.join(why)})")
    return html.escape(f"ready for {', '.join(ready)}; not for {', '.join(lacks) or 'none'}")


def _verdict(checked: CheckResult) -> str:
    verdict = checked.verdict
    if verdict is None:
        return _readiness(checked)
    rows = []
    for criterion in verdict.criteria:
        value, limit = criterion.get("value"), criterion.get("limit")
        rows.append(
            (
                str(criterion["title"]),
                {
                    "state": str(criterion["state"]).replace("_", " "),
                    "value": "" if value is None else f"{value:.4g}",
                    "limit": "" if limit is None else f"{limit:.4g}",
                    "unit": str(criterion.get("unit", "")),
                    "reason": str(criterion.get("reason", "")),
                },
            )
        )
    return f": {html.escape(str(verdict.state))}{_table(rows)}{_readiness(checked)}"


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
    system = result["life"].get("system") if "life" in result else None
    if system is not None:
        whole = _shown(system, _HEADLINES["system"]) | whole
    if whole:
        parts.append(_table([("", whole)]))
    if of_cases:
        names = [name for name, _ in rows]
        parts.append(_table(list(zip(names, of_cases, strict=False))))
    if len(rows) > _MOST_ROWS:
        parts.append(f"and {len(rows) - _MOST_ROWS} other load cases")
    if result.command == "check":
        parts.append(_verdict(cast("CheckResult", result)))
    for frame in ("front_frame", "statistics_frame"):
        if hasattr(type(result), frame):
            table = getattr(result, frame)()
            parts.append(table.head(_MOST_ROWS).to_html(border=0))
            more = len(table) - _MOST_ROWS
            parts.append(f"and {more} others" if more > 0 else "")
    parts += [_warnings(result.warnings), _picture(result)]
    return "".join(parts)


def record_html(record: Record) -> str:
    """The numbers and words of a record, one row each; of a load case its headlines and picture."""
    if type(record).__name__ == "LoadCase":
        warnings = _warnings(record.get("warnings", []))
        table = _table([(str(record["name"]), _headlines(record))])
        return f"<b>load case</b>{table}{warnings}{_picture_of_case(record)}"
    rows = []
    for name, value in record.items():
        title, unit = _engine.response_title(name)
        if hasattr(value, "ndim") and value.size:
            shown = f"{value.size} numbers from {value.min():.4g} to {value.max():.4g}"
        elif isinstance(value, float):
            shown = f"{value:.4g}"
        else:
            shown = str(value) if isinstance(value, str | int) else reprlib.repr(value)
        rows.append((name, {"": title, "value": shown, "unit": unit}))
    return f"<b>{type(record).__name__}</b>{_table(rows)}"


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
            shown[title] = in_words(value)
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
    described = result.figures()
    return _small(described[0]) if described else ""


def _picture_of_case(case: Record) -> str:
    """The load distribution of a load case, small; nothing where it has none."""
    result: Any = case._owner
    if result is None or not hasattr(result, "_document"):
        return ""
    names = [str(each["name"]) for each in result["load_cases"]]
    chosen = json.dumps({"load_cases": [names.index(str(case["name"]))]})
    try:
        described = result._pictured().figure("load_distribution", chosen, False)
    except ValueError:
        return ""
    return _small(json.loads(described))


def _small(described: dict[str, Any]) -> str:
    import matplotlib
    import matplotlib.pyplot as plt

    from rollerscrew import plots

    drawn = plt.isinteractive()
    plt.ioff()
    try:
        figure: Any = plots.draw(described).figure
        file = io.BytesIO()
        figure.savefig(file, format="png", dpi=80)
        plt.close(figure)
    finally:
        matplotlib.interactive(drawn)
    data = base64.b64encode(file.getvalue()).decode("ascii")
    return f'<br><img alt="{html.escape(described["name"])}" src="data:image/png;base64,{data}">'
