"""The stiffest screw at a pressure of 2 GPa, by scipy with exact derivatives."""

import numpy as np
import rollerscrew as rs
from scipy.optimize import Bounds, NonlinearConstraint, OptimizeResult, minimize

INPUTS = {"mechanism.flank_angle": "deg", "load_cases[0].axial_force": "kN"}
RESPONSES = ["axial_stiffness_N_per_um", "screw.peak_pressure_MPa.max"]


def main(most_pressure: float = 2000.0) -> OptimizeResult:
    """The largest stiffness that keeps the pressure [MPa]."""
    f = rs.lesson(4).function(INPUTS, RESPONSES)
    pressure = NonlinearConstraint(
        lambda x: f(x)[1] / most_pressure,
        -np.inf,
        1.0,
        jac=lambda x: f.jacobian(x)[1] / most_pressure,
    )
    return minimize(
        lambda x: -f(x)[0] / 1e3,
        x0=f.x0,
        jac=lambda x: -f.jacobian(x)[0] / 1e3,
        bounds=Bounds([40.0, 1.0], [50.0, 60.0]),
        constraints=[pressure],
        method="SLSQP",
    )


if __name__ == "__main__":
    best = main()
    print(f"{-1e3 * best.fun:.1f} N/um at {best.x[0]:.2f} deg and {best.x[1]:.2f} kN")
