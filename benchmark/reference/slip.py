"""Stationary slip of a standard planetary roller screw, its friction and lost power (Sandu 2018). SI units.

z along the axis, x from it to the roller's axis, in the frame of the carrier. The screw turns with omega against the
nut, > 0 anticlockwise about z. The nut is pulled towards +z by the screw (faces I1J2). Friction acts on the roller
along v = v_body - v_roller.
"""
from dataclasses import dataclass, field
from math import exp, log, pi, sqrt

import numpy as np
from hertz import Contact


@dataclass
class Oil:
    viscosity: float
    pressure_viscosity: float
    eyring_stress: float


@dataclass
class Law:
    """coulomb: `coefficient` alone; jacod: `oil`; mixed: both, with `roughness`, the composite Rq."""
    coefficient: float = None
    oil: Oil = None
    roughness: float = None
    exponent: float = 2.0


def sandu_film(oil, n_0, speed, kappa, e_prime):
    """H_c, the film over sqrt(U)/rho, (2.37) to (2.39)."""
    rho = kappa[1]
    u = oil.viscosity * speed * rho / e_prime
    m, l = n_0 * rho**2 / (e_prime * u**0.75), oil.pressure_viscosity * e_prime * u**0.25
    return 1.7 * m ** (-1 / 9) * l**0.75, u


def central_film(oil, n_0, speed, kappa, e_prime):
    """Nijenbanning, Venner and Moes 1994 [m]."""
    rho, lam = kappa[1], kappa[0] / kappa[1]
    u = oil.viscosity * speed * rho / e_prime
    m, l = n_0 * rho**2 / (e_prime * u**0.75), oil.pressure_viscosity * e_prime * u**0.25
    k = 1.0 + 0.006 * log(lam) + 0.63 * lam ** (4 / 7)
    h_ri = 145.0 * (1.0 + 0.796 * lam ** (14 / 15)) ** (-15 / 7) / lam / m**2
    h_ei = 3.18 * k ** (-14 / 25) * lam ** (-1 / 15) * m ** (-2 / 15)
    h_rp = 1.29 * (1.0 + 0.691 * lam) ** (-2 / 3) * l ** (2 / 3)
    h_ep = 1.48 * k ** (-7 / 20) * lam ** (-1 / 24) * m ** (-1 / 12) * l**0.75
    h_00 = 1.80 * lam ** (-5 / 7)
    s = 1.5 * (1.0 + exp(-1.2 * h_ei / h_ep))
    h = ((h_ri**1.5 + (h_ei**-4 + h_00**-4) ** (-3 / 8)) ** (2 * s / 3)
         + (h_rp**-8 + h_ep**-8) ** (-s / 8)) ** (1 / s)
    return h * sqrt(u) / rho


class Grid:
    """Centres of n x n cells of the rectangle around the ellipse, those inside; in units of the semi-axes."""

    def __init__(self, n=21):
        c = (2.0 * np.arange(n) + 1.0 - n) / n
        t_1, t_2 = (a.ravel() for a in np.meshgrid(c, c, indexing="ij"))
        inside = t_1**2 + t_2**2 < 1.0
        self.t_1, self.t_2 = t_1[inside], t_2[inside]
        self.dome = np.sqrt(1.0 - self.t_1**2 - self.t_2**2)
        self.cell = 6.0 / (pi * n * n)  # load of a cell over normal load and dome


@dataclass
class Slip:
    """`loads`: axial force of each thread of one roller at screw and nut; or with `normal` their normal forces."""
    points: tuple            # TouchPoint of screw and nut
    centre_distance: float
    lead: float
    gear_ratio: float        # Gamma = lead of the roller over that of the screw
    rollers: int
    speed: float             # omega, rad/s
    force: float             # of the mechanism, > 0
    law: Law
    modulus: float           # E* of a pair of bodies
    loads: tuple = None
    normal: tuple = None
    grid: Grid = field(default_factory=Grid)

    def __post_init__(self):
        self.hertz = [Contact(*p.kappa, self.modulus) for p in self.points]

    def motion(self, ratio, i):
        """Sliding and rolling velocities at the point, spin about z: body against roller."""
        p, w = self.points[i], self.speed
        roller = -ratio / self.gear_ratio * w
        body = (1.0 - ratio) * w if i == 0 else -ratio * w
        along = self.lead / (2.0 * pi) * w if i == 0 else 0.0  # the carrier goes with the nut
        a, b = p.x, p.x - self.centre_distance
        slide = np.array([-(body - roller) * p.y, body * a - roller * b, along])
        roll = np.array([-(body + roller) * p.y, body * a + roller * b, along])
        return slide, roll, body - roller

    def ideal(self):
        """The ratio at which the screw's contact slides least."""
        v_0, v_1 = self.motion(0.0, 0)[0], self.motion(1.0, 0)[0]
        rate = v_1 - v_0
        return -(v_0 @ rate) / (rate @ rate)

    def patch(self, i, n_0, ratio):
        """Friction of one contact over its normal force: traction, moment about n, power, mean coefficient, film."""
        p, h, g, law = self.points[i], self.hertz[i], self.grid, self.law
        slide, roll, spin = self.motion(ratio, i)
        spin *= p.normal[2]
        u_n = roll @ p.normal
        entrain = sqrt(max(roll @ roll - u_n**2, 0.0))
        if slide @ slide < 1e-24 * (roll @ roll):
            slide = 0.0 * slide
        a, b, p_0 = h.major(n_0), h.minor(n_0), h.peak_pressure(n_0)
        v_1 = slide @ p.major_axis - spin * b * g.t_2
        v_2 = slide @ p.minor_axis + spin * a * g.t_1
        v = np.hypot(v_1, v_2)
        film = central = ratio_film = None
        if law.oil is None:
            mu = np.full(len(v), law.coefficient)
        else:
            e_prime = 2.0 * self.modulus
            h_c, u = sandu_film(law.oil, n_0, entrain, p.kappa, e_prime)
            film, central = h_c * sqrt(u) / p.kappa[1], central_film(law.oil, n_0, entrain, p.kappa, e_prime)
            pressure = p_0 * g.dome
            eta = np.exp((log(law.oil.viscosity) + 9.67) * ((1.0 + pressure / 0.198e9) ** 0.6 - 1.0))
            s_d = 2.0 / law.oil.eyring_stress * v / entrain * sqrt(entrain * law.oil.viscosity * e_prime * p.kappa[1])
            mu = law.oil.eyring_stress / pressure * np.arcsinh(eta * s_d / (5.0 * h_c))
            if law.coefficient is not None:
                ratio_film = central / law.roughness
                share = (1.0 + ratio_film) ** -law.exponent
                mu = mu + (law.coefficient - mu) * share
        # The centre of a contact without slip has rounding for a direction.
        moving = v > 1e-12 * max(v.max(), 1e-300)
        w = np.where(moving, g.cell * g.dome * mu / np.where(moving, v, 1.0), 0.0)
        return {"traction": (w @ v_1) * p.major_axis + (w @ v_2) * p.minor_axis,
                "spin": w @ (a * g.t_1 * v_2 - b * g.t_2 * v_1), "power": w @ v**2, "mean": mu.mean(),
                "film": film, "central": central, "film_ratio": ratio_film, "pressure": p_0}

    def interface(self, i, ratio):
        """Force and spin moment of all threads on one roller; power; normal forces and friction of each."""
        p = self.points[i]
        force, spin, power, normals, patches = np.zeros(3), 0.0, 0.0, [], []
        given = self.normal[i] if self.normal else self.loads[i]
        known = {}
        for load in given:
            if load == 0.0:
                normals.append(0.0)
                patches.append(None)
                continue
            if load not in known:
                known[load] = self.patch(i, load if self.normal else load / abs(p.normal[2]), ratio)
            at = known[load]
            m = p.normal - at["traction"]
            n = load if self.normal else load / (m[2] * np.sign(p.normal[2]))
            if n < 0.0:
                raise ArithmeticError("friction pushes a contact open")
            force -= n * m
            spin += n * at["spin"] * p.normal[2]
            power += n * at["power"]
            normals.append(n)
            patches.append(at)
        return force, spin, power, normals, patches

    def balance(self, ratio):
        c, gear = self.centre_distance, self.centre_distance * self.gear_ratio / (1.0 - self.gear_ratio)
        forces = [self.interface(i, ratio) for i in (0, 1)]
        moment = sum((p.x - c) * f[0][1] - p.y * f[0][0] + f[1] for p, f in zip(self.points, forces))
        return moment - gear * (forces[0][0][1] + forces[1][0][1]), forces

    def solve(self, ratio=None):
        """Slip ratio by bisection and secants, then all that follows. With `ratio` that one is taken."""
        if ratio is None:
            ideal = self.ideal()
            low, high = 0.5 * ideal, ideal * (1.0 + 1e-6)
            f_low, f_high = self.balance(low)[0], self.balance(high)[0]
            if f_low * f_high > 0.0:
                high, low = ideal * 1.02, 1e-9
                f_low, f_high = self.balance(low)[0], self.balance(high)[0]
            for i in range(300):
                middle = 0.5 * (low + high) if i % 3 == 2 else high - f_high * (high - low) / (f_high - f_low)
                if not low < middle < high:
                    middle = 0.5 * (low + high)
                f = self.balance(middle)[0]
                if f * f_low > 0.0:
                    low, f_low = middle, f
                else:
                    high, f_high = middle, f
                if high - low < 1e-16 or f == 0.0:
                    break
            ratio = middle
        moment, forces = self.balance(ratio)
        about = [p.x * f[0][1] - p.y * f[0][0] + f[1] for p, f in zip(self.points, forces)]
        torque = self.rollers * about[0]
        shaft, load = torque * self.speed, -self.force * self.lead / (2.0 * pi) * self.speed
        power = [self.rollers * f[2] for f in forces]
        efficiency = None
        if load < 0.0 < shaft:
            efficiency = -load / shaft
        elif shaft < 0.0 < load:
            efficiency = -shaft / load
        return {"ratio": ratio, "ideal": self.ideal(), "torque": torque, "shaft": shaft, "load": load,
                "power": power, "efficiency": efficiency, "normal": [f[3] for f in forces],
                "patch": [f[4] for f in forces]}
