"""The contact problem of all rollers on the matrices of full_mechanism.py: loads of every thread under loads that are not symmetric.

    p + sum C N + g = Q q,   N = k <p>^1.5,   Q'N = f
p: Hertz approach of a contact, C: flexibilities of screw, nut and roller, q: rigid motions of the screw (u, y, z, y', z' at its
clamped end) and of each roller along the axis (the housing guides its ends), f: load on the screw. k: exact Hertz on the pitch
line. Solved by Newton's method on p. `bars`: the same on matrices of bars and beams, which the program has to give too.

Units: mm, N. Usage: full_curves.py DIR, the folder of full_mechanism.py; writes data/full_mechanism.json. Without one: prints bars.
"""
import json
import os
import sys

import axisymmetric as ax
import full_mechanism as fm
import numpy as np

C45 = np.cos(np.pi / 4)
T, N = fm.TEETH, fm.ROLLERS
PHI = 2 * np.pi / N * np.arange(N)
X = ax.FREE_LENGTH + ax.PITCH * np.arange(T)
CASES = {  # missing rollers, load (side force y, moment about z), diameter deviation of roller 1
    "aligned": ([], 0.0, 0.0),
    "missing roller": ([0], 0.0, 0.0),
    "thick roller": ([], 0.0, 0.0, 4e-3),
    "moment": ([], 0.0, 2000.0),
    "side force": ([], 60.0, 0.0),
}


def beam(x, ea, ei, held):
    """Flexibility over (u, v, theta) of a chain of uniform Euler-Bernoulli beams; held: (node, freedom)."""
    n = 3 * len(x)
    k = np.zeros((n, n))
    for i, l in enumerate(np.diff(x)):
        a, b = ea[i] / l, ei[i] / l**3
        e = np.array([[a, 0, 0, -a, 0, 0], [0, 12 * b, 6 * b * l, 0, -12 * b, 6 * b * l], [0, 6 * b * l, 4 * b * l * l, 0, -6 * b * l, 2 * b * l * l],
                      [-a, 0, 0, a, 0, 0], [0, -12 * b, -6 * b * l, 0, 12 * b, -6 * b * l], [0, 6 * b * l, 2 * b * l * l, 0, -6 * b * l, 4 * b * l * l]])
        k[3 * i:3 * i + 6, 3 * i:3 * i + 6] += e
    free = np.setdiff1d(np.arange(n), [3 * i + j for i, j in held])
    c = np.zeros((n, n))
    c[np.ix_(free, free)] = np.linalg.inv(k[np.ix_(free, free)])
    return c


def bars():
    """Matrices of bars and beams in the form of full_mechanism.py."""
    out = {}
    for body, inner, outer, radius, d in (("screw", ax.BORE_R, ax.SCREW_R, ax.SCREW_R, (-C45, C45)), ("nut", ax.NUT_R, ax.NUT_OUTER_R, ax.NUT_R, (C45, -C45))):
        area, inertia = np.pi * (outer**2 - inner**2), np.pi / 4 * (outer**4 - inner**4)
        x = np.concatenate([[0.0], X])
        c = beam(x, [ax.E * area] * T, [ax.E * inertia] * T, [(0, 0), (0, 1), (0, 2)])
        form = np.zeros((T, 3 * len(x)))  # of the plane through the load: v along e, theta tilts the arm
        axial = np.zeros_like(form)
        for i in range(T):
            axial[i, 3 * (i + 1)] = d[1]
            form[i, 3 * (i + 1) + 1], form[i, 3 * (i + 1) + 2] = d[0], -radius * d[1]
        out[body] = np.array([axial @ c @ axial.T + np.cos(a) * form @ c @ form.T for a in fm.AZIMUTHS])
    middle = ax.END_LENGTH + ax.PITCH / 2 + ax.PITCH * np.arange(T)
    ends = np.array([0.0, ax.END_LENGTH, T * ax.PITCH + ax.END_LENGTH, T * ax.PITCH + 2 * ax.END_LENGTH])
    x = np.concatenate([ends[:2], middle, ends[2:]])
    radii = np.array([ax.END_R] + [ax.ROLLER_R] * (T + 1) + [ax.END_R])
    last = len(x) - 1
    c = beam(x, ax.E * np.pi * radii**2, ax.E * np.pi / 4 * radii**4, [(0, 0)] + [(i, 1) for i in (0, 1, last - 1, last)])
    form = np.zeros((2 * T, 3 * len(x)))  # v outwards from the screw: the screw's side at -r
    for i in range(T):
        for row, side in ((i, -1.0), (T + i, +1.0)):
            d = (-side * C45, -C45 if side < 0 else C45)  # inwards: across, along
            form[row, 3 * (i + 2):3 * (i + 2) + 3] = d[1], d[0], -side * ax.ROLLER_R * d[1]
    out["roller"] = form @ c @ form.T
    return out


def full(ring):
    """[roller, tooth] by [roller, tooth] from [azimuth, tooth, tooth]."""
    c = np.zeros((N, T, N, T))
    for j in range(N):
        for k in range(N):
            apart = abs(j - k)
            c[j, :, k, :] = ring[min(apart, N - apart)]
    return c


def solve(m, case):
    """Loads of the screw's and of the nut's contacts, [roller, tooth]; motions."""
    missing, side, moment, thicker = (*CASES[case], 0.0)[:4]
    here = [j for j in range(N) if j not in missing]
    n = len(here)
    k = {i: ax.patches()[i][5] / ax.patches()[i][2] ** 1.5 for i in ("screw", "nut")}
    stiffness = np.repeat([k["screw"], k["nut"]], n * T)
    c = np.zeros((2, n, T, 2, n, T))
    for s, body in enumerate(("screw", "nut")):
        c[s, :, :, s] += full(m[body])[np.ix_(here, range(T), here, range(T))]
    roller = m["roller"].reshape(2, T, 2, T)
    for j in range(n):
        c[:, j, :, :, j] += roller
    c = c.reshape(2 * n * T, 2 * n * T)
    q = np.zeros((2, n, T, 5 + n))
    for j, number in enumerate(here):
        e = np.array([np.cos(PHI[number]), np.sin(PHI[number])])
        for i in range(T):
            q[0, j, i, :5] = np.concatenate([[-C45], C45 * e, C45 * (X[i] + ax.SCREW_R) * e])
            q[0, j, i, 5 + j], q[1, j, i, 5 + j] = C45, -C45
    q = q.reshape(2 * n * T, 5 + n)
    f = np.zeros(5 + n)
    f[0], f[1], f[3] = -fm.FORCE, side, moment
    p = np.full(2 * n * T, 0.009)
    gap = np.zeros((2, n, T))
    if thicker:
        gap[:, 1:] = C45 * thicker / 2  # the others stand back
    gap = gap.ravel()
    z = np.linalg.lstsq(q, p + gap + c @ (stiffness * p**1.5), rcond=None)[0]
    for _ in range(60):
        force = stiffness * np.maximum(p, 0) ** 1.5
        left = np.concatenate([p + gap + c @ force - q @ z, q.T @ force - f])
        if np.abs(left[:len(p)]).max() < 1e-15 and np.abs(left[len(p):]).max() < 1e-9 * fm.FORCE:
            break
        tangent = 1.5 * stiffness * np.sqrt(np.maximum(p, 1e-9))
        matrix = np.block([[np.eye(len(p)) + c * tangent, -q], [q.T * tangent, np.zeros((5 + n, 5 + n))]])
        step = np.linalg.solve(matrix, -left)
        p, z = p + step[:len(p)], z + step[len(p):]
    else:
        raise RuntimeError(f"{case} does not converge")
    force = (stiffness * np.maximum(p, 0) ** 1.5).reshape(2, n, T)
    loads = np.zeros((2, N, T))
    loads[:, here] = force
    return loads, z


def summary(loads, aligned):
    out = {}
    for s, body in enumerate(("screw", "nut")):
        j, i = np.unravel_index(np.argmax(loads[s]), (N, T))
        out[body] = {"roller_share_percent": (100 * loads[s].sum(1) / loads[s].sum()).tolist(), "largest_normal_load_N": loads[s].max(),
                     "largest_roller": int(j) + 1, "largest_thread": int(i) + 1, "overload_factor": loads[s].max() / aligned[s].max(),
                     "normal_load_N": loads[s].tolist()}
    return out


def results(m):
    solved = {case: solve(m, case) for case in CASES}
    return {case: dict(summary(loads, solved["aligned"][0]), axial_displacement_um=-1e3 * z[0], lateral_um=(1e3 * z[1:3]).tolist(),
                       slope_mrad=(1e3 * z[3:5]).tolist()) for case, (loads, z) in solved.items()}


def level(folder, number, nut, base=None):
    """Matrices of a level, symmetrised; loads that were left out: the base's, plus what the same distance from the loaded tooth changed."""
    out = {}
    for body in ("screw", nut, "roller"):
        run = np.load(os.path.join(folder, f"full_{body}_{number}.npz"))
        got, loaded = run["matrix"], run["loaded"]
        got = got[None] if got.ndim == 2 else got
        count = got.shape[1]
        matrix = np.full((got.shape[0], count, count), np.nan)
        matrix[:, :, loaded] = got
        flipped = matrix.transpose(0, 2, 1)
        matrix = np.where(np.isnan(matrix), flipped, np.where(np.isnan(flipped), matrix, (matrix + flipped) / 2))
        if base is not None:
            old = base["nut" if body == nut else body]
            old = old[None] if old.ndim == 2 else old
            change = matrix - old
            side = lambda i: (i >= T) if body == "roller" else 0
            for a in range(len(change)):
                for i, k in zip(*np.where(np.isnan(change[a]))):
                    alike = [change[a, r, s] for r in range(count) for s in range(count) if not np.isnan(matrix[a, r, s]) and
                             r - s == i - k and (side(r), side(s)) == (side(i), side(k))]
                    change[a, i, k] = np.mean(alike)
            matrix = old + change
        out["nut" if body == nut else body] = matrix[0] if body == "roller" else matrix
    return out


def differences(a, b):
    """Largest difference of shares (in percent of the load); of largest loads, overload factors and displacement (relative)."""
    out = {}
    for case in CASES:
        share = max(np.abs(np.array(a[case][i]["roller_share_percent"]) - b[case][i]["roller_share_percent"]).max() for i in ("screw", "nut"))
        load = max(abs(a[case][i]["largest_normal_load_N"] / b[case][i]["largest_normal_load_N"] - 1) for i in ("screw", "nut"))
        factor = max(abs(a[case][i]["overload_factor"] / b[case][i]["overload_factor"] - 1) for i in ("screw", "nut"))
        moved = abs(a[case]["axial_displacement_um"] / b[case]["axial_displacement_um"] - 1)
        out[case] = {"roller_share_percent": share, "largest_normal_load": load, "overload_factor": factor, "axial_displacement": moved}
    return out


def on_mesh(result):
    """What shows whether the meshes converge."""
    return {case: {"axial_displacement_um": r["axial_displacement_um"]} |
            {f"{what}_{i}": value for i in ("screw", "nut") for what, value in (
                ("overload_factor", r[i]["overload_factor"]), ("largest_roller_share_percent", max(r[i]["roller_share_percent"])),
                ("largest_normal_load_N", r[i]["largest_normal_load_N"]))} for case, r in result.items()}


if __name__ == "__main__":
    ax.ROLLERS, ax.TEETH, ax.FORCE = N, T, fm.FORCE
    report = {"bars": results(bars())}
    if len(sys.argv) > 1:
        there = lambda number: all(os.path.exists(os.path.join(sys.argv[1], f"full_{b}_{number}.npz")) for b in ("screw", "nut_free", "roller"))
        one = level(sys.argv[1], 1, "nut_free")
        meshes = {1: one} | {n: level(sys.argv[1], n, "nut_free", one) for n in (0, 2) if there(n)}
        fine, coarse = sorted(meshes)[-1], sorted(meshes)[-2]
        change = {body: meshes[fine][body] - meshes[coarse][body] for body in one}
        limit = {body: meshes[fine][body] + change[body] / 3 for body in one}
        clamped = dict(limit, nut=limit["nut"] + level(sys.argv[1], 1, "nut_clamped")["nut"] - one["nut"])
        report |= {"finite elements": results(limit), "face clamped": results(clamped),
                   "error_bar": differences(results(meshes[fine]), results(meshes[coarse])), "meshes": [coarse, fine],
                   "mesh by mesh": {str(n): on_mesh(results(m)) for n, m in sorted(meshes.items())},
                   "nodes": {f"{b} {n}": int(np.load(os.path.join(sys.argv[1], f"full_{b}_{n}.npz"))["nodes"]) for n in (coarse, fine)
                             for b in ("screw", "nut_free", "roller")}}
        rounded = lambda v: ({k: rounded(w) for k, w in v.items()} if isinstance(v, dict) else [rounded(w) for w in v] if isinstance(v, list)
                             else float(f"{v:.10g}") if isinstance(v, float) else v)
        path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "data", "full_mechanism.json")
        entry = lambda v: "{\n" + ",\n".join(f"{json.dumps(k)}: {json.dumps(w)}" for k, w in v.items()) + "\n}" if isinstance(v, dict) else json.dumps(v)
        with open(path, "w") as file:  # one case per line
            file.write("{\n" + ",\n".join(f"{json.dumps(k)}: {entry(v)}" for k, v in rounded(report).items()) + "\n}\n")
    for name in ("bars", "finite elements", "face clamped"):
        for case, r in report.get(name, {}).items():
            print(name, case, f"{r['axial_displacement_um']:.4f} um", *(f"{i} {r[i]['largest_normal_load_N']:.3f} N at {r[i]['largest_roller']}/{r[i]['largest_thread']}, "
                  f"{r[i]['overload_factor']:.4f}; " + " ".join(f"{v:.3f}" for v in r[i]["roller_share_percent"]) for i in ("screw", "nut")))
    print("error bar", json.dumps(report.get("error_bar")))
