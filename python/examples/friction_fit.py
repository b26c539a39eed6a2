"""A friction coefficient from measured efficiencies: least squares by scipy.

The measurements are made up here, of a known coefficient with scatter, so that the fit can be seen
to find it; yours take their place.
"""

import numpy as np
import rollerscrew as rs
from scipy.optimize import least_squares

SPEEDS = np.array([50.0, 100.0, 200.0, 400.0])  #: [rpm]
FRICTION, SPEED = "friction.model.coulomb", "operation.speed"


def main(coefficient: float = 0.08, scatter: float = 0.002) -> tuple[float, float]:
    """The coefficient that fits, and its standard deviation."""
    case = rs.lesson(9).with_({"friction": {"model": {"coulomb": 0.1}}})
    f = case.function({FRICTION: "", SPEED: "rpm"}, ["slip.efficiency"], "slip")

    def efficiencies(mu: float) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
        return f(np.column_stack([np.full_like(SPEEDS, mu), SPEEDS]))[:, 0]

    noise = np.random.default_rng(1).normal(0.0, scatter, SPEEDS.size)
    measured = efficiencies(coefficient) + noise
    fit = least_squares(lambda mu: efficiencies(mu[0]) - measured, x0=[0.1], bounds=(0.01, 0.3))
    variance = (fit.fun**2).sum() / (SPEEDS.size - 1) / (fit.jac**2).sum()
    return float(fit.x[0]), float(np.sqrt(variance))


if __name__ == "__main__":
    found, deviation = main()
    print(f"friction coefficient {found:.4f} +- {deviation:.4f}")
