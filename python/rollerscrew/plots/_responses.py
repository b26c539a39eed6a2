"""What a study says of a response."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    from rollerscrew.record import Record
    from rollerscrew.results import StudyResult


def chosen_response(known: Sequence[str], response: str | None) -> str:
    if not known:
        raise ValueError("the study records no responses")
    if response is None:
        return known[0]
    if response not in known:
        raise KeyError(f"no response {response!r}; there is {', '.join(known)}")
    return response


def response_values(
    result: StudyResult, response: str | None
) -> tuple[str, npt.NDArray[np.float64]]:
    """A response of all designs, the base case first."""
    chosen = chosen_response(result.study.responses, response)
    designs = result.all_designs
    if len(designs) < 2:
        raise ValueError(
            "the document holds no designs: it leaves out those of large studies; run the study, "
            "or read its study.csv"
        )
    values = np.asarray(designs[chosen], dtype=np.float64)
    if not np.isfinite(values[1:]).any():
        raise ValueError(f"no design has {chosen}: all were refused or did not converge")
    return chosen, values


def of_response(result: StudyResult, block: str, response: str) -> Record | None:
    """What the summary says of a response; absent where it does not."""
    found = result.summary.get(block)
    if found is not None and block == "response_surface":
        found = found.get("responses")
    record: Record | None = None if found is None else found.get(response)
    return record


def contributions(result: StudyResult, response: str) -> list[tuple[str, float, float]]:
    """Path, signed contribution in percent, and R² of the linear surface."""
    fit = of_response(result, "response_surface", response)
    if fit is None:
        return []
    return [
        (
            factor["path"],
            float(np.copysign(factor["contribution_percent"], factor["coefficient"])),
            float(fit["r_squared"]),
        )
        for factor in fit["factors"]
    ]
