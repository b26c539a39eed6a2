"""Several pictures in the same axes, and what a notebook shows of axes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Dashes of lines that had colours of their own.
_DASHES = ("solid", "dashed", "dotted", "dash_dotted")

#: Colours of what is no data.
_QUIET = ("reference", "muted", "grey")

#: Attributes of axes: keys of the legend so far, the titles, the limits without the legend's room.
KEYS, TITLES = "_rollerscrew_keys", "_rollerscrew_titles"
LIMITS = "_rollerscrew_limits"


def was_drawn(ax: Axes) -> bool:
    """Whether a picture stands in the axes already."""
    return hasattr(ax, TITLES)


def next_colour(ax: Axes) -> Any:
    """The next colour of the cycle of the axes."""
    lines: Any = ax
    return lines._get_lines.get_next_color()


def relabelled(description: Mapping[str, Any], label: str | None, color: Any) -> Mapping[str, Any]:
    """The description with one colour, and a name in its legend.

    Styles that differ in their colour alone get dashes of their own. What marks and dashes mean
    stands in the legend in black, once in the axes.
    """
    if label is None and color is None:
        return description
    changed = dict(description)
    styles = [dict(style) for style in description.get("styles", [])]
    legend = list(description.get("legend", []))
    drawn = [series["style"] for series in description["panels"][0].get("series", [])]
    if color is not None:
        looks: dict[tuple[Any, ...], list[Any]] = {}
        panel = description["panels"][0]
        marked = {reference["style"] for reference in panel.get("references", [])}
        for place, style in enumerate(styles):
            named = style.get("colour", "ink")
            if named in _QUIET or (place in marked and place not in drawn):
                continue
            look = tuple(style.get(key) for key in ("shape", "dash", "mark", "open", "pale"))
            alike = looks.setdefault(look, [])
            if named not in alike:
                alike.append(named)
            if alike.index(named) and style.get("dash") != "none":
                style["dash"] = _DASHES[alike.index(named) % len(_DASHES)]
            style["colour"] = color
        meanings = []
        for entry in legend:
            meaning = dict(styles[entry["style"]])
            if meaning.get("colour") is color:
                meaning["colour"] = "ink"
            styles.append(meaning)
            meanings.append({**entry, "style": len(styles) - 1})
        legend = meanings if len(legend) > 1 else []
    if label is not None:
        legend = [{"style": style, "title": label} for style in drawn[:1]] + (
            legend if len(legend) > 1 else []
        )
    changed["styles"], changed["legend"] = styles, legend
    return changed


@contextmanager
def limits_of_both(ax: Axes) -> Iterator[None]:
    """Limits that hold what stands in the axes and what is drawn into them."""
    leave_room(ax)
    before = [sorted(ax.get_xlim()), sorted(ax.get_ylim())] if was_drawn(ax) else None
    yield
    if before is None:
        return
    for (low, high), which in zip(before, "xy", strict=True):
        limits: Any = getattr(ax, f"set_{which}lim")
        first, last = getattr(ax, f"get_{which}lim")()
        ends = min(low, first, last), max(high, first, last)
        limits(*(ends if first <= last else ends[::-1]))


def leave_room(ax: Axes) -> None:
    """Takes back the room that the limits had made for the legend, where they still do."""
    limits, raised = getattr(ax, LIMITS, (None, None))
    if limits is not None and ax.get_ylim() == raised:
        ax.set_ylim(limits, auto=None)


def shown_once(ax: Axes) -> Axes:
    """The axes, of which a notebook shows the picture alone: no line of text after it."""
    ax._ipython_display_ = _shown  # type: ignore[attr-defined]
    return ax


def _shown() -> None:
    """The backend of a notebook shows figures by itself."""
