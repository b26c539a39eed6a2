"""The formulas of the engine on arrays of numpy, in SI units.

Arguments are numbers or arrays that go together as those of numpy's functions do. What has no
answer is NaN.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from rollerscrew import _engine

Array = npt.NDArray[np.float64]


class Hertz(NamedTuple):
    """An elliptic contact under load."""

    ellipticity: Array  #: b/a
    hertz_constant: Array  #: k_0 of N = k_0 delta^1.5 [N/m^1.5]
    approach: Array  #: delta [m]
    semi_major: Array  #: a [m]
    semi_minor: Array  #: b [m]
    peak_pressure: Array  #: p_0 = 3 N/(2 pi a b) [Pa]


def _rows(*arguments: npt.ArrayLike) -> tuple[Array, tuple[int, ...]]:
    """A row for each element of the arguments, and their shape."""
    arrays = np.broadcast_arrays(*(np.asarray(each, dtype=np.float64) for each in arguments))
    return np.ascontiguousarray(np.stack([each.ravel() for each in arrays], -1)), arrays[0].shape


def contact_modulus(
    youngs_modulus_1: npt.ArrayLike,
    poisson_ratio_1: npt.ArrayLike,
    youngs_modulus_2: npt.ArrayLike,
    poisson_ratio_2: npt.ArrayLike,
) -> Array:
    """E* [Pa] of two bodies: 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2; E > 0, -1 < nu <= 0.5."""
    table, shape = _rows(youngs_modulus_1, poisson_ratio_1, youngs_modulus_2, poisson_ratio_2)
    moduli = np.array([_engine.contact_modulus(*row) for row in table])
    youngs, poisson = table[:, ::2], table[:, 1::2]
    has_answer = ((youngs > 0.0) & (poisson > -1.0) & (poisson <= 0.5)).all(axis=1)
    return np.where(has_answer, moduli, np.nan).reshape(shape)


def hertz(
    kappa_1: npt.ArrayLike,
    kappa_2: npt.ArrayLike,
    contact_modulus: npt.ArrayLike,
    normal_load: npt.ArrayLike,
) -> Hertz:
    """The ellipse of two bodies whose relative principal curvatures are kappa_1 and kappa_2 [1/m].

        kappa_1/kappa_2 = (b/a)^2 D/B,   b^3 = 3 N (b/a) B/(pi kappa_2 E*),
        delta = 3 N K/(2 pi a E*),       N = k_0 delta^1.5,

    with the elliptic integrals of m = 1 - (b/a)^2; Sandu 2018, (1.80) to (1.83). E* [Pa] is
    `contact_modulus`, N >= 0 [N] the normal load. Smooth half-spaces, a and b small against the
    radii.
    """
    table, shape = _rows(kappa_1, kappa_2, contact_modulus, normal_load)
    answers = np.array(_engine.hertz(table))
    answers[~(table[:, 3] >= 0.0), 2:] = np.nan
    return Hertz(*(column.reshape(shape) for column in answers.T))


def central_film(
    viscosity: npt.ArrayLike,
    pressure_viscosity: npt.ArrayLike,
    rolling_speed: npt.ArrayLike,
    normal_load: npt.ArrayLike,
    curvature: npt.ArrayLike,
    contact_modulus: npt.ArrayLike,
    curvature_ratio: npt.ArrayLike = 1.0,
) -> Array:
    """Central film [m] of a contact that rolls along its minor axis, through all regimes.

        H = [(H_RI^(3/2) + (H_EI^-4 + H_00^-4)^(-3/8))^(2s/3) + (H_RP^-8 + H_EP^-8)^(-s/8)]^(1/s),
        h = H sqrt(U)/rho_x,   U = eta_0 |u| rho_x/(2 E*)

    Nijenbanning, Venner, Moes, Wear 176 (1994) 217. eta_0 [Pa s], alpha [1/Pa], |u| the sum of both
    surface velocities [m/s], N [N], rho_x the larger relative curvature [1/m], E* [Pa], the smaller
    curvature over the larger one. Smooth, fully flooded, isothermal, Newtonian.
    """
    table, shape = _rows(
        viscosity, pressure_viscosity, rolling_speed, normal_load, curvature, contact_modulus,
        curvature_ratio,
    )  # fmt: skip
    has_answer = (table[:, 2] >= 0.0) & (table[:, 6] > 0.0) & (table[:, 6] <= 1.0)
    return np.where(has_answer, _engine.film(table)[:, 0], np.nan).reshape(shape)


def friction_coefficient(
    viscosity: npt.ArrayLike,
    pressure_viscosity: npt.ArrayLike,
    eyring_stress: npt.ArrayLike,
    rolling_speed: npt.ArrayLike,
    sliding_speed: npt.ArrayLike,
    normal_load: npt.ArrayLike,
    curvature: npt.ArrayLike,
    contact_modulus: npt.ArrayLike,
    pressure: npt.ArrayLike,
) -> Array:
    """Friction coefficient of a lubricated contact by Jacod; Sandu 2018, (2.27), (2.29), (2.30).

        mu = tau_0/p asinh(eta_bar(p) K |v|),   K = 2/(5 H tau_0) sqrt(2 eta_0 E* rho_x/|u|)

    tau_0 [Pa] is the stress at which the lubricant begins to thin, |u| the sum of both surface
    velocities and |v| the sliding speed [m/s], p the pressure [Pa], eta_bar Roelands' ratio of
    viscosities, H the film of Sandu 2018, (2.37). Others as `central_film` has them.
    """
    table, shape = _rows(
        viscosity, pressure_viscosity, eyring_stress, rolling_speed, sliding_speed, normal_load,
        curvature, contact_modulus, pressure,
    )  # fmt: skip
    return _engine.friction(table)[:, 0].reshape(shape)


class Cycles(NamedTuple):
    """Cycles in the order in which they close."""

    range: Array
    mean: Array
    cycles: Array  #: 1, or 0.5 of a half cycle.
    start: npt.NDArray[np.int64]  #: Places of the turning points in the history.
    end: npt.NDArray[np.int64]


def rainflow(history: npt.ArrayLike, hysteresis: float = 0.0) -> Cycles:
    """Load cycles of a history by rainflow counting, ASTM E1049-85 (2017), 5.4.4.

    Swings up to `hysteresis`, in the unit of the history, are no cycles.
    """
    numbers = np.ascontiguousarray(history, dtype=np.float64)
    if numbers.ndim != 1 or not np.isfinite(numbers).all() or not hysteresis >= 0.0:
        raise ValueError("expected a history of finite numbers and a hysteresis >= 0")
    ranges, means, counts, starts, ends = _engine.rainflow(numbers, hysteresis).reshape(-1, 5).T
    return Cycles(ranges, means, counts, starts.astype(np.int64), ends.astype(np.int64))


def rating_life(capacity: npt.ArrayLike, load: npt.ArrayLike) -> Array:
    """L10 [revolutions] = 10^6 (C/F)^3 of a dynamic capacity and a load [N]; Jung 2017, (8.25)."""
    table, shape = _rows(capacity, load)
    lives = np.array([_engine.rating_life(c, f) for c, f in table])
    lives[~(table[:, 0] > 0.0) | ~(table[:, 1] >= 0.0)] = np.nan
    return lives.reshape(shape)


def mean_load(forces: npt.ArrayLike, revolutions: npt.ArrayLike) -> float:
    """Equivalent load [N], F_m = (sum |F_j|^3 n_j / sum n_j)^(1/3); Jung 2017, (8.28)."""
    table, _ = _rows(forces, revolutions)
    if not (table[:, 1] >= 0.0).all() or not table[:, 1].any():
        return float("nan")
    return _engine.mean_load(np.ascontiguousarray(table[:, 0]), np.ascontiguousarray(table[:, 1]))
