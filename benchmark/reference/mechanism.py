"""All rollers on a screw and a nut that bend in space. SI units.

x along the axis, y and z across it, right-handed. Roller j stands at phi_j = 2 pi j/N from y towards z, with
e_j = (cos phi_j, sin phi_j). Slopes y' and z' belong to the moments M_z and -M_y.
"""
from dataclasses import dataclass, field
from math import ceil, cos, pi, sin

import numpy as np
from frame import Frame
from sector import ring_area


def inertia(outer, inner):
    return pi / 64.0 * (outer**4 - inner**4)


@dataclass
class Mechanism:
    force: float
    sense: int
    position: float
    rollers: int
    threads: int
    pitch: float
    screw_diameter: float
    roller_diameter: float
    nut_diameter: float
    centre_distance: float
    bore: float
    free_length: float
    end_length: float
    end_diameter: float
    nut_length: float
    nut_outer: float
    thrust: float
    youngs_modulus: float
    constant: tuple
    angle: tuple
    side_force: tuple = (0.0, 0.0)       # at the loaded section of the screw
    moment: tuple = (0.0, 0.0)           # M_y, M_z there
    tilt: tuple = (0.0, 0.0)             # of the nut's seat about y and z
    clamped: bool = False                # the screw's loaded section: no motion across, no tilt
    missing: tuple = ()                  # rollers, from 0
    diameters: tuple = None              # deviations of the rollers' diameters
    turn: float = 0.0                    # of the carrier
    eccentric: tuple = ((0.0, 0.0), (0.0, 0.0))  # threads of screw and nut off their axes: amount, azimuth in space
    density: float = 0.0                 # for modes; then bodies are cut into pieces of a roller's diameter at most
    load_mass: float = 0.0               # at the loaded section of the screw
    result: dict = field(default_factory=dict)

    def solve(self):
        f, s, n, p, e = Frame(), self.sense, self.threads, self.pitch, self.youngs_modulus
        x = [self.position + i * p for i in range(n)]

        def piece(a, b, planes, outer, inner, length):
            area, second = ring_area(outer, inner), inertia(outer, inner)
            f.bar(a[0], b[0], e * area, length)
            f.bar_mass(a[0], b[0], self.density * area * length)
            for y, slope in planes:
                f.beam((a[y], a[slope]), (b[y], b[slope]), e * second, length)
                f.beam_mass((a[y], a[slope]), (b[y], b[slope]), self.density * area * length,
                            self.density * second * length, length)

        def spatial(stations, outer, inner):
            cut = [stations[0]]
            for a, b in zip(stations, stations[1:]):
                pieces = ceil((b - a) / self.roller_diameter - 1e-9) if self.density else 1
                cut += [a + (b - a) * i / pieces for i in range(1, pieces)] + [b]
            nodes = [f.freedoms(5) for _ in cut]  # u, y, z, y', z'
            for a, b, length in zip(nodes, nodes[1:], np.diff(cut)):
                piece(a, b, ((1, 3), (2, 4)), outer, inner, length)
            axial.extend(node[0] for node in nodes)
            return [nodes[cut.index(at)] for at in stations]

        axial = f.axial = []  # all displacements along x

        screw = spatial([self.position - self.free_length, *x], self.screw_diameter, self.bore)
        loaded, screw = screw[0], screw[1:]
        assert self.thrust < x[0]
        behind = [self.nut_length] if self.density else []
        nut = spatial([self.thrust, *x, *behind], self.nut_outer, self.nut_diameter)
        seat, nut = nut[0], nut[1:]
        for freedom, at in zip(seat, (0.0, 0.0, 0.0, self.tilt[1], -self.tilt[0])):
            f.hold(freedom, at)
        if self.clamped:
            for freedom in loaded[1:]:
                f.hold(freedom)
        f.load(loaded[0], s * self.force)
        if self.load_mass:
            for freedom in loaded[:3]:
                f.mass((freedom,), [[self.load_mass]])
        for freedom, load in zip(loaded[1:], (*self.side_force, self.moment[1], -self.moment[0])):
            f.load(freedom, load)

        r = 0.5 * self.roller_diameter
        arm = (self.centre_distance - r, self.centre_distance + r)
        present = [j for j in range(self.rollers) if j not in self.missing]
        larger = {j: 0.5 * (self.diameters[j] if self.diameters else 0.0) for j in present}
        azimuth = [2 * pi * j / self.rollers + self.turn for j in range(self.rollers)]
        outwards = [{j: amount * cos(azimuth[j] - at) for j in present} for amount, at in self.eccentric]
        gap = [[-sin(self.angle[0]) * (larger[j] + outwards[0][j]) for j in present],
               [-sin(self.angle[1]) * (larger[j] - outwards[1][j]) for j in present]]
        least = [min(g) for g in gap]
        (c_k, s_k), (c_g, s_g) = ((cos(a), sin(a)) for a in self.angle)
        at = [x[0] - p / 2 - self.end_length, x[0] - p / 2, *x, x[-1] + p / 2, x[-1] + p / 2 + self.end_length]
        for q, j in enumerate(present):
            e_y, e_z = cos(azimuth[j]), sin(azimuth[j])
            roller = [f.freedoms(3) for _ in at]
            axial.extend(node[0] for node in roller)
            for i in range(len(at) - 1):
                d = self.end_diameter if i in (0, len(at) - 2) else self.roller_diameter
                piece(roller[i], roller[i + 1], ((1, 2),), d, 0.0, at[i + 1] - at[i])
            for i in (0, 1, len(at) - 2, len(at) - 1):
                f.hold(roller[i][1])
            for k in range(n):
                u, v, theta = roller[2 + k]
                b = screw[k]
                f.contact({b[0]: s * c_k, b[3]: -s * c_k * arm[0] * e_y, b[4]: -s * c_k * arm[0] * e_z,
                           u: -s * c_k, theta: -s * c_k * r, b[1]: s_k * e_y, b[2]: s_k * e_z, v: -s_k},
                          self.constant[0], gap[0][q] - least[0])
            for k in range(n):
                u, v, theta = roller[2 + k]
                b = nut[k]
                f.contact({u: s * c_g, theta: -s * c_g * r, b[0]: -s * c_g, b[3]: s * c_g * arm[1] * e_y,
                           b[4]: s * c_g * arm[1] * e_z, v: s_g, b[1]: -s_g * e_y, b[2]: -s_g * e_z},
                          self.constant[1], gap[1][q] - least[1])
        u, normal = f.solve(self.force / (len(present) * n * cos(self.angle[0])))
        both = np.zeros((2, self.rollers, n))
        for q, j in enumerate(present):
            both[0, j] = normal[2 * n * q : 2 * n * q + n]
            both[1, j] = normal[2 * n * q + n : 2 * n * (q + 1)]
        common = least[0] / cos(self.angle[0]) + least[1] / cos(self.angle[1])
        self.result = {"normal": both, "displacement": s * u[loaded[0]], "travel": u[loaded[0]] + s * common, "lateral": (u[loaded[1]], u[loaded[2]]),
                       "rotation": (-u[loaded[4]], u[loaded[3]])}
        self.frame = f
        return self.result
