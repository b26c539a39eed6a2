"""Many designs as points."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from rollerscrew.plots._canvas import BLUE, canvas, colour_bar
from rollerscrew.plots._names import response_name

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from rollerscrew.designs import Designs


def designs(
    answers: Designs, x: str, y: str, colour: str | None = None, ax: Axes | None = None
) -> Axes:
    """Converged designs: an input or response over another, coloured by a third.

    Names are those of the columns of `to_frame`, units included.
    """
    columns = [_column(answers, name) for name in (x, y, colour) if name is not None]
    shown = answers.converged & np.isfinite(np.column_stack(columns)).all(axis=1)
    if not shown.any():
        raise ValueError("no design converged with numbers in all of these columns")
    with canvas(ax) as on:
        if colour is None:
            on.ax.scatter(columns[0][shown], columns[1][shown], s=6, color=BLUE, linewidths=0)
        else:
            points = on.ax.scatter(
                columns[0][shown], columns[1][shown], s=6, c=columns[2][shown], linewidths=0
            )
            colour_bar(on, points, response_name(colour).label)
        on.ax.set_xlabel(response_name(x).label)
        on.ax.set_ylabel(response_name(y).label)
        return on.ax


def _column(answers: Designs, name: str) -> npt.NDArray[np.float64]:
    if name in answers.responses:
        return answers[name]
    if name not in answers.inputs:
        known = ", ".join([*answers.inputs.columns, *answers.responses])
        raise KeyError(f"no column {name!r}; there is {known}")
    column = answers.inputs[name]
    if column.dtype.kind not in "fiu":
        raise ValueError(f"{name} holds words; expected a column of numbers")
    return column.to_numpy(dtype=np.float64)
