"""Stiffness against the nut's length, by NSGA-II of pymoo: each population is one call."""

from typing import Any

import numpy as np
import numpy.typing as npt
import rollerscrew as rs
from pymoo.algorithms.moo.nsga2 import NSGA2
from pymoo.core.problem import Problem
from pymoo.optimize import minimize

INPUTS = {"structure.nut.outer_diameter": "mm", "structure.screw.bore": "mm"}
LEAST, MOST = [44.0, 0.0], [60.0, 12.0]


class Screw(Problem):  # type: ignore[misc]
    """Stiff, and of little material."""

    def __init__(self, case: rs.Case) -> None:
        super().__init__(n_var=len(INPUTS), n_obj=2, xl=np.array(LEAST), xu=np.array(MOST))
        self.stiffness = case.function(
            INPUTS, ["axial_stiffness_N_per_um", "measures.material_volume_cm3"], "measures"
        )

    def _evaluate(
        self, x: npt.NDArray[np.float64], out: dict[str, Any], *_: Any, **__: Any
    ) -> None:
        answers = self.stiffness(x)
        stiffness = np.where(np.isnan(answers[:, 0]), 0.0, answers[:, 0])
        volume = np.where(np.isnan(answers[:, 1]), 1e9, answers[:, 1])
        out["F"] = np.column_stack([-stiffness, volume])


def main(generations: int = 20, population: int = 40) -> npt.NDArray[np.float64]:
    """Stiffness [N/um] and volume [cm^3] of the front."""
    found = minimize(
        Screw(rs.lesson(1)), NSGA2(pop_size=population), ("n_gen", generations), seed=1
    )
    front: npt.NDArray[np.float64] = np.asarray(found.F) * [-1.0, 1.0]
    return front[np.argsort(front[:, 0])]


if __name__ == "__main__":
    for stiffness, volume in main()[::5]:
        print(f"{stiffness:8.1f} N/um  {volume:6.1f} cm^3")
