"""Exact elastic contact of two smooth surfaces (Hertz 1881), for any ellipse. SI units.

1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2; relative curvatures kappa_1 <= kappa_2 are the eigenvalues of
the sum of both curvature tensors. With k = b/a <= 1 and m = 1 - k^2 the parameter of the elliptic integrals,

    kappa_1/kappa_2 = k^2 D/B,   b^3 = 3 N k B/(pi kappa_2 E*),   delta = 3 N K/(2 pi a E*),   p_0 = 3 N/(2 pi a b),

D = (K - E)/m, B = K - D.
"""
from math import pi, sqrt


def elliptic(m):
    """Complete elliptic integrals K(m), E(m) by the arithmetic-geometric mean."""
    a, g, s, power = 1.0, sqrt(1.0 - m), m / 2.0, 1.0
    for _ in range(8):  # each doubles the digits
        half = (a - g) / 2.0
        a, g = (a + g) / 2.0, sqrt(a * g)
        s += power * half * half
        power *= 2.0
    k = pi / (2.0 * a)
    return k, k * (1.0 - s)


def integrals(k):
    """B and D of b/a = k, 0 < k < 1: B + D = K, B + k^2 D = E, without loss of digits near the circle."""
    m = (1.0 - k) * (1.0 + k)
    if m < 1e-3:  # series of Gauss' hypergeometric function
        b = d = 0.0
        term = 1.0
        for n in range(12):  # term = ((1/2)_n/n!)^2 m^n
            d += pi / 4.0 * term * (2 * n + 1) / (n + 1)
            b += pi / 4.0 * term / (n + 1)
            term *= ((n + 0.5) / (n + 1)) ** 2 * m
        return b, d
    big_k, big_e = elliptic(m)
    d = (big_k - big_e) / m
    return big_k - d, d


def effective_modulus(e_1, nu_1, e_2, nu_2):
    return 1.0 / ((1.0 - nu_1**2) / e_1 + (1.0 - nu_2**2) / e_2)


def axis_ratio(kappa_1, kappa_2):
    """b/a by bisection: kappa_1/kappa_2 = k^2 D(k)/B(k)."""
    low, high = 1e-12, 1.0
    for _ in range(200):
        k = 0.5 * (low + high)
        b, d = integrals(k)
        if k * k * d / b < kappa_1 / kappa_2:
            low = k
        else:
            high = k
    return 0.5 * (low + high)


class Contact:
    """An elliptical contact: N = hertz_constant * approach^1.5."""

    def __init__(self, kappa_1, kappa_2, modulus):
        self.kappa, self.modulus = (kappa_1, kappa_2), modulus
        self.k = axis_ratio(kappa_1, kappa_2)
        self.b_integral, self.d_integral = integrals(self.k)
        # b^3 = 3 N k B/(pi kappa_2 E*), delta = 3 N K/(2 pi a E*)
        self.unit_minor = (3.0 * self.k * self.b_integral / (pi * kappa_2 * modulus)) ** (1.0 / 3.0)
        total = self.b_integral + self.d_integral
        self.unit_approach = 3.0 * total * self.k / (2.0 * pi * self.unit_minor * modulus)
        self.hertz_constant = self.unit_approach**-1.5

    def minor(self, n):
        return self.unit_minor * n ** (1.0 / 3.0)

    def major(self, n):
        return self.minor(n) / self.k

    def approach(self, n):
        return self.unit_approach * n ** (2.0 / 3.0)

    def peak_pressure(self, n):
        return 3.0 * n / (2.0 * pi * self.major(n) * self.minor(n))
