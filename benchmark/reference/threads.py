"""Where the threads of screw, roller and nut touch, and how they curve there. SI units.

z along the axis of screw and nut, x from there to the roller's axis. A flank is z = +-f(r) + theta l/(2 pi);
two flanks touch where their axial clearance C(x, y) has a minimum, and the relative curvatures there follow
from its Hessian: the second form is C''/sqrt(1 + |grad z|^2), the first form 1 + grad z grad z'.
"""
from math import atan, cos, pi, sin, sqrt

import numpy as np


class Flank:
    """Profile f(r) of one thread. `convex`: radius of the profile [m], None for a straight one. The arc lies in the
    plane normal to the helix; half a pitch thick at the pitch radius."""

    def __init__(self, radius, lead, starts, flank_angle, convex=None):
        self.radius, self.lead, self.pitch = radius, lead, abs(lead) / starts
        self.alpha, self.curvature = flank_angle, 0.0 if convex is None else 1.0 / convex
        self.cos_beta = cos(atan(lead / (2.0 * pi * radius)))

    def profile(self, r):
        """f, f', f'' at r."""
        sin_phi = sin(self.alpha) + (r - self.radius) * self.curvature
        cos_phi = sqrt(1.0 - sin_phi**2)
        slope = (sin(self.alpha) + sin_phi) / (cos(self.alpha) + cos_phi)  # mean over the arc
        return (self.pitch / 4.0 + (r - self.radius) * slope / self.cos_beta,
                sin_phi / cos_phi / self.cos_beta,
                self.curvature / (cos_phi**3 * self.cos_beta))

    def face(self, sign, x, y):
        """z, gradient and Hessian of z = sign f(r) + theta l/(2 pi) at x, y from the thread's own axis."""
        r = sqrt(x * x + y * y)
        f, f1, f2 = self.profile(r)
        e = np.array([x, y]) / r
        t = np.array([-y, x]) / r
        lead = self.lead / (2.0 * pi)
        radial, around = np.outer(e, e), np.outer(t, t)
        gradient = sign * f1 * e + lead / r * t
        hessian = sign * (f2 * radial + f1 / r * around) - lead / r**2 * (np.outer(e, t) + np.outer(t, e))
        return sign * f + lead * np.arctan2(y, x), gradient, hessian


class TouchPoint:
    """The contact of a roller with screw or nut, faces I1J2: the screw pulls the nut towards +z."""

    def __init__(self, body, roller, centre_distance, at_screw):
        self.at_screw = at_screw
        # Screw: its lower face on the roller's upper one. Nut: the roller's lower face on the nut's upper one, which
        # is the lower face of the air in the nut.
        p = np.array([body.radius if at_screw else centre_distance + roller.radius, 0.0])
        for _ in range(60):
            _, g_b, h_b = body.face(1.0, *p)
            _, g_r, h_r = roller.face(-1.0 if at_screw else 1.0, p[0] - centre_distance, p[1])
            gradient, hessian = (g_b - g_r, h_b - h_r) if at_screw else (g_r - g_b, h_r - h_b)
            step = np.linalg.solve(hessian, gradient)
            p = p - step
            if np.abs(step).max() < 1e-17:
                break
        self.x, self.y = p
        self.radius_on_body = float(np.hypot(*p))
        self.radius_on_roller = float(np.hypot(p[0] - centre_distance, p[1]))
        w = sqrt(1.0 + g_r @ g_r)
        out = 1.0 if at_screw else -1.0  # Out of the roller: up at the screw, down at the nut.
        self.normal = out * np.array([-g_r[0], -g_r[1], 1.0]) / w
        self.normal_angle = float(np.arccos(abs(self.normal[2])))
        first = np.eye(2) + np.outer(g_r, g_r)
        root = np.linalg.inv(np.linalg.cholesky(first))
        kappa, vectors = np.linalg.eigh(root @ (hessian / w) @ root.T)
        self.kappa = (float(kappa[0]), float(kappa[1]))
        plane = root.T @ vectors[:, 0]
        self.major_axis = np.array([plane[0], plane[1], g_r @ plane])
        self.minor_axis = np.cross(self.normal, self.major_axis)


def axial_play(screw, roller, nut, centre_distance):
    """Clearance of both faces of each interface, from the clearance at the touching point [m]."""
    plays = []
    for body, at_screw in ((screw, True), (nut, False)):
        point = TouchPoint(body, roller, centre_distance, at_screw)
        x, y = point.x, point.y
        z_b = body.face(1.0, x, y)[0]
        sign = -1.0 if at_screw else 1.0
        f = roller.profile(point.radius_on_roller)[0]
        lead = roller.lead / (2.0 * pi)
        around = np.arctan2(-y, centre_distance - x) if at_screw else np.arctan2(y, x - centre_distance)
        z_r = sign * f + lead * around  # at the screw counted from the side that faces it
        half = z_b - z_r - roller.pitch / 2.0 if at_screw else z_r - z_b
        plays.append(2.0 * half)
    return tuple(plays)
