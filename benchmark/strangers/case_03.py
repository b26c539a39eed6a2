"""Case 03 from its README alone: displacements in micrometres, Newton's method."""
import csv
import sys

import numpy as np

NR, N, P, E, F = 11, 20, 0.005 / 3, 209e9, 45e3
PSI, K = np.radians((45.0288, 45.0803)), (1.140380570e10, 1.332583806e10)
out = csv.writer(sys.stdout)
out.writerow(("case", "quantity", "value"))


def ring(d, b):
    return np.pi / 4 * (d**2 - b**2)


for number, first in enumerate((0.0543333333, 0.0291666667, 0.004), 1):
    for name, s, held in (("tension", -1, 0.010), ("compression", 1, 0.080)):
        x = first + P * np.arange(N)
        at = np.unique(np.round(np.r_[0, 0.01, 0.08, 0.09, x], 12))  # stations of the nut
        screw, nut, roller = np.arange(N + 1), N + 1 + np.arange(len(at)), N + 1 + len(at) + 3 * np.arange(N + 4)
        size = roller[-1] + 3
        stiff = np.zeros((size, size))

        def add(dofs, matrix):
            stiff[np.ix_(dofs, dofs)] += matrix

        def bar(a, b, ea, length):
            add([a, b], ea / length * np.array([[1, -1], [-1, 1]]))

        for i in range(N):
            bar(screw[i], screw[i + 1], E * ring(0.021, 0.006) / NR, 0.010 if i == 0 else P)
        for i in range(len(at) - 1):
            flange = at[i + 1] < 0.0100001 or at[i] > 0.0799999
            bar(nut[i], nut[i + 1], E * ring(0.062 if flange else 0.046, 0.035) / NR, at[i + 1] - at[i])
        for i, l in enumerate([0.005, P / 2] + [P] * (N - 1) + [P / 2, 0.005]):
            d, a, b = 0.005 if i in (0, N + 2) else 0.007, roller[i], roller[i + 1]
            bar(a, b, E * ring(d, 0), l)
            add([a + 1, a + 2, b + 1, b + 2], E * np.pi / 64 * d**4 / l**3 * np.array(
                [[12, 6*l, -12, 6*l], [6*l, 4*l*l, -6*l, 2*l*l], [-12, -6*l, 12, -6*l], [6*l, 2*l*l, -6*l, 4*l*l]]))
        b = np.zeros((2 * N, size))  # w = b u
        for i in range(N):
            r, (c, n) = roller[i + 2], np.cos(PSI)
            b[i, [screw[i + 1], r, r + 2, r + 1]] = s * c, -s * c, -s * c * 0.0035, -np.sin(PSI[0])
            b[N + i, [r, r + 2, nut[np.abs(at - x[i]).argmin()], r + 1]] = s * n, -s * n * 0.0035, -s * n, np.sin(PSI[1])
        free = np.setdiff1d(np.arange(size), [nut[np.abs(at - held).argmin()], *(roller[[0, 1, -2, -1]] + 1)])
        stiff, b, k = stiff[np.ix_(free, free)], b[:, free], np.repeat(K, N)
        load = np.zeros(len(free))
        load[0] = s * F / NR
        t = 1.5 * k ** (2 / 3) * (F / NR / N) ** (1 / 3)
        u = np.linalg.solve(stiff + b.T @ (t[:, None] * b) / 1.5, load)
        for _ in range(30):
            w = np.maximum(b @ u, 0)
            t = 1.5 * k * np.sqrt(w)
            u = u + np.linalg.solve(stiff + b.T @ (t[:, None] * b), load - stiff @ u - b.T @ (k * w**1.5))
        case = f"position_{number}_{name}."
        out.writerow(("03", case + "displacement_um", 1e6 * s * u[0]))
        out.writerow(("03", case + "stiffness_N_per_um", 1e-6 * F / (s * u[0])))
        for i, force in enumerate(k * np.maximum(b @ u, 0) ** 1.5):
            out.writerow(("03", f"{case}thread_load_{'screw' if i < N else 'nut'}_{i % N + 1}_N", force))
