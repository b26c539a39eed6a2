"""Load distribution of the standard screw of lesson 5 on elastic bodies: the method of the scripts beside this one on another screw.

30 x 10 mm, ten rollers with 35 threads each, a nut with one flange: in its middle as in the lesson (face x = 40 presses), or at its loaded
end (face x = 0 presses). Tension. Bodies as in SOURCE.md; other than there the thread of the screw continues on both sides of the
rollers and the nut is threaded throughout. Mesh 1 with all loads, mesh 2 with those of FEW threads, the others changing as those at the
same distance; limit by the orders of the Abevi screw (ORDERS).

Usage: lesson_5.py --scratch DIR [STEP ..], in this order: rings, harmonics, bending, curves. The last writes data/lesson_5.json.
"""
import argparse
import json
import os

import axisymmetric as ax
import numpy as np

ax.E, ax.ROLLERS, ax.TEETH, ax.PITCH, ax.ABOVE, ax.BELOW = 210000.0, 10, 35, 2.0, 0.30, 0.46
ax.SCREW_R, ax.ROLLER_R, ax.NUT_R, ax.FORCE = 15.0, 5.0, 25.0, 60000.0
ax.NUT_OUTER_R = 33.0
ax.FREE_LENGTH, ax.BORE_R, ax.END_LENGTH, ax.END_R = 20.0, 3.0, 8.0, 3.5
NUT_LENGTH, FLANGE_R, NUT_POSITION = 100.0, 49.0, 16.0
FLANGES = {"middle": (40.0, 60.0, 40.0), "end": (0.0, 20.0, 0.0)}  # from, to, face that presses
SCREW_BEFORE, SCREW_AFTER, NUT_BEFORE, NUT_AFTER = 9, 5, 6, 7  # teeth that no roller touches

import curves as cu  # noqa: E402  (these take constants from ax)
import harmonic_sum as hs  # noqa: E402
import roller_bending as rb  # noqa: E402
import single_harmonics as sh  # noqa: E402

T, N = ax.TEETH, ax.ROLLERS
C45 = np.cos(np.pi / 4)
ORDERS = {"screw": (2.4, 1.7), "nut": (2.5, 0.7), "roller": (2.7, 1.6)}  # of the loaded tooth's own part, of the rest
FEW = (0, 8, 17, 26, 34)  # threads
WAVES = {"screw": (10, 130), "nut": (10, 130), "roller": (2, 40)}  # harmonics, first and last; beyond: the half-space
FINER = {"screw": (10, 20, 40, 70, 100, 130), "nut": (10, 20, 40, 70, 100, 130), "roller": (2, 3, 4, 6, 9, 13, 18, 25, 33, 40)}
FINEST = {"screw": (40,), "nut": (20,), "roller": (4, 25)}


def breaks_of(first, count, loaded, faces, patch):
    """Break points of `count` periods from the tooth centred at `first`; fine at the centres in `loaded`."""
    out = [first - ax.PITCH / 2]
    for k in range(count):
        centre = first + k * ax.PITCH
        near = np.min(np.abs(np.array(loaded) - centre)) < 1e-9
        out += [centre + v for v in ax.tooth_breaks(faces if near else set(), patch)[1:]]
    return out


def surface_of(radius):
    return lambda r, z: np.abs(r - np.array([radius(v) for v in z])) < 1e-9


def screw(n):
    half = ax.patches()["screw"][0]
    contacts = ax.FREE_LENGTH + ax.PITCH * np.arange(T)
    centres = contacts + ax.PITCH / 4
    first = centres[0] - SCREW_BEFORE * ax.PITCH
    begin = first - 0.75 * ax.PITCH
    radius = ax.profile([first], +1, ax.SCREW_R, lambda x: x > begin)
    breaks = ax.graded(0, begin, 0, 0.2, 1.35, 1.5) + [begin + v * ax.BELOW / 2 for v in (1, 2)]
    breaks += breaks_of(first, SCREW_BEFORE + T + SCREW_AFTER, centres, {-1}, half * C45)
    inner = ax.SCREW_R - ax.BELOW - 0.55
    deep = np.array(ax.graded(0.0, inner, 0, 0.4, 1.4, 2.5))
    mesh = ax.Mesh(sorted(set(np.round(breaks, 12))), [
        (deep / inner, lambda x: 0.0, lambda x: inner, lambda x: True), (ax.TOOTH_ROWS, lambda x: inner, radius, lambda x: True)], n)
    weights = [ax.patch_weights(mesh, (ax.SCREW_R, x), half, surface_of(radius)) for x in contacts]
    return mesh, contacts, weights, [(-C45, C45)] * T


def nut(flange, n):
    start, stop, face = FLANGES[flange]
    half = ax.patches()["nut"][0]
    contacts = NUT_POSITION + ax.PITCH * np.arange(T)
    centres = contacts - ax.PITCH / 4
    first, count = centres[0] - NUT_BEFORE * ax.PITCH, NUT_BEFORE + T + NUT_AFTER
    begin, end = first - 0.75 * ax.PITCH, first + (count - 0.25) * ax.PITCH
    radius = ax.profile([first], -1, ax.NUT_R, lambda x: begin < x < end)
    breaks = ax.graded(0, begin, 0, 0.2, 1.4, 2.0) + [begin + v * ax.BELOW / 2 for v in (1, 2)]
    breaks += breaks_of(first, count, centres, {+1}, half * C45)
    breaks += [end - v * ax.BELOW / 2 for v in (1, 2)] + ax.graded(end, NUT_LENGTH, 0.2, 0, 1.4, 2.0)
    for mark in (start, stop):  # columns that end at the flange
        if 0 < mark < NUT_LENGTH:
            breaks = [v for v in breaks if not 1e-9 < abs(v - mark) < 0.06] + [mark]
    outer = ax.NUT_R + ax.BELOW + 0.55
    deep = np.array(ax.graded(outer, ax.NUT_OUTER_R, 0.45, 0.2, 1.4, 1.6))
    out = np.array(ax.graded(ax.NUT_OUTER_R, 38.0, 0.1, 0, 1.25, 0.3) + ax.graded(38.0, FLANGE_R, 0.3, 0, 1.35, 1.6)[1:])
    mesh = ax.Mesh(sorted(set(np.round(breaks, 12))), [
        (1 - np.array(ax.TOOTH_ROWS[::-1]), radius, lambda x: outer, lambda x: True),
        ((deep - outer) / (ax.NUT_OUTER_R - outer), lambda x: outer, lambda x: ax.NUT_OUTER_R, lambda x: True),
        ((out - ax.NUT_OUTER_R) / (FLANGE_R - ax.NUT_OUTER_R), lambda x: ax.NUT_OUTER_R, lambda x: FLANGE_R, lambda x: start < x < stop)], n)
    weights = [ax.patch_weights(mesh, (ax.NUT_R, x), half, surface_of(radius)) for x in contacts]
    return mesh, contacts, weights, [(C45, -C45)] * T


def seat_nodes(mesh, face, outer):
    r, z = mesh.coords.T
    nodes = np.where((np.abs(z - face) < 1e-9) & (r > ax.NUT_OUTER_R - 1e-9) & (r < outer + 1e-9))[0] + 1
    return sorted(nodes, key=lambda k: mesh.coords[k - 1][0])


def seat_radius(scratch, flange):
    """Outer radius of the part of the face that presses under equal loads; elements that would pull are released from the rim inwards."""
    mesh, _, weights, d = nut(flange, 1)
    face, outer = FLANGES[flange][2], FLANGE_R
    path = os.path.join(scratch, f"seat_{flange}.inp")
    while True:
        nodes = seat_nodes(mesh, face, outer)
        ax.write_deck(path, mesh, weights, nodes, [[(j, *d[j]) for j in range(T)]], rf="nodes")
        ax.run_ccx(path)
        force = ax.read_dat(path[:-4] + ".dat")[0]["RF"]
        r, f = (np.array(v) for v in zip(*((mesh.coords[k - 1][0], force[k][1]) for k in nodes)))
        corners = r[::2]  # every other node is at mid-side
        if f[r > corners[-2] + 1e-9].sum() >= 0 or len(corners) < 4:
            return outer
        outer = corners[-2]


def rings(scratch):
    for name in ("screw", "nut_middle", "nut_end", "roller"):
        body, _, flange = name.partition("_")
        outer = seat_radius(scratch, flange) if flange else 0.0
        for n in (1, 2):
            if body == "nut":
                build, support, equations = nut(flange, n), lambda m: seat_nodes(m, FLANGES[flange][2], outer), ()
            elif body == "screw":
                build, support, equations = screw(n), lambda m: list(np.where(np.abs(m.coords[:, 1]) < 1e-9)[0] + 1), ()
            else:
                build, support = ax.roller_mesh(n), lambda m: []
                equations = (ax.section_mean(build[0], 0.0),)
            count = len(build[1])
            loads = list(range(count)) if n == 1 else [i + first for first in range(0, count, T) for i in FEW]
            normal, _, _, reaction, seconds, nodes = ax.solve(scratch, f"lesson_5_{name}_{n}", build, support, loads, equations)
            np.savez(os.path.join(scratch, f"lesson_5_{name}_{n}.npz"), normal=normal, loads=loads, reaction=reaction, nodes=nodes, outer=outer)
            print(name, n, nodes, "nodes", f"{seconds:.0f} s, seat to {outer:.2f}, reaction {reaction[0]:.6f}", flush=True)


def harmonics(scratch):
    sh.FAR_R["screw"] = 3.0  # of a solid screw: harmonics from 10 on do not reach it
    folder = os.path.join(scratch, "lesson_5")
    os.makedirs(folder, exist_ok=True)
    for body, (first, last) in WAVES.items():
        step = first if body != "roller" else 1
        reach = lambda n: 4 if n <= 2 * first else 3 if n <= 3 * first else 2
        for n in range(first, last + 1, step):
            for sub, layers in [(1, 2)] + [(1, 4), (2, 2)] * (n in FINER[body]) + [(3, 2)] * (n in FINEST[body]):
                if os.path.exists(os.path.join(folder, f"{body}_n{n}_{2 * reach(n) + 1}_{sub}_{layers}_1.0.json")):
                    continue
                out = sh.run(folder, body, n, reach(n), sub, layers, 1.0, True)
                print(body, n, sub, layers, out["nodes"], f"{out['seconds']:.1f} s", flush=True)


def bending(scratch):
    folder = os.path.join(scratch, "lesson_5")
    os.makedirs(folder, exist_ok=True)
    rb.run(folder, "both_end_nodes", 1, 2, list(range(2 * T)))
    for sub, layers in ((1, 4), (2, 2)):
        rb.run(folder, "both_end_nodes", sub, layers, [17, T + 17])


def finer(one, run):
    """Mesh 2 with all loads, from those that were run on it."""
    loads, side = list(run["loads"]), lambda i: i // T
    change = np.full_like(one, np.nan)
    change[:, loads] = run["normal"] - one[:, loads]
    for i, j in zip(*np.where(np.isnan(change))):
        alike = [change[k + i - j, k] for k in loads if 0 <= k + i - j < len(one) and (side(k), side(k + i - j)) == (side(j), side(i))]
        change[i, j] = np.mean(alike)
    return one + change


def extrapolated(body, one, two):
    """Limit of meshes 1 and 2."""
    on, off = (2.0**-q / (1 - 2.0**-q) for q in ORDERS[body])
    step = two - one
    limit = two + off * step
    for j in range(len(step)):
        first = j // T * T
        near = [i for i in (j - 1, j + 1) if first <= i < first + T]
        limit[j, j] += (on - off) * (step[j, j] - step[near, j].mean())
    return limit


def bent(scratch):
    """Harmonic 1 of the roller: as roller_bending.store()."""
    load = lambda name: np.load(os.path.join(scratch, "lesson_5", f"bending_both_end_nodes_{name}.npz"))
    base = load("1_2")["matrix"]
    factor, kappa = 1.0, 2.0**-rb.ORDER / (1 - 2.0**-rb.ORDER)
    for name, grow in (("1_4", 16 / 15), ("2_2", 1 + kappa)):
        run = load(name)
        old = base[:, run["loads"]]
        factor += grow * ((run["matrix"] - old) * old).sum() / (old**2).sum()
    return factor * (base + base.T) / 2, factor


def curves(scratch):
    read = lambda name, n: np.load(os.path.join(scratch, f"lesson_5_{name}_{n}.npz"))
    symmetric = lambda m: (m + m.T) / 2
    cu.E, cu.ROLLERS, cu.TEETH, cu.PITCH = ax.E, N, T, ax.PITCH
    # The contact law is that of the program, exact Hertz on the flanks: `prs contact`. Bodies alone are compared.
    cu.HERTZ, cu.PSI = (382302.88510378695, 433902.5171538532), (np.radians(45.31819669189077), np.radians(45.1156371794153))
    local, error = {}, {}
    folder = os.path.join(scratch, "lesson_5")
    for body in ("screw", "nut"):
        sums, facts = hs.total(folder, body, 1.0)
        (key, v), = sums.items()
        local[body], error[body] = cu.banded(hs.fold(v)), facts[key]["error"]
    sums, facts = hs.total(folder, "roller", 1.0)
    error["roller"] = max(f["error"] for f in facts.values())
    block = lambda values: sum(v * np.eye(T, k=k) for k, v in values.items())
    both = lambda v: block({k: v[abs(k)] for k in range(-4, 5)})
    one, two = sums["forward backward"], sums["backward forward"][::-1]
    cross = block({k: (one[k + 4] + two[k + 4]) / 2 for k in range(-4, 5)})
    local["roller"] = np.block([[both(hs.fold(sums["forward forward"])), cross], [cross.T, both(hs.fold(sums["backward backward"]))]])
    bend, factor = bent(scratch)

    def matrix(flange, pick):
        ring = {}
        for body in ("screw", "nut", "roller"):
            name = f"nut_{flange}" if body == "nut" else body
            one = read(name, 1)["normal"]
            ring[body] = (1 if body == "roller" else N) * symmetric(pick(body, one, finer(one, read(name, 2))))
        return cu.assemble(ring["screw"] + local["screw"], ring["nut"] + local["nut"], ring["roller"] + bend + local["roller"], 0.0)

    report = {"unit": "um, N/um, percent of a roller's load", "force_kN": 60, "harmonics_error_mm_per_N": error, "bending_factor": factor,
              "nodes": {b: [int(read(b, n)["nodes"]) for n in (1, 2)] for b in ("screw", "nut_middle", "nut_end", "roller")},
              "seat_outer_radius_mm": {f: float(read(f"nut_{f}", 2)["outer"]) for f in FLANGES}}
    for flange in FLANGES:
        for name, pick in (("mesh 1", lambda b, c1, c2: c1), ("mesh 2", lambda b, c1, c2: c2), ("limit", extrapolated)):
            um, stiffness, s, n = cu.result(matrix(flange, pick), 60.0)
            report.setdefault(f"flange in the {flange}" if flange == "middle" else "flange at the end", {})[name] = {
                "axial_displacement_um": um, "axial_stiffness_N_per_um": stiffness,
                "screw_load_rate_percent": (100 * s).tolist(), "nut_load_rate_percent": (100 * n).tolist()}
            print(flange, name, f"{um:.4f} um {stiffness:.2f} N/um screw {100 * s.max():.3f} nut {100 * n.max():.3f}")
    rounded = lambda v: ({k: rounded(w) for k, w in v.items()} if isinstance(v, dict) else [rounded(w) for w in v] if isinstance(v, list)
                         else float(f"{v:.8g}") if isinstance(v, float) else v)
    json.dump(rounded(report), open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "data", "lesson_5.json"), "w"), indent=1)


if __name__ == "__main__":
    steps = {"rings": rings, "harmonics": harmonics, "bending": bending, "curves": curves}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", required=True)
    parser.add_argument("steps", nargs="*", metavar="STEP", help=", ".join(steps))
    args = parser.parse_args()
    os.makedirs(args.scratch, exist_ok=True)
    for step in args.steps or steps:
        steps[step](args.scratch)
