"""Bars, beams and contacts that only push, with few unknowns: dense matrices, Newton's method. SI units.

Energy 1/2 u'Ku + sum (2/5) k <w - g>^2.5 - f'u with w = B u. Forces are summed in long doubles, since stiff short
beams multiply small differences of displacements.
"""
import numpy as np

WIDE = np.longdouble


class Frame:
    def __init__(self):
        self.count, self.stiff, self.rows, self.held = 0, [], [], {}
        self.loads = {}
        self.masses = []

    def freedoms(self, n):
        first = self.count
        self.count += n
        return tuple(range(first, first + n))

    def element(self, freedoms, matrix):
        self.stiff.append((list(freedoms), np.asarray(matrix, dtype=WIDE)))

    def bar(self, a, b, rigidity, length):
        self.element((a, b), rigidity / length * np.array([[1.0, -1.0], [-1.0, 1.0]]))

    def beam(self, a, b, bending, length):
        """Euler and Bernoulli; a, b = (deflection, slope) at both ends."""
        l = length
        self.element((*a, *b), bending / l**3 * np.array([
            [12.0, 6.0 * l, -12.0, 6.0 * l], [6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l],
            [-12.0, -6.0 * l, 12.0, -6.0 * l], [6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l]]))

    def mass(self, freedoms, matrix):
        self.masses.append((list(freedoms), np.asarray(matrix, dtype=float)))

    def bar_mass(self, a, b, mass):
        self.mass((a, b), mass / 6.0 * np.array([[2.0, 1.0], [1.0, 2.0]]))

    def beam_mass(self, a, b, mass, rotary, length):
        """Cubic shapes; `rotary`: density times second moment of area times length."""
        l = length
        self.mass((*a, *b), mass / 420.0 * np.array([
            [156.0, 22.0 * l, 54.0, -13.0 * l], [22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l],
            [54.0, 13.0 * l, 156.0, -22.0 * l], [-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l]])
            + rotary / (30.0 * l * l) * np.array([
                [36.0, 3.0 * l, -36.0, 3.0 * l], [3.0 * l, 4.0 * l * l, -3.0 * l, -l * l],
                [-36.0, -3.0 * l, 36.0, -3.0 * l], [3.0 * l, -l * l, -3.0 * l, 4.0 * l * l]]))

    def modes(self):
        """Circular frequencies from the lowest, and shapes on all freedoms with phi'M phi = 1, after `solve`."""
        m = np.zeros((self.count, self.count))
        for freedoms, matrix in self.masses:
            m[np.ix_(freedoms, freedoms)] += matrix
        t, k = self.reduction, self.tangent
        d = 1.0 / np.sqrt(np.diag(k))
        lower = np.linalg.cholesky(d[:, None] * k * d)
        inner = np.linalg.solve(lower, d[:, None] * (t.T @ m @ t) * d)
        inverse, q = np.linalg.eigh(np.linalg.solve(lower, inner.T))
        order = [i for i in np.argsort(-inverse) if inverse[i] > 1e-14 * inverse.max()]
        shapes = t @ (d[:, None] * np.linalg.solve(lower.T, q[:, order])) / np.sqrt(inverse[order])
        return 1.0 / np.sqrt(inverse[order]), shapes, m

    def spring(self, freedom, stiffness):
        self.element((freedom,), [[stiffness]])

    def hold(self, freedom, at=0.0, terms=()):
        """u[freedom] = at + sum of factor * u[other], others free or held before."""
        self.held[freedom] = (at, list(terms))

    def load(self, freedom, force):
        self.loads[freedom] = self.loads.get(freedom, 0.0) + force

    def contact(self, terms, constant, gap=0.0, push=None):
        """w = sum factor u over `terms` {freedom: factor}; N = constant <w - gap>^1.5 acts along `push`, w's own
        terms by default."""
        self.rows.append((terms, constant, gap, push or terms))

    def solve(self, start_load, extra=None):
        """Displacements and normal forces. `start_load`: a normal force near which contacts start. `extra`: more
        loads, a vector."""
        n = self.count
        k = np.zeros((n, n), dtype=WIDE)
        for freedoms, matrix in self.stiff:
            k[np.ix_(freedoms, freedoms)] += matrix
        f = np.zeros(n, dtype=WIDE)
        for freedom, force in self.loads.items():
            f[freedom] += force
        if extra is not None:
            f += extra
        b = np.zeros((len(self.rows), n), dtype=WIDE)
        p = np.zeros_like(b)
        constant = np.array([row[1] for row in self.rows], dtype=WIDE)
        gap = np.array([row[2] for row in self.rows], dtype=WIDE)
        for i, (terms, _, _, push) in enumerate(self.rows):
            for freedom, factor in terms.items():
                b[i, freedom] += factor
            for freedom, factor in push.items():
                p[i, freedom] += factor
        # u = t q + u_0 takes the held freedoms out.
        free = [i for i in range(n) if i not in self.held]
        t, u_0 = np.zeros((n, len(free)), dtype=WIDE), np.zeros(n, dtype=WIDE)
        for column, freedom in enumerate(free):
            t[freedom, column] = 1.0
        for freedom, (at, terms) in self.held.items():
            u_0[freedom] = at
            for other, factor in terms:
                t[freedom] += factor * t[other]
                u_0[freedom] += factor * u_0[other]
        kt, bt, pt = t.T @ k @ t, b @ t, p @ t
        ft = t.T @ (f - k @ u_0)
        w_0 = b @ u_0 - gap

        def normal(q):
            return constant * np.maximum(bt @ q + w_0, 0.0) ** WIDE(1.5)

        def residual(q):
            return ft - kt @ q - pt.T @ normal(q)

        def solve(stiffness, right):
            m = (kt + pt.T @ (stiffness[:, None] * bt)).astype(float)
            d = 1.0 / np.sqrt(np.abs(np.diag(m)))
            m = d[:, None] * m * d
            x = np.zeros(len(right), dtype=WIDE)
            for _ in range(3):
                x += d * np.linalg.solve(m, (d * (right - (kt @ x + pt.T @ (stiffness * (bt @ x))))).astype(float))
            return x

        secant = constant ** WIDE(2 / 3) * WIDE(start_load) ** WIDE(1 / 3)
        q = solve(secant, ft - pt.T @ (secant * w_0))
        floor = 1e-7 * secant
        for _ in range(200):
            r = residual(q)
            tangent = 1.5 * constant * np.sqrt(np.maximum(bt @ q + w_0, 0.0))
            step = solve(np.maximum(tangent, floor), r)
            slope, length = float(step @ r), WIDE(1.0)
            for _ in range(40):  # the slope of the energy must not have turned far
                if abs(float(step @ residual(q + length * step))) <= abs(slope):
                    break
                length /= 2
            q = q + length * step
            if float(np.abs(bt @ step).max()) < 1e-14 * float(np.abs(bt @ q + w_0).max()):
                break
        else:
            raise ArithmeticError("no equilibrium found")
        tangent = 1.5 * constant * np.sqrt(np.maximum(bt @ q + w_0, 0.0))
        self.reduction, self.tangent = t.astype(float), (kt + pt.T @ (tangent[:, None] * bt)).astype(float)
        return (t @ q + u_0).astype(float), normal(q).astype(float)
