"""Case 09 from its README alone: all unknowns in one vector, Newton's method."""
import csv
import sys

import numpy as np

NR, N, P, E, F, SIDE, R, A = 5, 4, 0.005 / 3, 209e9, 4000.0, 60.0, 0.0035, 0.014
K, C = (1.004195841e10, 1.140204802e10), np.cos(np.pi / 4)
SCREW, NUT = 0, 5 * (N + 1)             # five unknowns a node: u, y, z, y', z'
ROLLER = lambda j, i: 10 * (N + 1) + 3 * (j * (N + 4) + i)  # u, v, theta
SIZE = ROLLER(NR, 0)
stiff, b = np.zeros((SIZE, SIZE)), np.zeros((2 * NR * N, SIZE))


def element(a, c, outer, bore, l, planes):
    """Bar between the unknowns a and c, beams in planes (deflection, slope) counted from them."""
    i = E * np.pi / 64 * (outer**4 - bore**4) / l**3
    stiff[np.ix_([a, c], [a, c])] += E * np.pi / 4 * (outer**2 - bore**2) / l * np.array([[1, -1], [-1, 1]])
    for d, s in planes:
        at = [a + d, a + s, c + d, c + s]
        stiff[np.ix_(at, at)] += i * np.array([[12, 6 * l, -12, 6 * l], [6 * l, 4 * l * l, -6 * l, 2 * l * l],
                                               [-12, -6 * l, 12, -6 * l], [6 * l, 2 * l * l, -6 * l, 4 * l * l]])


for i in range(N):
    for first, outer, bore in ((SCREW, 0.021, 0.006), (NUT, 0.046, 0.035)):
        element(first + 5 * i, first + 5 * i + 5, outer, bore, 0.010 if i == 0 else P, ((1, 3), (2, 4)))
held = list(range(NUT, NUT + 5))
for j in range(NR):
    e = np.array([np.cos(2 * np.pi * j / NR), np.sin(2 * np.pi * j / NR)])
    for i, l in enumerate([0.005, P / 2] + [P] * (N - 1) + [P / 2, 0.005]):
        element(ROLLER(j, i), ROLLER(j, i + 1), 0.005 if i in (0, N + 2) else 0.007, 0, l, ((1, 2),))
    held += [ROLLER(j, i) + 1 for i in (0, 1, N + 2, N + 3)]
    for i in range(N):  # s = -1
        r, s, n = ROLLER(j, i + 2), SCREW + 5 * (i + 1), NUT + 5 * (i + 1)
        row = b[j * N + i]
        row[[s, r, r + 2, r + 1]] = -C, C, C * R, -C
        row[s + 3 : s + 5], row[s + 1 : s + 3] = C * (A - R) * e, C * e
        row = b[(NR + j) * N + i]
        row[[r, r + 2, n, r + 1]] = -C, C * R, C, C
        row[n + 3 : n + 5], row[n + 1 : n + 3] = -C * (A + R) * e, -C * e
free = np.setdiff1d(np.arange(SIZE), held)
stiff, b, k, load = stiff[np.ix_(free, free)], b[:, free], np.repeat(K, NR * N), np.zeros(len(free))
load[:2] = -F, SIDE


def newton(load, u):
    for _ in range(40):
        w = np.maximum(b @ u, 0)
        t = 1.5 * k * np.sqrt(np.maximum(w, 1e-9))
        u = u + np.linalg.solve(stiff + b.T @ (t[:, None] * b), load - stiff @ u - b.T @ (k * w**1.5))
    return u, (k * np.maximum(b @ u, 0) ** 1.5).reshape(2, NR, N)


u, forces = newton(load, np.linalg.solve(stiff + b.T @ (k[:, None] * 3e-3 * b), load))
rows = [("displacement_um", -1e6 * u[0]), ("screw_end_y_um", 1e6 * u[1]), ("screw_end_rotation_z_mrad", 1e3 * u[3])]
for body, n, aligned in zip(("screw", "nut"), forces, (285.5531611, 284.1414735)):
    rows.append((f"overload_factor_{body}", n.max() / aligned))
    rows += [(f"roller_share_{body}_{j + 1}_percent", 100 * n[j].sum() / n.sum()) for j in range(NR)]
    rows += [(f"thread_load_{body}_{j + 1}_{i + 1}_N", n[j, i]) for j in range(NR) for i in range(N)]
out = csv.writer(sys.stdout)
out.writerow(("case", "quantity", "value"))
out.writerows(("09", *row) for row in rows)
