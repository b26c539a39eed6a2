"""Single Fourier harmonics of a block of equal teeth by CalculiX: 3D sector (C3D20), a quarter of one wave.

A block of 2 reach + 1 teeth, free ends half a pitch beyond the centres of the outer teeth. Traction on one flank of the middle tooth,
    t = d f_n(s) cos(n theta),    f_n = q(s)/(pi r),    q = 3/(4a) (1 - s^2/a^2),
d: the flank's inward normal, s: distance from the pitch line along the flank. f_n is what a unit force at theta = 0, spread
over s only, has as harmonic n >= 1. The response is energy-conjugate, over the whole circle,
    C_n(distance) = integral integral f_n(s) cos(n theta) d . u r dtheta ds    on a flank `distance` teeth further along +x,
in mm per N. N equal contacts around the circle (n a multiple of N): N C_n per contact force of one.

With --patch the traction is that of the Hertz ellipse, f_n = p_0 A^2/(a_t r) J_1(x)/x, x = n A/r, A = a_t sqrt(1 - s^2/a_s^2),
p_0 = 3/(2 pi a_s a_t), of which the above is the limit a_t -> 0.

cos(n theta) is even about theta = 0 (u_theta = 0 there) and odd about pi/(2n) (u_r = u_x = 0 there): no rigid motion is left for n >= 2.
Units: mm, N. Usage: single_harmonics.py --scratch DIR BODY:HARMONIC:REACH ...; see --help.
"""
import argparse
import json
import os

import axisymmetric as ax
import cyclic_3d as c3
import numpy as np
from scipy.special import j1

C45 = np.cos(np.pi / 4)
HOLE = 0.02  # mm, radius of a hole instead of the roller's axis
PITCH_R = {"screw": ax.SCREW_R, "nut": ax.NUT_R, "roller": ax.ROLLER_R}
FAR_R = {"screw": ax.BORE_R, "nut": ax.NUT_OUTER_R, "roller": HOLE}
# flank -> (side its outward normal looks to along x, body whose contact it is), in tension
FLANKS = {"screw": {"backward": (-1, "screw")}, "nut": {"forward": (+1, "nut")},
          "roller": {"forward": (+1, "screw"), "backward": (-1, "nut")}}


def inward(body, side):
    return (C45 if body == "nut" else -C45, -side * C45)


def columns(body, reach, spans):
    """Break points of the coarse mesh along x; spans: side -> half the patch's axial length. Tooth k is centred at k pitch."""
    crest, root, mid = ax.PITCH / 4 - ax.ABOVE, ax.PITCH / 4 + ax.BELOW, ax.PITCH / 4
    def half(fine, side):
        w = spans.get(side)
        if fine and w:
            size = w / 2
            points = ax.graded(0, crest, 0, 0.07, 1.5, 0.1) + ax.graded(crest, mid - w, 0.07, size, 1.5, 0.1)
            points += list(np.linspace(mid - w, mid + w, 5)) + ax.graded(mid + w, root, size, 0.06, 1.5, 0.1)
            return points + ax.graded(root, ax.PITCH / 2, 0.06, 0, 1.5, 0.1)
        middle = [mid - w, mid, mid + w] if w else [(crest + root) / 2]
        return [0.0, crest] + middle + [root, ax.PITCH / 2]
    points = []
    for k in range(-reach, reach + 1):
        for side in (-1, +1):
            points += [k * ax.PITCH + side * v for v in half(k == 0, side)]
    return sorted(set(np.round(points, 10)))


def block_section(body, reach, sub, spans, near):
    """Section of the block; near: thickness of the first row of elements under the flank."""
    sign, pitch_r, far = (-1 if body == "nut" else +1), PITCH_R[body], FAR_R[body]
    radius = ax.profile([0.0], sign, pitch_r, lambda x: True)
    depth = pitch_r - sign * (ax.BELOW + 0.45)
    rows = np.array(ax.graded(0, 0.75, near, 0, 1.45, 0.3)) / 0.75  # from the surface
    largest = {"screw": 2.0, "nut": 1.5, "roller": 0.6}[body]
    if sign > 0:
        deep = np.array(ax.graded(far, depth, 0, 0.3, 1.45, largest))
        groups = [((deep - far) / (depth - far), lambda x: far, lambda x: depth, lambda x: True),
                  (1 - rows[::-1], lambda x: depth, radius, lambda x: True)]
    else:
        deep = np.array(ax.graded(depth, far, 0.3, 0, 1.45, largest))
        groups = [(rows, radius, lambda x: depth, lambda x: True),
                  ((deep - depth) / (far - depth), lambda x: depth, lambda x: far, lambda x: True)]
    mesh = ax.Mesh(columns(body, reach, spans), groups, sub)
    return mesh, lambda r, z: np.abs(r - np.array([radius(v) for v in z])) < 1e-9


def amplitude(pitch_r, z0, a_s, a_t, n):
    """f_n at (r, z), n >= 1; a_t = 0: without extent around the circle."""
    def f(r, z):
        height = np.maximum(0, 1 - ((r - pitch_r) ** 2 + (z - z0) ** 2) / a_s**2)
        if a_t == 0:
            return 3 / (4 * a_s) * height / (np.pi * r)
        x = n * a_t * np.sqrt(height) / r
        share = np.where(x > 1e-6, 2 * j1(x) / np.maximum(x, 1e-30), 1.0)
        return 3 / (4 * np.pi * a_s * r) * height * share
    return f


def wave(f, n):
    return lambda r, z, phi: f(r, z) * np.cos(n * phi)


def run(scratch, body, n, reach, sub, layers, patch_scale=1.0, ellipse=False):
    """C_n by (flank loaded, flank of response): list over distance -reach..reach; and the run's facts."""
    p = ax.patches()
    sizes = {flank: (side, p[of][0] * patch_scale, p[of][1] * patch_scale if ellipse else 0.0)
             for flank, (side, of) in FLANKS[body].items()}
    mesh, surface = block_section(body, reach, sub, {side: a * C45 for side, a, _ in sizes.values()}, 0.07 * patch_scale**0.5)
    angle = np.pi / (2 * n)
    block = c3.Block(mesh, np.linspace(0, angle, layers + 1))
    phi = block.rzp[:, 2]
    even, odd = np.where(phi < 1e-12)[0] + 1, set(np.where(np.abs(phi - angle) < 1e-9)[0] + 1)
    loads = {}
    for flank, (side, a_s, a_t) in sizes.items():
        for k in range(-reach, reach + 1):
            c = (k + side / 4) * ax.PITCH
            edges = mesh.edge(c - a_s * C45 - 1e-9, c + a_s * C45 + 1e-9, surface)
            load = c3.pressure_load(block, edges, wave(amplitude(PITCH_R[body], c, a_s, a_t, n), n), inward(body, side), 10)
            loads[flank, k] = c3.turned(load, odd, angle)
    name = f"{body}_n{n}_{2 * reach + 1}_{sub}_{layers}" + (f"_{patch_scale}" if ellipse or patch_scale != 1 else "")
    path = os.path.join(scratch, name + ".inp")
    steps = [loads[flank, 0] for flank in sizes]
    c3.write_deck(path, block, [(even, 2)], (sorted(odd), angle, (1, 3)), steps, set().union(*loads.values()))
    seconds = ax.run_ccx(path)
    result = ax.read_dat(path[:-4] + ".dat")
    out = {"body": body, "harmonic": n, "teeth": 2 * reach + 1, "sub": sub, "layers": layers, "ellipse": ellipse,
           "patch_scale": patch_scale, "nodes": len(block.rzp), "seconds": seconds, "values": {}}
    for step, loaded in zip(result, sizes):
        for answer in sizes:
            out["values"][f"{loaded} {answer}"] = [4 * n * c3.work(loads[answer, k], step["U"]) for k in range(-reach, reach + 1)]
    json.dump(out, open(os.path.join(scratch, name + ".json"), "w"), indent=1)
    return out


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", required=True)
    parser.add_argument("--mesh", default="1:2", help="subdivision of the section : elements around the quarter wave; several with commas")
    parser.add_argument("--patch", type=float, help="load of the Hertz ellipse, scaled by this")
    parser.add_argument("cases", nargs="+", help="BODY:HARMONIC:REACH")
    args = parser.parse_args()
    os.makedirs(args.scratch, exist_ok=True)
    for case in args.cases:
        body, n, reach = case.split(":")
        for mesh in args.mesh.split(","):
            sub, layers = map(int, mesh.split(":"))
            out = run(args.scratch, body, int(n), int(reach), sub, layers, args.patch or 1.0, bool(args.patch))
            mid = {k: v[int(reach)] for k, v in out["values"].items()}
            print(case, mesh, out["nodes"], f"{out['seconds']:.1f} s", mid, flush=True)
