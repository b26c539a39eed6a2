"""A hundred thousand designs in pieces by Dask: no piece knows of the others."""

import numpy as np
import pandas as pd
import rollerscrew as rs
from dask.delayed import delayed

FORCE, NUT = "load_cases[0].axial_force", "structure.nut.outer_diameter"


def answer(case: rs.Case, seed: int, count: int) -> pd.DataFrame:
    """One piece: designs drawn at random, and their answers."""
    draw = np.random.default_rng(seed).uniform
    inputs = {FORCE: (draw(5.0, 45.0, count), "kN"), NUT: (draw(44.0, 60.0, count), "mm")}
    return case.evaluate(inputs, ["axial_stiffness_N_per_um"], threads=1).to_frame()


def main(designs: int = 100_000, piece: int = 10_000) -> pd.DataFrame:
    """The mean and the extremes of the stiffness of all designs."""
    case = rs.lesson(1)
    frames = [delayed(answer)(case, k, piece) for k in range(designs // piece)]
    everything: pd.DataFrame = delayed(pd.concat)(frames).compute(scheduler="threads")
    return everything["axial_stiffness_N_per_um"].describe().to_frame()


if __name__ == "__main__":
    print(main())
