"""One roller with its share of screw and nut (Abevi et al. 2015): bars, a beam, Hertz contacts. SI units.

x along the axis from the loaded end of the screw, y outwards; s = -1 tension, +1 compression.
"""
from dataclasses import dataclass, field
from math import cos, pi, sin

import numpy as np
from frame import Frame


def ring_area(outer, inner):
    return pi / 4.0 * (outer**2 - inner**2)


@dataclass
class Sector:
    force: float                     # of the whole mechanism, > 0
    sense: int                       # -1 tension, +1 compression
    position: float                  # of the first contact from the nut's end
    rollers: int
    threads: int
    pitch: float
    screw_diameter: float
    roller_diameter: float
    nut_diameter: float
    bore: float
    free_length: float
    end_length: float
    end_diameter: float
    nut_length: float
    nut_outer: float
    thrust: float                    # section of the nut that is held
    flanges: tuple = ()              # (from, to, outer diameter)
    youngs_modulus: float = 210e9
    constant: tuple = (0.0, 0.0)     # k_0 of screw and nut, N/m^1.5
    angle: tuple = (0.0, 0.0)        # psi of screw and nut, rad
    apart: bool = False              # half a pitch between a tooth's two contacts
    rigid_bending: bool = False
    gaps: tuple = None               # of screw and nut, one for each thread
    push: tuple = None               # friction over the normal force on the roller (along x, y), of screw and nut
    result: dict = field(default_factory=dict)

    def solve(self):
        f, s, n, p = Frame(), self.sense, self.threads, self.pitch
        e, share = self.youngs_modulus, 1.0 / self.rollers
        x = [self.position + i * p for i in range(n)]
        screw = [f.freedoms(1)[0] for _ in range(n + 1)]  # loaded section, contacts
        area = ring_area(self.screw_diameter, self.bore) * share
        for i in range(n):
            length = self.free_length if i == 0 else p
            if length > 0.0:
                f.bar(screw[i], screw[i + 1], e * area, length)
            else:
                f.hold(screw[i], terms=[(screw[i + 1], 1.0)])

        stations = sorted({0.0, self.nut_length, self.thrust, *x, *(v for g in self.flanges for v in g[:2])})
        stations = [v for i, v in enumerate(stations) if i == 0 or v - stations[i - 1] > 1e-9 * self.nut_length]
        place = lambda v: int(np.argmin([abs(v - w) for w in stations]))
        nut = [f.freedoms(1)[0] for _ in stations]
        for i in range(len(stations) - 1):
            middle = 0.5 * (stations[i] + stations[i + 1])
            outer = next((g[2] for g in self.flanges if g[0] < middle < g[1]), self.nut_outer)
            f.bar(nut[i], nut[i + 1], e * ring_area(outer, self.nut_diameter) * share, stations[i + 1] - stations[i])
        f.hold(nut[place(self.thrust)])

        def section(diameter):
            return e * ring_area(diameter, 0.0), e * pi / 64.0 * diameter**4

        ends, thread = section(self.end_diameter), section(self.roller_diameter)
        half = p / 4.0 if self.apart else 0.0
        at = [x[0] - p / 2.0 - self.end_length, x[0] - p / 2.0]
        for v in x:
            at += [v - half, v + half] if self.apart else [v]
        at += [x[-1] + p / 2.0, x[-1] + p / 2.0 + self.end_length]
        roller = [f.freedoms(3) for _ in at]
        for i in range(len(at) - 1):
            stiff = ends if i in (0, len(at) - 2) else thread
            f.bar(roller[i][0], roller[i + 1][0], stiff[0], at[i + 1] - at[i])
            f.beam(roller[i][1:], roller[i + 1][1:], stiff[1], at[i + 1] - at[i])
        guided = (0, 1, len(at) - 2, len(at) - 1)
        for i, node in enumerate(roller):
            if self.rigid_bending or i in guided:
                f.hold(node[1])
            if self.rigid_bending:
                f.hold(node[2])

        r = 0.5 * self.roller_diameter
        (c_k, s_k), (c_g, s_g) = ((cos(a), sin(a)) for a in self.angle)
        for interface in (0, 1):
            for i in range(n):
                later = (interface == 0) == (s < 0)  # of a tooth's two flanks
                u, v, theta = roller[2 + (2 * i + later if self.apart else i)]
                if interface == 0:
                    along, across, c, sn = {screw[i + 1]: 1.0, u: -1.0, theta: -r}, {v: -1.0}, c_k, s_k
                else:
                    along, across, c, sn = {u: 1.0, theta: -r, nut[place(x[i])]: -1.0}, {v: 1.0}, c_g, s_g
                w = {key: s * c * a for key, a in along.items()} | {key: sn * a for key, a in across.items()}
                push = None
                if self.push is not None:  # friction is a pair of forces along the same displacements
                    t_x, t_y = self.push[interface][i]
                    sign = 1.0 if interface == 0 else -1.0
                    push = dict(w)
                    for key, a in along.items():
                        push[key] = push.get(key, 0.0) + sign * t_x * a
                    for key, a in across.items():
                        push[key] = push.get(key, 0.0) + sign * t_y * a
                gap = 0.0 if self.gaps is None else self.gaps[interface][i]
                f.contact(w, self.constant[interface], gap, push)
        f.load(screw[0], s * self.force * share)
        u, normal = f.solve(self.force * share / n / cos(self.angle[0]))
        self.result = {"normal": (normal[:n], normal[n:]), "displacement": s * u[screw[0]],
                       "stiffness": self.force / (s * u[screw[0]])}
        return self.result


def axial_percent(normal, angle, force, rollers):
    return 100.0 * np.asarray(normal) * cos(angle) / (force / rollers)


def gaps(sense, angle, along, across):
    """Gaps of screw and nut: `along` = a of screw, roller, nut (moved along x), `across` = rho (pitch radius)."""
    c, s = [cos(a) for a in angle], [sin(a) for a in angle]
    screw = -sense * c[0] * (along[0] - along[1]) - s[0] * (across[0] + across[1])
    nut = -sense * c[1] * (along[1] - along[2]) - s[1] * (across[1] - across[2])
    return screw - screw.min(), nut - nut.min()
