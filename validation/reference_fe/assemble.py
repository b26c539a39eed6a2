"""From the runs of axisymmetric.py to the stored matrices: extrapolation in the mesh, error bars, checks.

C_inf = C_2 + kappa (C_2 - C_1) from meshes 1 and 2, element size halved (roller: 2 and 3, see roller_limit()). kappa = 2^-q/(1 - 2^-q) with the order q from mesh 3 at
three loaded teeth, separately for the local part of the loaded tooth itself and all the rest:
(C_3 - C_2)/(C_2 - C_1) = (2^-q - 3^-q)/(1 - 2^-q). Error bar: the difference from extrapolating meshes 2 and 3 at the three teeth,
relative to the column's largest entry.

Usage: assemble.py SCRATCH; writes data/*.csv and data/convergence.json. With --shoulder, after curves.py: data/shoulder.json.
Matrices in mm per N of contact force of one roller.
"""
import json
import os
import sys

import axisymmetric as ax
import numpy as np
from scipy.optimize import brentq

HERE = os.path.dirname(os.path.abspath(__file__))


def order(ratio):
    f = lambda q: (2.0**-q - 3.0**-q) / (1 - 2.0**-q) - ratio
    return brentq(f, 0.3, 8.0) if f(0.3) * f(8.0) < 0 else float("nan")


def smooth_self(column, j, size):
    """What the loaded tooth would have without its local part: the mean of its neighbours on the same interface."""
    first = j // ax.TEETH * ax.TEETH
    near = [i for i in (j - 1, j + 1) if first <= i < min(first + ax.TEETH, size)]
    return column[near].mean()


def rates(fine_runs):
    """Median ratio of the local part of the loaded tooth, and of all other entries, from the columns with a mesh 3."""
    on, off = [], []
    a, b, c = (r["normal"] for r in fine_runs)
    for column, j in enumerate(fine_runs[2]["loads"]):
        k2, k1 = list(fine_runs[1]["loads"]).index(j), list(fine_runs[0]["loads"]).index(j)
        step, last = b[:, k2] - a[:, k1], c[:, column] - b[:, k2]
        on.append((last[j] - smooth_self(last, j, len(last))) / (step[j] - smooth_self(step, j, len(step))))
        others = [i for i in range(len(step)) if i != j and abs(step[i]) > 0.2 * np.abs(np.delete(step, j)).max()]
        off += list(last[others] / step[others])
    return float(np.median(on)), float(np.median(off))


def balanced(matrix):
    """The roller's matrix under forces in balance, which do not feel where it is held."""
    axial = np.repeat([1.0, -1.0], ax.TEETH) / np.sqrt(2 * ax.TEETH)
    P = np.eye(2 * ax.TEETH) - np.outer(axial, axial)
    return P @ matrix @ P


def roller_limit(runs):
    """Limit from meshes 2 and 3, all loads: orders of the diagonal (mean over the inner teeth) and of the largest other entries in the balanced
    matrix. Error bar: against the limit from meshes 1 and 2, in the balanced matrix, relative to its largest entry."""
    a, b, c = (r["normal"] for r in runs)
    steps = [balanced(v) for v in (b - a, c - b)]
    inner = [i for i in range(2 * ax.TEETH) if 2 <= i % ax.TEETH < ax.TEETH - 2]
    local = [np.mean([s[i, i] - smooth_self(s[:, i], i, len(s)) for i in inner]) for s in steps]
    off = np.abs(balanced(c))
    np.fill_diagonal(off, 0.0)
    chosen = off > 0.2 * off.max()
    ratios = local[1] / local[0], float(np.median(steps[1][chosen] / steps[0][chosen]))
    q = order(ratios[0]), order(ratios[1])
    limits = [extrapolate(low, high, *(h**-v / (l**-v - h**-v) for v in q)) for low, high, l, h in ((a, b, 1.0, 2.0), (b, c, 2.0, 3.0))]
    error = np.abs(balanced(limits[1] - limits[0])) / np.abs(balanced(limits[1])).max()
    kappa = [3.0**-v / (2.0**-v - 3.0**-v) for v in q]
    report = {"ratio_self": float(ratios[0]), "ratio_others": ratios[1], "order_self": q[0], "order_others": q[1],
              "error_bar_self": float(np.diag(error).max()), "error_bar_others": float((error - np.diag(np.diag(error))).max())}
    return kappa, report


def extrapolate(first, second, kappa_on, kappa_off):
    """Columns: contacts 0, 1, ... loaded."""
    step = second - first
    result = second + kappa_off * step
    for j in range(step.shape[1]):
        result[j, j] += (kappa_on - kappa_off) * (step[j, j] - smooth_self(step[:, j], j, len(step)))
    return result


def plain_checks(scratch):
    """Lame's tube and a bar: the same decks, loads through reference nodes. Relative errors."""
    a, b, length, p = ax.NUT_R, ax.NUT_OUTER_R, 20.0, 1.0
    mesh = ax.Mesh(np.linspace(0, length, 21), [(np.linspace(0, 1, 7), lambda x: a, lambda x: b, lambda x: True)], 1)
    inside = {}
    for e in mesh.edge(0, length, lambda r, z: np.abs(r - a) < 1e-9):
        for k, w in zip(e, (1 / 6, 4 / 6, 1 / 6)):
            inside[k] = inside.get(k, 0) + w / 20
    end = {k: v for k, _, v in ax.section_mean(mesh, length)}  # traction uniform: consistent up to r's slope over an element
    total = sum(end.values())
    end = {k: v / total for k, v in end.items()}
    support = list(np.where(np.abs(mesh.coords[:, 1]) < 1e-9)[0] + 1)
    path = os.path.join(scratch, "plain.inp")
    pressure_force = p * 2 * np.pi * a * length
    first = ax.write_deck(path, mesh, [inside, end], support, [[(0, pressure_force, 0)], [(1, 0, 1000.0)]])
    ax.run_ccx(path)
    s = ax.read_dat(path[:-4] + ".dat")
    lame = p * a / ax.E * ((b * b + a * a) / (b * b - a * a) + ax.NU)
    bar = 1000.0 * length / (ax.E * np.pi * (b * b - a * a))
    return {"lame": s[0]["U"][first][0] / lame - 1, "bar": s[1]["U"][first + 1][1] / bar - 1,
            "reaction_180": s[1]["TOTAL"][1] * -180 / 1000.0 - 1}


def shoulder_checks(scratch, out, config=2):
    """The zone of the shoulder that presses with equal loads and with those of curves.csv, and what another zone changes. Mesh 1."""
    rows = [line.strip().split(",") for line in open(os.path.join(out, "curves.csv"))]
    row = next(r for r in rows if r[:5] == [str(config), "tension", "both_end_nodes", "opposite", "45"])
    loads = [float(v) for v in row[rows[0].index("nut_1_%"):]]
    report = {"zones": {"equal loads, mesh 1": float(ax.shoulder_radius(scratch, config, 1)[0]),
                        f"loads of curves.csv, config {config} tension 45 kN, mesh 1": float(ax.shoulder_radius(scratch, config, 1, loads)[0])}}
    mesh, x, weights, d = ax.nut_mesh(config, 1)
    force = ax.patches()["nut"][5]
    moved = {}
    for zone in (24.54, 25.03, 25.52, 31.0):
        path = os.path.join(scratch, "zone.inp")
        nodes = ax.shoulder_nodes(mesh, zone)
        first = ax.write_deck(path, mesh, weights, nodes, [[(j, d[j][0], d[j][1]) for j in range(ax.TEETH)]])
        ax.run_ccx(path)
        u = ax.read_dat(path[:-4] + ".dat")[0]["U"]
        mean = np.mean([d[i][0] * u[first + i][0] + d[i][1] * u[first + i][1] for i in range(ax.TEETH)])
        moved[round(float(max(mesh.coords[k - 1][0] for k in nodes)), 3)] = float(mean * ax.ROLLERS * force * 1000 * 2**0.5)
    report["axial_displacement_um_at_45kN_by_zone_radius"] = moved
    json.dump(report, open(os.path.join(out, "shoulder.json"), "w"), indent=1)
    print(json.dumps(report, indent=1))


if __name__ == "__main__":
    scratch = sys.argv[1]
    out = os.path.join(HERE, "data")
    if "--shoulder" in sys.argv:
        shoulder_checks(scratch, out)
        raise SystemExit
    os.makedirs(out, exist_ok=True)
    load = lambda name, n: np.load(os.path.join(scratch, f"{name}_{n}.npz"))
    have = lambda name, n: os.path.exists(os.path.join(scratch, f"{name}_{n}.npz"))
    known = os.path.join(out, "convergence.json")  # bodies that were not run again keep their entries
    report = json.load(open(known)) if os.path.exists(known) else {"bodies": {}}
    report |= {"unit": "mm/N per contact force of one roller", "plain": plain_checks(scratch)}
    group = {"screw": "screw_tension", "nut": "nut_config2", "roller": "roller_tension"}
    kappas = {}
    for body, name in group.items():
        if not have(name, 3):
            continue
        if body == "roller":  # mesh 3 with all loads
            kappas[body], report[body] = roller_limit([load(name, n) for n in (1, 2, 3)])
            continue
        fine = [load(name, n) for n in (1, 2, 3)]
        on, off = rates(fine)
        q = order(on), order(off)
        kappa = [2.0**-v / (1 - 2.0**-v) for v in q]
        # error bar: against the extrapolation of meshes 2 and 3 with the same orders; and what mesh 2 itself still lacks
        worst_on, worst_off = 0.0, 0.0
        kappa3 = [3.0**-v / (2.0**-v - 3.0**-v) for v in q]
        for column, j in enumerate(fine[2]["loads"]):
            k2, k1 = list(fine[1]["loads"]).index(j), list(fine[0]["loads"]).index(j)
            a, b, c = fine[0]["normal"][:, k1], fine[1]["normal"][:, k2], fine[2]["normal"][:, column]
            limits = []
            for low, high, k in ((a, b, kappa), (b, c, kappa3)):
                step = high - low
                limit = high + k[1] * step
                limit[j] += (k[0] - k[1]) * (step[j] - smooth_self(step, j, len(step)))
                limits.append(limit)
            error = np.abs(limits[0] - limits[1]) / np.abs(limits[1]).max()
            worst_on, worst_off = max(worst_on, error[j]), max(worst_off, np.delete(error, j).max())
        kappas[body] = kappa
        report[body] = {"ratio_self": on, "ratio_others": off, "order_self": q[0], "order_others": q[1],
                        "error_bar_self": float(worst_on), "error_bar_others": float(worst_off)}
    for name in ("screw_tension", "screw_compression", "nut_config1", "nut_config2", "nut_config3", "roller_tension"):
        body = name.split("_")[0]
        if body not in kappas or not have(name, 2):
            print("missing", name)
            continue
        first, second = (load(name, n) for n in ((2, 3) if body == "roller" else (1, 2)))
        factor = 1 if body == "roller" else ax.ROLLERS
        normal = extrapolate(first["normal"], second["normal"], *kappas[body]) * factor
        asymmetry = np.abs(normal - normal.T).max() / np.abs(normal).max()
        np.savetxt(os.path.join(out, name + ".csv"), (normal + normal.T) / 2, "%.17e", ",")
        for part in ("radial", "axial"):
            np.savetxt(os.path.join(out, f"{name}_{part}.csv"), extrapolate(first[part], second[part], *kappas[body]) * factor, "%.17e", ",")
        step = (normal / factor - second["normal"]) / normal * factor
        off = step[~np.eye(len(step), dtype=bool)]
        reactions = second["reaction"] * 180
        entry = {"nodes": [int(first["nodes"]), int(second["nodes"])], "seconds": [float(first["seconds"]), float(second["seconds"])],
                 "asymmetry": float(asymmetry), "extrapolated_self": float(np.abs(np.diag(step)).max()),
                 "extrapolated_others": float(np.abs(off).max()), "contacts_mm": second["x"].tolist()}
        if body != "roller":
            entry["reaction_error"] = float(np.abs(np.abs(reactions) / np.cos(np.pi / 4) - 1).max())
        if body == "nut":
            entry["shoulder_outer_radius_mm"] = float(open(os.path.join(scratch, f"shoulder_{name.split('_')[1]}.txt")).readline())
        if body == "screw":  # stretch between far teeth, load at the last one: EA of the threaded part
            axial = extrapolate(first["axial"], second["axial"], *kappas[body])[:, 19]
            slope = (axial[10] - axial[4]) / (6 * ax.PITCH)
            area = np.cos(np.pi / 4) / ax.E / abs(slope)
            entry["threaded_area_as_radius_mm"] = float(np.sqrt(area / np.pi + ax.BORE_R**2))
        if body == "roller":
            axial = extrapolate(first["axial"], second["axial"], *kappas[body])[:, 19]
            area = np.cos(np.pi / 4) / ax.E / abs((axial[12] - axial[6]) / (6 * ax.PITCH))
            entry["threaded_area_as_radius_mm"] = float(np.sqrt(area / np.pi))
        report["bodies"][name] = entry
    json.dump(report, open(os.path.join(out, "convergence.json"), "w"), indent=1)
    print(json.dumps(report, indent=1))
