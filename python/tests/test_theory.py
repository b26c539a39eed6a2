"""The formulas on arrays: closed forms, and what the engine computes with them."""

from __future__ import annotations

import numpy as np
import pytest
from conftest import lesson
from rollerscrew import theory


def test_spheres_on_spheres() -> None:
    """Closed form: a^3 = 3 N R/(4 E*), delta = a^2/R, p_0 = 3 N/(2 pi a^2)."""
    modulus = theory.contact_modulus(210e9, 0.3, 210e9, 0.3)
    assert modulus == pytest.approx(210e9 / (2.0 * (1.0 - 0.3**2)), rel=1e-14)
    radius, load = 5e-3, np.array([[1.0, 10.0], [100.0, 1000.0]])
    contact = theory.hertz(1.0 / radius, 1.0 / radius, modulus, load)
    a = np.cbrt(3.0 * load * radius / (4.0 * modulus))
    np.testing.assert_allclose(contact.semi_major, a, rtol=1e-13)
    np.testing.assert_allclose(contact.approach, a**2 / radius, rtol=1e-13)
    np.testing.assert_allclose(contact.peak_pressure, 1.5 * load / (np.pi * a**2), rtol=1e-13)
    assert np.isnan(theory.hertz(-1.0, 1.0, modulus, 1.0).peak_pressure)


def test_contacts_are_those_of_a_screw() -> None:
    case = lesson(7)
    result = case.contact()
    assert result.contact is not None
    nut, loads = result.contact.nut, result.load_cases[0].nut
    assert loads is not None and loads.normal_load_N is not None
    assert nut.relative_curvatures_per_mm is not None and nut.ellipticity is not None
    kappa = 1e3 * nut.relative_curvatures_per_mm
    youngs = 1e9 * case.number("materials.youngs_modulus", "GPa")
    poisson = case.number("materials.poisson_ratio")
    modulus = theory.contact_modulus(youngs, poisson, youngs, poisson)
    contact = theory.hertz(kappa[0], kappa[1], modulus, loads.normal_load_N)
    np.testing.assert_allclose(contact.ellipticity, nut.ellipticity, rtol=1e-12)
    np.testing.assert_allclose(1e-6 * contact.peak_pressure, loads.peak_pressure_MPa, rtol=1e-9)


def test_films_and_friction() -> None:
    speeds = np.array([0.1, 0.2, 0.4])
    film = theory.central_film(0.1, 2e-8, speeds, 100.0, 200.0, 115e9, [0.5, 0.5, 0.5])
    assert (np.diff(np.log(film)) / np.log(2.0) == pytest.approx([0.67, 0.67], abs=0.1)) is True
    common = (0.1, 2e-8, 5e6, 0.2)
    friction = theory.friction_coefficient(*common, [0.0, 1e-3, 1e-2], 100.0, 200.0, 115e9, 1e9)
    assert friction[0] == 0.0 and (np.diff(friction) > 0.0).all()


def test_rainflow_of_the_standard() -> None:
    """ASTM E1049-85, 5.4.5.2, figure 6: ranges 3, 4, 8, 9, 8 and 6 with counts."""
    found = theory.rainflow([-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0])
    assert found.range.tolist() == [3.0, 4.0, 4.0, 8.0, 9.0, 8.0, 6.0]
    assert found.cycles.tolist() == [0.5, 0.5, 1.0, 0.5, 0.5, 0.5, 0.5]
    assert found.start.tolist()[2] == 4 and found.end.tolist()[2] == 5
    assert theory.rainflow([1.0, 1.0]).range.size == 0
    with pytest.raises(ValueError, match="expected a history"):
        theory.rainflow([np.nan])


def test_lives() -> None:
    np.testing.assert_allclose(theory.rating_life(60e3, [60e3, 30e3]), [1e6, 8e6])
    assert theory.mean_load([1.0, 2.0], [1.0, 1.0]) == pytest.approx(np.cbrt(4.5))


def test_what_has_no_answer_is_not_a_number() -> None:
    assert np.isnan(theory.rating_life([1e5, -1.0], [-1.0, 1e4])).all()
    assert theory.rating_life(1e5, 0.0) == np.inf
    assert np.isnan(theory.mean_load([1.0, 2.0], [0.0, 0.0]))
    assert np.isnan(theory.mean_load([1.0, 2.0], [-1.0, 5.0]))


def test_moduli_of_arrays() -> None:
    youngs = np.array([105e9, 210e9])
    moduli = theory.contact_modulus(youngs, 0.3, youngs, 0.3)
    np.testing.assert_allclose(moduli, youngs / (2.0 * (1.0 - 0.3**2)))
    assert np.isnan(theory.contact_modulus([-1.0, 1.0, 1.0], [0.3, 0.6, -1.0], 1.0, 0.3)).all()


def test_contacts_that_cannot_be_are_not_numbers() -> None:
    pulled = theory.hertz(100.0, 50.0, 1e11, [0.0, -1.0])
    assert np.isfinite(pulled.hertz_constant).all()
    for values in pulled[2:]:
        assert values[0] == 0.0 and np.isnan(values[1])
    film = theory.central_film(0.1, 2e-8, [-1.0, 1.0], 100.0, 200.0, 115e9, [1.0, 2.0])
    assert np.isnan(film).all()
