"""Several pictures in the same axes, and what a notebook shows of axes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Dashes of lines that had colours of their own.
_DASHES = ("solid", "dashed", "dotted", "dash_dotted")

#: Attributes of axes: keys of the legend so far, and the titles.
KEYS, TITLES = "_rollerscrew_keys", "_rollerscrew_titles"


def was_drawn(ax: Axes) -> bool:
    """Whether a picture stands in the axes already."""
    return hasattr(ax, TITLES)


def next_colour(ax: Axes) -> Any:
    """The next colour of the cycle of the axes."""
    lines: Any = ax
    return lines._get_lines.get_next_color()


def relabelled(description: Mapping[str, Any], label: str | None, color: Any) -> Mapping[str, Any]:
    """The description with one colour, and a name before each entry of its legend."""
    if label is None and color is None:
        return description
    changed = dict(description)
    if color is not None:
        dashes: dict[tuple[Any, Any], str] = {}
        styles = []
        for style in description.get("styles", []):
            style = dict(style)
            if style.get("colour") not in ("reference", "muted", "grey"):
                look = (style.get("colour"), style.get("dash", "solid"))
                if style.get("dash") != "none":
                    style["dash"] = dashes.setdefault(look, _DASHES[len(dashes) % len(_DASHES)])
                style["colour"] = color
            styles.append(style)
        changed["styles"] = styles
    if label is not None:
        legend = list(description.get("legend", []))
        if len(legend) > 1:
            legend = [{**entry, "title": f"{label}: {entry['title']}"} for entry in legend]
        else:
            drawn = [series["style"] for series in description["panels"][0].get("series", [])]
            legend = [{"style": style, "title": label} for style in drawn[:1]]
        changed["legend"] = legend
    return changed


@contextmanager
def limits_of_both(ax: Axes) -> Iterator[None]:
    """Limits that hold what stands in the axes and what is drawn into them."""
    before = [sorted(ax.get_xlim()), sorted(ax.get_ylim())] if was_drawn(ax) else None
    yield
    if before is None:
        return
    for (low, high), which in zip(before, "xy", strict=True):
        limits: Any = getattr(ax, f"set_{which}lim")
        first, last = getattr(ax, f"get_{which}lim")()
        ends = min(low, first, last), max(high, first, last)
        limits(*(ends if first <= last else ends[::-1]))


def shown_once(ax: Axes) -> Axes:
    """The axes, of which a notebook shows the picture alone: no line of text after it."""
    ax._ipython_display_ = _shown  # type: ignore[attr-defined]
    return ax


def _shown() -> None:
    """The backend of a notebook shows figures by itself."""
