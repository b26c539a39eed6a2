"""Which tolerance moves the stiffness and the pressure most: Sobol' indices by SALib."""

import numpy as np
import rollerscrew as rs
from SALib.analyze import sobol as analysis
from SALib.sample import sobol as samples

#: Inputs with the units and the ends of what they vary in.
RANGES = {
    "mechanism.flank_angle": ("deg", 44.0, 46.0),
    "materials.youngs_modulus": ("GPa", 200.0, 212.0),
    "load_cases[0].axial_force": ("kN", 9.0, 11.0),
}
RESPONSES = ["axial_stiffness_N_per_um", "screw.peak_pressure_MPa.max"]


def main(samples_of_each: int = 256) -> dict[str, dict[str, float]]:
    """First-order indices of each response by each input."""
    case = rs.lesson(4)
    bounds = [list(ends) for _, *ends in RANGES.values()]
    problem = {"num_vars": len(RANGES), "names": list(RANGES), "bounds": bounds}
    x = samples.sample(problem, samples_of_each, calc_second_order=False, seed=1)
    inputs = {path: (x[:, k], unit) for k, (path, (unit, *_)) in enumerate(RANGES.items())}
    designs = case.evaluate(inputs, RESPONSES)
    assert designs.converged.all()
    indices: dict[str, dict[str, float]] = {}
    for response in RESPONSES:
        found = analysis.analyze(
            problem, np.array(designs[response]), calc_second_order=False, seed=1
        )
        indices[response] = dict(zip(RANGES, map(float, found["S1"]), strict=True))
    return indices


if __name__ == "__main__":
    for response, by in main().items():
        print(response, {path: round(index, 3) for path, index in by.items()})
