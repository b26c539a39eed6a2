"""Harmonic n = 1 of the whole roller on its guidance by CalculiX (C3D20, a quarter of the roller).

What curves.py otherwise takes from a beam: traction d f_1(s) cos(theta) of single_harmonics.py on one flank after the other, response
C_1 of the same kind at all 40 contacts, screw side at theta = pi (sign -1). Roller of axisymmetric.py, tension: contacts 0..19
at the screw, flanks facing +x, 20..39 at the nut. Guidance: sections at the outer ends, or those and the inner ends of the
plain parts, up to radius 2.5, have no sideways displacement at any point; they may tilt and warp.

Units: mm per N of contact force of one roller. Usage: roller_bending.py --scratch DIR GUIDANCE SUB:LAYERS [--loads 0,9]; see --help.
"""
import argparse
import json
import os

import axisymmetric as ax
import cyclic_3d as c3
import numpy as np
import single_harmonics as sh

LENGTH = ax.TEETH * ax.PITCH + 2 * ax.END_LENGTH
GUIDED = {"both_end_nodes": (0.0, ax.END_LENGTH, LENGTH - ax.END_LENGTH, LENGTH), "outer_node": (0.0, LENGTH)}


def section(sub):
    """Whole roller, two elements (times sub) on every patch; contacts, half patch lengths, directions."""
    p = ax.patches()
    begin, end = ax.END_LENGTH, LENGTH - ax.END_LENGTH
    centres = begin + ax.PITCH / 2 + ax.PITCH * np.arange(ax.TEETH)
    crest, root, mid = ax.PITCH / 4 - ax.ABOVE, ax.PITCH / 4 + ax.BELOW, ax.PITCH / 4
    breaks = ax.graded(0, begin, 0, 0.25, 1.5, 1.5) + ax.graded(end, LENGTH, 0.25, 0, 1.5, 1.5)
    for c in centres:
        for side, of in ((+1, "screw"), (-1, "nut")):
            w = p[of][0] * sh.C45
            breaks += [c + side * v for v in (crest, mid - w, mid, mid + w, root, ax.PITCH / 2)]
    radius = ax.profile(centres, +1, ax.ROLLER_R, lambda x: True)
    inner = ax.ROLLER_R - ax.BELOW - 0.45
    deep = np.array(ax.graded(sh.HOLE, ax.END_R, 0, 0.3, 1.5, 0.9))
    rows = 1 - np.array(ax.graded(0, 0.75, 0.1, 0, 1.6, 0.4))[::-1] / 0.75
    threaded = lambda x: begin < x < end
    mesh = ax.Mesh(sorted(set(np.round(breaks, 9))), [
        ((deep - sh.HOLE) / (ax.END_R - sh.HOLE), lambda x: sh.HOLE, lambda x: ax.END_R, lambda x: True),
        (np.array([0.0, 1.0]), lambda x: ax.END_R, lambda x: inner, threaded),
        (rows, lambda x: inner, radius, threaded)], sub)
    surface = lambda r, z: np.abs(r - np.array([radius(v) for v in z])) < 1e-9
    contacts = [(c + ax.PITCH / 4, p["screw"][0], sh.inward("roller", +1)) for c in centres]
    contacts += [(c - ax.PITCH / 4, p["nut"][0], sh.inward("roller", -1)) for c in centres]
    return mesh, surface, contacts


def run(scratch, guidance, sub, layers, loads):
    """Columns of C_1 (40 rows) for the contacts `loads`."""
    mesh, surface, contacts = section(sub)
    angle = np.pi / 2
    block = c3.Block(mesh, np.linspace(0, angle, layers + 1))
    r, z, phi = block.rzp.T
    even, odd = np.where(phi < 1e-12)[0] + 1, set(np.where(np.abs(phi - angle) < 1e-9)[0] + 1)
    held = [k for x in GUIDED[guidance] for k in np.where((np.abs(z - x) < 1e-9) & (r < ax.END_R + 1e-9))[0] + 1]
    supports = [([k for k in held if k not in odd], 1), ([k for k in held if phi[k - 1] > 1e-12], 2)]
    forces = []
    for c, a_s, d in contacts:
        edges = mesh.edge(c - a_s * sh.C45 - 1e-9, c + a_s * sh.C45 + 1e-9, surface)
        load = c3.pressure_load(block, edges, sh.wave(sh.amplitude(ax.ROLLER_R, c, a_s, 0, 1), 1), d, 10)
        forces.append(c3.turned(load, odd, angle))
    path = os.path.join(scratch, f"bending_{guidance}_{sub}_{layers}.inp")
    steps = [forces[j] for j in loads]
    c3.write_deck(path, block, [(even, 2)] + supports, (sorted(odd), angle, (1, 3)), steps, set().union(*forces))
    seconds = ax.run_ccx(path)
    sign = np.repeat([-1.0, 1.0], ax.TEETH)
    columns = []
    for j, step in zip(loads, ax.read_dat(path[:-4] + ".dat")):
        columns.append(4 * sign[j] * sign * np.array([c3.work(answer, step["U"]) for answer in forces]))
    matrix = np.array(columns).T
    np.savez(path[:-4] + ".npz", matrix=matrix, loads=np.array(loads), nodes=len(block.rzp), seconds=seconds)
    print(guidance, f"{sub}:{layers}", len(block.rzp), "nodes", f"{seconds:.0f} s", "self", matrix[loads[0], 0], flush=True)
    return matrix


ORDER = 1.7  # of the section's mesh, as for the screw's n = 0 away from the loaded tooth


def store(scratch, guidance):
    """data/roller_bending_GUIDANCE.csv from mesh 1:2 with all loads. What 1:4 and 2:2 change at some loads is nearly a factor each,
    which is extrapolated (16/15 around; ORDER) and taken at all loads. Into roller_bending.json: the factors and the error bar, the
    section's extrapolation and what the factors leave, relative to the largest entry."""
    load = lambda name: np.load(os.path.join(scratch, f"bending_{guidance}_{name}.npz"))
    base, around, finer = load("1_2"), load("1_4"), load("2_2")
    largest = np.abs(base["matrix"]).max()
    kappa = 2.0**-ORDER / (1 - 2.0**-ORDER)
    factors, left = [], []
    for run, grow in ((around, 16 / 15), (finer, 1 + kappa)):
        old = base["matrix"][:, run["loads"]]
        change = grow * (run["matrix"] - old)
        factors.append((change * old).sum() / (old**2).sum())
        left.append(np.abs(change - factors[-1] * old).max() / largest)
    matrix = (1 + sum(factors)) * base["matrix"]
    folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "data")
    np.savetxt(os.path.join(folder, f"roller_bending_{guidance}.csv"), (matrix + matrix.T) / 2, "%.9e", ",")
    path = os.path.join(folder, "roller_bending.json")
    report = json.load(open(path)) if os.path.exists(path) else {}
    report[guidance] = {"nodes": [int(r["nodes"]) for r in (base, around, finer)], "seconds": [float(r["seconds"]) for r in (base, around, finer)],
                        "largest": largest, "asymmetry": np.abs(matrix - matrix.T).max() / largest, "factor_around": factors[0],
                        "factor_section": factors[1], "left_by_factors": left, "error_bar": factors[1] * kappa / (1 + kappa) + sum(left)}
    json.dump(report, open(path, "w"), indent=1)
    print(guidance, report[guidance])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", required=True)
    parser.add_argument("--loads", help="comma-separated contacts; all by default")
    parser.add_argument("--store", action="store_true", help="no run, but data/ from those that are there: 1:2, 1:4, 2:2")
    parser.add_argument("guidance", choices=list(GUIDED))
    parser.add_argument("mesh", nargs="?", default="1:2", help="subdivision of the section : elements over the quarter")
    args = parser.parse_args()
    if args.store:
        store(args.scratch, args.guidance)
        raise SystemExit
    os.makedirs(args.scratch, exist_ok=True)
    loads = [int(v) for v in args.loads.split(",")] if args.loads else list(range(2 * ax.TEETH))
    run(args.scratch, args.guidance, *map(int, args.mesh.split(":")), loads)
