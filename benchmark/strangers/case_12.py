"""Case 12 from its README alone: contacts, ellipses, friction by cells, one root."""
import csv
import sys

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

P, C, NR, N, F, OMEGA, GAMMA = 0.002, 0.020, 9, 28, 35e3, 400 * np.pi / 30, 0.2
E_STAR = 210e9 / (2 * (1 - 0.3**2))
ETA0, ALPHA_P, TAU0, E2 = 0.1665, 30e-9, 12e6, 2 * E_STAR


def gradient(sign, r_t, lead, curvature, x, y):
    """Of z = sign f(r) + theta l/(2 pi), at x, y from the part's own axis."""
    r = np.hypot(x, y)
    phi = np.arcsin(np.sin(np.pi / 4) + (r - r_t) * curvature)
    slope = np.tan(phi) / np.cos(np.arctan(lead / (2 * np.pi * r_t)))
    return sign * slope * np.array([x, y]) / r + lead / (2 * np.pi) * np.array([-y, x]) / r**2


class Touch:
    def __init__(self, screw):
        way = -1.0 if screw else 1.0
        roller = lambda q: gradient(way, 0.005, 0.002, 1 / 0.006, q[0] - C, q[1])
        body = lambda q: gradient(1.0, 0.01494 if screw else 0.025, 0.010, 0.0, *q)
        gap = lambda q: -way * (body(q) - roller(q))
        h = 1e-7
        second = lambda q: np.array([(gap(q + d) - gap(q - d)) / (2 * h) for d in h * np.eye(2)])
        q = np.array([0.01494 if screw else 0.025, 0.0])
        for _ in range(20):
            q = q - np.linalg.solve(second(q), gap(q))
        g, self.at, self.screw = roller(q), q, screw
        self.n = -way * np.array([-g[0], -g[1], 1]) / np.sqrt(1 + g @ g)
        kappa, v = np.linalg.eig(np.linalg.solve(np.eye(2) + np.outer(g, g), second(q) / np.sqrt(1 + g @ g)))
        kappa, v = kappa.real, v.real
        i = kappa.argmin()
        t = np.array([*v[:, i], g @ v[:, i]])
        self.k, self.t1 = np.sort(kappa), t / np.linalg.norm(t)
        self.t2, self.n0 = np.cross(self.n, self.t1), F / NR / N / abs(self.n[2])
        b_of = lambda k: ellipk(1 - k * k) - (ellipk(1 - k * k) - ellipe(1 - k * k)) / (1 - k * k)
        ratio = lambda k: k * k * (ellipk(1 - k * k) - b_of(k)) / b_of(k) - self.k[0] / self.k[1]
        k = brentq(ratio, 1e-3, 1 - 1e-6, xtol=1e-15)
        self.b = (3 * self.n0 * k * b_of(k) / (np.pi * self.k[1] * E_STAR)) ** (1 / 3)
        self.a, self.p0 = self.b / k, 3 * self.n0 / (2 * np.pi * self.b**2 / k)

    def motion(self, eps):
        wb, wr = ((1 - eps) if self.screw else -eps) * OMEGA, -eps * OMEGA / GAMMA
        (x, y), vz = self.at, 0.010 * OMEGA / (2 * np.pi) if self.screw else 0.0
        speed = lambda s: np.array([-(wb + s * wr) * y, wb * x + s * wr * (x - C), vz])
        return speed(-1), speed(1), wb - wr

    def friction(self, eps, law):
        """N, force and moment about z on a roller from one contact, its power, mean coefficient, film."""
        v, u, spin = self.motion(eps)
        cell = (2 * np.arange(21) + 1 - 21) / 21
        s, t = (c.ravel() for c in np.meshgrid(cell, cell))
        inside = s * s + t * t < 1
        s, t = self.a * s[inside], self.b * t[inside]
        p = self.p0 * np.sqrt(1 - (s / self.a) ** 2 - (t / self.b) ** 2)
        v1, v2 = v @ self.t1 - spin * self.n[2] * t, v @ self.t2 + spin * self.n[2] * s
        size, um, rho = np.hypot(v1, v2), np.sqrt(u @ u - (u @ self.n) ** 2), self.k[1]
        big_u = ETA0 * um * rho / E2
        m, l, lam = self.n0 * rho**2 / (E2 * big_u**0.75), ALPHA_P * E2 * big_u**0.25, self.k[0] / self.k[1]
        hc = 1.7 * m ** (-1 / 9) * l**0.75
        kk = 1 + 0.006 * np.log(lam) + 0.63 * lam ** (4 / 7)
        ri = 145 * (1 + 0.796 * lam ** (14 / 15)) ** (-15 / 7) / lam / m**2
        ei = 3.18 * kk ** (-14 / 25) * lam ** (-1 / 15) * m ** (-2 / 15)
        rp = 1.29 * (1 + 0.691 * lam) ** (-2 / 3) * l ** (2 / 3)
        ep = 1.48 * kk ** (-7 / 20) * lam ** (-1 / 24) * m ** (-1 / 12) * l**0.75
        oo, e = 1.80 * lam ** (-5 / 7), 1.5 * (1 + np.exp(-1.2 * ei / ep))
        h = ((ri**1.5 + (ei**-4 + oo**-4) ** (-3 / 8)) ** (2 * e / 3) + (rp**-8 + ep**-8) ** (-e / 8)) ** (1 / e)
        central, film = h * np.sqrt(big_u) / rho, hc * np.sqrt(big_u) / rho
        big = central / np.hypot(0.2e-6, 0.2e-6)
        mu = np.full(len(p), 0.1)
        if law != "coulomb":
            eta = np.exp((np.log(ETA0) + 9.67) * ((1 + p / 0.198e9) ** 0.6 - 1))
            mu = TAU0 / p * np.arcsinh(eta * 2 / TAU0 * size / um * np.sqrt(um * ETA0 * E2 * rho) / (5 * hc))
        if law == "mixed":
            mu = mu + (0.11 - mu) / (1 + big) ** 2
        w = np.divide(mu * p * 4 * self.a * self.b / 21**2, size, where=size > 1e-9, out=0 * p) / self.n0
        pull = (w @ v1) * self.t1 + (w @ v2) * self.t2
        turn = self.n - pull
        n = F / NR / N / abs(turn[2])
        return n, -n * turn, n * (w @ (s * v2 - t * v1)) * self.n[2], n * (w @ size**2), mu.mean(), film, central, big


points = [Touch(True), Touch(False)]
v0, v1 = points[0].motion(0)[0], points[0].motion(1)[0]
ideal = -(v0 @ (v1 - v0)) / ((v1 - v0) @ (v1 - v0))
out = csv.writer(sys.stdout)
out.writerow(("case", "quantity", "value"))
for law in ("coulomb", "film", "mixed"):

    def moment(eps):
        total = 0.0
        for p in points:
            _, f, c, *_ = p.friction(eps, law)
            total += (p.at[0] - C) * f[1] - p.at[1] * f[0] + c - C * GAMMA / (1 - GAMMA) * f[1]
        return total

    eps = brentq(moment, 0.9 * ideal, 1.001 * ideal, xtol=1e-15)
    screw, nut = (p.friction(eps, law) for p in points)
    x, y = points[0].at
    torque = NR * N * (x * screw[1][1] - y * screw[1][0] + screw[2])
    rows = [("slip_ratio", eps), ("ideal_slip_ratio", ideal), ("power_loss_W", NR * N * (screw[3] + nut[3])),
            ("power_loss_screw_contacts_W", NR * N * screw[3]), ("torque_on_screw_Nm", torque),
            ("efficiency", F * 0.010 / (2 * np.pi) / torque)]
    for body, r in (("screw", screw), ("nut", nut)):
        rows += [(f"dynamic_normal_load_{body}_N", r[0]), (f"mean_friction_{body}", r[4])]
        rows += [(f"film_{body}_nm", 1e9 * r[5])] if law != "coulomb" else []
        rows += [(f"central_film_{body}_nm", 1e9 * r[6]), (f"film_ratio_{body}", r[7])] if law == "mixed" else []
    out.writerows(("12", f"{law}.{name}", value) for name, value in rows)
