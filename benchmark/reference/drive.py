"""A screw with play between motor and load: case 19, from its README alone.

Pieces between events, each by the pair of order 8 of Dormand and Prince (scipy); events by its root finder.
"""
from dataclasses import dataclass
from math import cos, pi, radians, sqrt

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

X, V, DELTA, OMEGA, THETA, OMEGA_M = range(6)
LOAD, SCREW, MOTOR = range(3)
SPEED = (V, OMEGA, OMEGA_M)
#: Integrals over time, computed together with the states.
SUMS = ("motor", "load", "screw_friction", "motor_friction", "load_friction", "coupling", "contact", "torque_squared")


def flank_constant(rollers, threads, constants, angle):
    """C of F = C w^1.5 of threads that share a load evenly."""
    c = cos(radians(angle))
    return rollers * threads * c * (c / sum(k ** (-2 / 3) for k in constants)) ** 1.5


@dataclass
class Drive:
    lead: float
    constant: float  # C [N/m^1.5]
    play: float  # a: half of the play [m]
    mass: float
    screw_inertia: float
    motor_inertia: float
    stiffness: float
    damping: float
    beta: float
    friction: tuple  # of load [N], screw, motor [N m]
    torque: tuple  # (time, value), ..
    force: float
    samples: tuple  # times, the last one the end

    def __post_init__(self):
        self.r = self.lead / (2 * pi)
        self.now, self.flank, self.lifted, self.place = 0.0, 1, False, [0, 0, 0]

    def forces(self, y):
        """S, F before and after the bound, T_c."""
        w = self.flank * y[DELTA] - self.play if self.flank else 0.0
        w = max(w, 0.0)
        rate = self.r * y[OMEGA] - y[V]
        s = self.constant * w**1.5
        pressed = s + self.beta * 1.5 * self.constant * sqrt(w) * self.flank * rate
        f = 0.0 if self.lifted else pressed
        twist = self.stiffness * y[THETA] + self.damping * (y[OMEGA_M] - y[OMEGA])
        return self.flank * s, pressed, self.flank * f, twist

    def others(self, y):
        """D: all forces on load, screw and motor but their friction."""
        _, _, f, twist = self.forces(y)
        return f - self.force, twist - self.r * f, self.now - twist

    def rates(self, _, y):
        s, _, f, twist = self.forces(y)
        inertia = (self.mass, self.screw_inertia, self.motor_inertia)
        slide = [p * b for p, b in zip(self.place, self.friction)]
        a = [(d - b) / m if p else 0.0 for d, b, m, p in zip(self.others(y), slide, inertia, self.place)]
        v, omega, omega_m = y[V], y[OMEGA], y[OMEGA_M]
        rate = self.r * omega - v
        return [v, a[LOAD], rate, a[SCREW], omega_m - omega, a[MOTOR],
                self.now * omega_m, -self.force * v, slide[SCREW] * omega, slide[MOTOR] * omega_m, slide[LOAD] * v,
                self.damping * (omega_m - omega) ** 2, (f - s) * rate, self.now**2]

    def settle(self, y, which, starts=False):
        """Places that have come to rest stay or go on; those that friction no longer holds start."""
        for i in which:
            y[SPEED[i]] = 0.0
        for i, d in enumerate(self.others(y)):
            if i in which:
                rested = starts or self.place[i] != 0
                self.place[i] = 0 if rested and abs(d) <= self.friction[i] else int(np.sign(d))

    def events(self):
        """(function, direction, what it is)."""
        found = []
        if self.flank == 0:
            found += [(lambda t, y: y[DELTA] - self.play, 1, ("closes", 1)),
                      (lambda t, y: y[DELTA] + self.play, -1, ("closes", -1))]
        else:
            found.append((lambda t, y: self.flank * y[DELTA] - self.play, -1, ("opens", 0)))
            found.append((lambda t, y: self.forces(y)[1], 1 if self.lifted else -1, ("lifts", 0)))
        for i in range(3):
            if self.place[i]:
                found.append((lambda t, y, i=i: self.place[i] * y[SPEED[i]], -1, ("place", i)))
            else:
                found.append((lambda t, y, i=i: abs(self.others(y)[i]) - self.friction[i], 1, ("place", i)))
        return found

    def run(self, tolerance=1e-12):
        y = np.zeros(6 + len(SUMS))
        y[DELTA] = self.play + (self.force / self.constant) ** (2 / 3)
        y[THETA] = self.r * self.force / self.stiffness
        scale = np.array([1e-6, 1e-3, 1e-9, 1e-1, 1e-5, 1e-1] + [1e-3] * len(SUMS))
        self.now = self.torque[0][1]
        self.settle(y, range(3), starts=True)
        self.stored_start = self.stored(y)
        t, self.impacts, self.pieces, self.sampled = 0.0, [], [], []
        self.peak, self.lag = {1: (0.0, 0.0), -1: (0.0, 0.0)}, [-np.inf, -np.inf]
        ends = [at for at, _ in self.torque[1:]] + list(self.samples)
        while t < self.samples[-1]:
            end = min(e for e in ends if e > t)
            events = self.events()
            functions = []
            for function, direction, _ in events:
                def event(t, y, function=function):
                    return function(t, y)
                event.terminal, event.direction = True, direction
                functions.append(event)
            piece = solve_ivp(self.rates, (t, end), y, method="DOP853", rtol=tolerance, atol=tolerance * scale,
                              max_step=1e-4, events=functions, dense_output=True)
            assert piece.success, piece.message
            self.note(piece)
            t, y = piece.t[-1], piece.y[:, -1].copy()
            fired = [what for (_, _, what), times in zip(events, piece.t_events) if len(times)]
            self.now = next(value for at, value in reversed(self.torque) if at <= t)
            for what, value in fired:
                if what == "closes":
                    self.flank, self.lifted = value, False
                    self.impacts.append([t, value, abs(self.r * y[OMEGA] - y[V]), 0.0])
                elif what == "opens":
                    self.flank, self.lifted = 0, False
                elif what == "lifts":
                    self.lifted = not self.lifted
            self.settle(y, {value for what, value in fired if what == "place"})
            if t in self.samples:
                self.sampled.append(y.copy())
        self.end = y
        return self

    def note(self, piece):
        """Extremes of the piece, on its dense output: the modes are still its own."""
        steps = np.diff(piece.t)
        times = np.unique(np.concatenate([piece.t[:-1] + q * steps for q in (0, 0.25, 0.5, 0.75)] + [piece.t[-1:]]))
        self.pieces.append((times, np.array([self.forces(y)[2] for y in piece.sol(times).T])))

        def largest(value):
            values = [value(piece.sol(t)) for t in times]
            k = int(np.argmax(values))
            a, b = times[max(k - 1, 0)], times[min(k + 1, len(times) - 1)]
            if not b > a:
                return times[k], values[k]
            best = minimize_scalar(lambda t: -value(piece.sol(t)), bounds=(a, b), method="bounded",
                                   options={"xatol": 1e-12})
            return (best.x, -best.fun) if -best.fun > values[k] else (times[k], values[k])

        for sense in (1, -1):
            found = largest(lambda y: sense * self.forces(y)[2])
            if found[1] > self.peak[sense][1]:
                self.peak[sense] = found
            self.lag[(1 - sense) // 2] = max(self.lag[(1 - sense) // 2],
                                             largest(lambda y: sense * (y[DELTA] + self.r * y[THETA]))[1])
        if self.impacts:
            self.impacts[-1][3] = max(self.impacts[-1][3], largest(lambda y: self.impacts[-1][1] * self.forces(y)[2])[1])

    def stored(self, y):
        w = max(abs(y[DELTA]) - self.play, 0.0)
        kinetic = self.mass * y[V] ** 2 + self.screw_inertia * y[OMEGA] ** 2 + self.motor_inertia * y[OMEGA_M] ** 2
        return 0.5 * (kinetic + self.stiffness * y[THETA] ** 2) + 0.4 * self.constant * w**2.5
