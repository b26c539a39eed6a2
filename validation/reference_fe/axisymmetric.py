"""Influence matrices of screw, nut and roller as bodies of revolution, by CalculiX (CAX8).

Equation: C_ij = sum_k W_ik d_i . u_k^(j), displacement along the flank's inward normal d at tooth i, weighted with the contact
pressure, for a unit ring load along d_j at tooth j. W_ik = integral N_k(s) q(s) ds over the patch, q = 3/(4a) (1 - s^2/a^2):
the Hertz ellipse's pressure summed over its width. The same weights carry the load, so C is symmetric.

Units: mm, N, MPa. Matrices: mm per N of contact force of ONE roller; on screw and nut the ring carries ROLLERS times that.
Needs ccx (Debian: calculix-ccx), numpy, scipy. Usage: see `--help`.
"""
import argparse
import os
import re
import subprocess
import time

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

E, NU = 209000.0, 0.3  # MPa
ROLLERS = 11
TEETH = 20
PITCH = 5.0 / 3.0  # mm
ABOVE, BELOW = 0.25, 0.30  # mm, crest and root from the pitch line
SCREW_R, NUT_R, ROLLER_R = 10.5, 17.5, 3.5  # mm, pitch radii
FORCE = 45000.0  # N, whose mean contact force sets the size of the patches
POSITIONS = {1: 54.0 + 1.0 / 3.0, 2: 29.0 + 1.0 / 6.0, 3: 4.0}  # mm, first contact on the nut
NUT_LENGTH, FLANGE_LENGTH, NUT_OUTER_R, FLANGE_R = 90.0, 10.0, 23.0, 31.0
FREE_LENGTH, BORE_R = 10.0, 3.0
END_LENGTH, END_R = 5.0, 2.5


def hertz_ellipse(load, rho_s, rho_t):
    """Semi-axes along curvature directions s and t (mm) and approach (mm); rho: relative curvatures, 1/mm (Johnson 4.2)."""
    modulus = E / (2 * (1 - NU**2))  # two equal bodies
    lo, hi = min(rho_s, rho_t), max(rho_s, rho_t)
    if hi / lo < 1 + 1e-9:
        k = 1.0
    else:  # k = b/a: rho_hi/rho_lo = (E/k^2 - K)/(K - E)
        ratio = lambda k: (ellipe(1 - k * k) / k**2 - ellipk(1 - k * k)) / (ellipk(1 - k * k) - ellipe(1 - k * k)) - hi / lo
        k = brentq(ratio, 1e-3, 1 - 1e-7)
    m = 1 - k * k
    # rho_lo = 3P/(2 pi E*) (K - E)/(m a^3): a from the sum of the curvatures, good at m = 0 too
    a = (3 * load / (2 * np.pi * modulus) * 2 * ellipe(m) / (k * k) / (2 * (lo + hi))) ** (1 / 3) * 2 ** (1 / 3)
    delta = 3 * load / (2 * np.pi * modulus * a) * ellipk(m)
    large, small = a, k * a
    return (large, small, delta) if rho_s <= rho_t else (small, large, delta)


def patches():
    """(a_s along the flank, a_t around, delta, rho_s, rho_t) of screw-roller and nut-roller at the mean force."""
    load = FORCE / ROLLERS / TEETH / np.cos(np.pi / 4)
    sphere = 1 / (ROLLER_R / np.sin(np.pi / 4))
    out = {}
    for name, around in (("screw", sphere + np.sin(np.pi / 4) / SCREW_R), ("nut", sphere - np.sin(np.pi / 4) / NUT_R)):
        a_s, a_t, delta = hertz_ellipse(load, sphere, around)
        out[name] = (a_s, a_t, delta, sphere, around, load)
    return out


# ---------------------------------------------------------------- meshes

def graded(x0, x1, h0, h1, growth, biggest):
    """Break points from x0 to x1, size h0 at x0, h1 at x1 (0: free), growing by `growth` up to `biggest`."""
    length = x1 - x0
    if length <= 1.2 * max(h0, h1):
        return [x0, x1]
    left, right = [0.0], [0.0]
    hl, hr = h0 or biggest, h1 or biggest
    while left[-1] + right[-1] < length:
        if hl <= hr:
            left.append(left[-1] + hl)
            hl = min(hl * growth, biggest)
        else:
            right.append(right[-1] + hr)
            hr = min(hr * growth, biggest)
    total = left[-1] + right[-1]
    points = left + [total - v for v in reversed(right)]
    points = [v for i, v in enumerate(points) if i == 0 or v > points[i - 1] + 1e-9]
    return [x0 + v * length / total for v in points]


def tooth_breaks(face, patch):
    """Break points of one period about the tooth's centre; `face`: set of +1/-1, flanks with a fine patch."""
    crest, root, mid = PITCH / 4 - ABOVE, PITCH / 4 + BELOW, PITCH / 4
    def half(fine):
        if not fine:
            points = [0.0, crest] + list(crest + (root - crest) * np.array([1, 2, 3]) / 3)
        else:
            w = patch[fine - 1] if isinstance(patch, (list, tuple)) else patch
            points = [0.0, crest / 2 if len(face) == 1 else 0.0, crest]
            points += [mid - w, mid - w / 2, mid, mid + w / 2, mid + w]
            points += [(mid + w + root) / 2, root]
        points.append(PITCH / 2)
        return sorted(set(points))
    right = half(1 if +1 in face else 0)
    left = half((2 if isinstance(patch, (list, tuple)) else 1) if -1 in face else 0)
    return sorted(set([-v for v in left] + right))


def profile(centres, sign, pitch_r, inside_block):
    """Radius of the thread surface; sign +1: teeth outwards. Plain at the pitch radius outside the grooves."""
    def radius(x):
        if not inside_block(x):
            return pitch_r
        d = (x - centres[0]) % PITCH
        d = min(d, PITCH - d)
        height = min(max(PITCH / 4 - d, -BELOW), ABOVE)
        return pitch_r + sign * height
    return radius


class Mesh:
    """Logical grid of columns (axial) and row groups (radial); nodes of CAX8 elements on demand."""

    def __init__(self, columns, groups, n):
        """groups: list of (row parameters 0..1, lower r(x), upper r(x), mask(x_mid)); consecutive groups share a line."""
        sub = lambda p: np.concatenate([np.linspace(p[i], p[i + 1], n, endpoint=False) for i in range(len(p) - 1)] + [[p[-1]]])
        x = sub(np.array(columns))
        xs = np.sort(np.concatenate([x, (x[1:] + x[:-1]) / 2]))  # with mid-side positions
        self.nodes, self.coords, self.elements = {}, [], []
        base = 0
        for params, low, high, mask in groups:
            t = sub(np.array(params))
            ts = np.sort(np.concatenate([t, (t[1:] + t[:-1]) / 2]))
            low_r = np.array([low(v) for v in xs])
            high_r = np.array([high(v) for v in xs])
            # mid-side radii from the straight line between the corners: every edge is straight
            for arr in (low_r, high_r):
                arr[1::2] = (arr[:-1:2] + arr[2::2]) / 2
            def node(i, j):
                key = (i, base + j)
                if key not in self.nodes:
                    r = low_r[i] + (high_r[i] - low_r[i]) * ts[j]
                    self.nodes[key] = len(self.coords) + 1
                    self.coords.append((r, xs[i]))
                return self.nodes[key]
            for i in range(0, len(xs) - 1, 2):
                if not mask(xs[i + 1]):
                    continue
                for j in range(0, len(ts) - 1, 2):
                    # counter-clockwise in (r, z)
                    self.elements.append([node(i, j), node(i, j + 2), node(i + 2, j + 2), node(i + 2, j),
                                          node(i, j + 1), node(i + 1, j + 2), node(i + 2, j + 1), node(i + 1, j)])
            base += len(ts) - 1
        self.coords = np.array(self.coords)
        self.xs = xs

    def edge(self, x0, x1, surface):
        """Element edges (3 node numbers, corner-mid-corner) with all nodes on `surface`(r, x), x0 <= x <= x1."""
        on = surface(self.coords[:, 0], self.coords[:, 1])
        z = self.coords[:, 1]
        keep = on & (z > x0 - 1e-9) & (z < x1 + 1e-9)
        out = []
        for e in self.elements:
            for a, m, b in ((0, 4, 1), (1, 5, 2), (2, 6, 3), (3, 7, 0)):
                t = (e[a], e[m], e[b])
                if all(keep[k - 1] for k in t):
                    out.append(t)
        return out


GAUSS = np.polynomial.legendre.leggauss(5)


def patch_weights(mesh, point, half_length, surface):
    """W_k = integral N_k q ds, q = 3/(4a)(1 - s^2/a^2) about `point` (r, x)."""
    point = np.array(point)
    span = half_length * np.cos(np.pi / 4)
    weights = {}
    for a, m, b in mesh.edge(point[1] - span, point[1] + span, surface):
        pa, pb = mesh.coords[a - 1], mesh.coords[b - 1]
        length = np.linalg.norm(pb - pa)
        for g, w in zip(*GAUSS):
            s = np.linalg.norm(pa + (pb - pa) * (g + 1) / 2 - point)
            q = 3 / (4 * half_length) * max(0.0, 1 - (s / half_length) ** 2) * w * length / 2
            for node, shape in ((a, g * (g - 1) / 2), (m, 1 - g * g), (b, g * (g + 1) / 2)):
                weights[node] = weights.get(node, 0) + q * shape
    assert abs(sum(weights.values()) - 1) < 1e-9, sum(weights.values())
    return weights


TOOTH_ROWS = [0, 0.37, 0.62, 0.79, 0.91, 1.0]


def screw_mesh(s, n, scale=1.0):
    """s = -1 tension, +1 compression (direction of the screw's load), patch scaled. Returns mesh, contacts, weights, directions."""
    half_length = scale * patches()["screw"][0]
    a = half_length * np.cos(np.pi / 4)
    contacts = FREE_LENGTH + PITCH * np.arange(TEETH)
    face = s  # tension: the screw's loaded flank faces -x
    centres = contacts - face * PITCH / 4
    begin, end = centres[0] - 0.75 * PITCH, centres[-1] + PITCH / 2
    radius = profile(centres, +1, SCREW_R, lambda x: x > begin)
    breaks = graded(0, begin, 0, 0.2, 1.35, 1.5)
    breaks += [begin + v * (BELOW) / 2 for v in (1, 2)] + [centres[0] - PITCH / 2]
    for c in centres:
        breaks += [c + v for v in tooth_breaks({face}, a)[1:]]
    inner = SCREW_R - BELOW - 0.45
    deep = np.array(graded(BORE_R, inner, 0, 0.35, 1.4, 2.0))
    mesh = Mesh(sorted(set(np.round(breaks, 12))), [
        ((deep - BORE_R) / (inner - BORE_R), lambda x: BORE_R, lambda x: inner, lambda x: True),
        (TOOTH_ROWS, lambda x: inner, radius, lambda x: True)], n)
    surface = lambda r, z: np.abs(r - np.array([radius(v) for v in z])) < 1e-9
    weights = [patch_weights(mesh, (SCREW_R, x), half_length, surface) for x in contacts]
    c = np.cos(np.pi / 4)
    return mesh, contacts, weights, [(-c, -face * c)] * TEETH  # d into the screw, (r, x)


def nut_mesh(config, n, whole_teeth=False):
    """Tension; compression is the mirror image (CONFIG 1 tension = CONFIG 3 compression mirrored)."""
    a = patches()["nut"][0] * np.cos(np.pi / 4)
    contacts = POSITIONS[config] + PITCH * np.arange(TEETH)
    centres = contacts - PITCH / 4  # loaded flank faces +x
    begin, end = centres[0] - 0.75 * PITCH, centres[-1] + 0.75 * PITCH
    radius = profile(centres, -1, NUT_R, lambda x: begin < x < end)
    marks = [0.0, FLANGE_LENGTH, NUT_LENGTH - FLANGE_LENGTH, NUT_LENGTH]
    breaks = []
    def plain(x0, x1):
        inside = [x0] + [m for m in marks if x0 + 1e-9 < m < x1 - 1e-9] + [x1]
        for p, q in zip(inside[:-1], inside[1:]):
            fine = lambda v: 0.2 if abs(v - begin) < 1e-9 or abs(v - end) < 1e-9 else (
                0.15 if abs(v - FLANGE_LENGTH) < 1e-9 else 0.5 if abs(v - NUT_LENGTH + FLANGE_LENGTH) < 1e-9 else 0)
            breaks.extend(graded(p, q, fine(p), fine(q), 1.4, 2.0))
    plain(0.0, begin)
    plain(end, NUT_LENGTH)
    breaks += [begin + v * BELOW / 2 for v in (1, 2)] + [centres[0] - PITCH / 2]
    for c in centres:
        breaks += [c + v for v in tooth_breaks({+1}, a)[1:]]
    breaks += [end - v * BELOW / 2 for v in (1, 2)]
    breaks += [m for m in marks if begin < m < end]
    outer = NUT_R + BELOW + 0.45
    deep = np.array(graded(outer, NUT_OUTER_R, 0.35, 0.15, 1.4, 1.2))
    flange = np.array(graded(NUT_OUTER_R, 26.5, 0.1, 0, 1.25, 0.25) + graded(26.5, FLANGE_R, 0.25, 0, 1.35, 1.2)[1:])
    rows = 1 - np.array(TOOTH_ROWS[::-1])
    mesh = Mesh(sorted(set(np.round(breaks, 12))), [
        (rows, radius, lambda x: outer, lambda x: True),
        ((deep - outer) / (NUT_OUTER_R - outer), lambda x: outer, lambda x: NUT_OUTER_R, lambda x: True),
        ((flange - NUT_OUTER_R) / (FLANGE_R - NUT_OUTER_R), lambda x: NUT_OUTER_R, lambda x: FLANGE_R,
         lambda x: x < FLANGE_LENGTH or x > NUT_LENGTH - FLANGE_LENGTH)], n)
    surface = lambda r, z: np.abs(r - np.array([radius(v) for v in z])) < 1e-9
    weights = [patch_weights(mesh, (NUT_R, x), patches()["nut"][0], surface) for x in contacts]
    c = np.cos(np.pi / 4)
    return mesh, contacts, weights, [(c, -c)] * TEETH


AXIS_R = 0.0


def roller_mesh(n):
    """Tension. x = 0 at the left outer end. Contacts 0..19: screw side (flank faces +x), 20..39: nut side (faces -x)."""
    p = patches()
    c45 = np.cos(np.pi / 4)
    begin = END_LENGTH
    centres = begin + PITCH / 2 + PITCH * np.arange(TEETH)
    end = centres[-1] + PITCH / 2
    radius = profile(centres, +1, ROLLER_R, lambda x: True)
    breaks = graded(0, begin, 0, 0.2, 1.5, 1.5)
    for c in centres:
        breaks += [c + v for v in tooth_breaks({+1, -1}, (p["screw"][0] * c45, p["nut"][0] * c45))]
    breaks += graded(end, end + END_LENGTH, 0.2, 0, 1.5, 1.5)
    inner = ROLLER_R - BELOW - 0.45
    deep = np.array(graded(AXIS_R, END_R, 0, 0.25, 1.5, 0.8))
    between = np.array([0.0, 1.0])
    in_thread = lambda x: begin < x < end
    mesh = Mesh(sorted(set(np.round(breaks, 12))), [
        ((deep - AXIS_R) / (END_R - AXIS_R), lambda x: AXIS_R, lambda x: END_R, lambda x: True),
        (between, lambda x: END_R, lambda x: inner, in_thread),
        (TOOTH_ROWS, lambda x: inner, radius, in_thread)], n)
    surface = lambda r, z: np.abs(r - np.array([radius(v) for v in z])) < 1e-9
    screw, nut = centres + PITCH / 4, centres - PITCH / 4
    weights = [patch_weights(mesh, (ROLLER_R, x), p["screw"][0], surface) for x in screw]
    weights += [patch_weights(mesh, (ROLLER_R, x), p["nut"][0], surface) for x in nut]
    return mesh, np.concatenate([screw, nut]), weights, [(-c45, -c45)] * TEETH + [(-c45, c45)] * TEETH


# ---------------------------------------------------------------- CalculiX

def write_deck(path, mesh, weights, support, steps, rf=True, equations=()):
    """support: node numbers with u_x = 0 (CalculiX: dof 2 of CAX8); steps: lists of (contact, radial, axial force)."""
    first = len(mesh.coords) + 1
    with open(path, "w") as f:
        f.write("*NODE, NSET=ALL\n")
        f.writelines(f"{k},{r:.12e},{x:.12e},0.\n" for k, (r, x) in enumerate(mesh.coords, 1))
        f.write("*NODE, NSET=REF\n")
        f.writelines(f"{first + i},{100 + i},0.,0.\n" for i in range(len(weights)))
        f.write("*ELEMENT, TYPE=CAX8, ELSET=BODY\n")
        f.writelines(f"{k}," + ",".join(map(str, e)) + "\n" for k, e in enumerate(mesh.elements, 1))
        f.write(f"*MATERIAL, NAME=STEEL\n*ELASTIC\n{E},{NU}\n*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL\n")
        for i, w in enumerate(weights):
            items = [(k, v) for k, v in w.items()]
            for dof in (1, 2):
                terms = [(first + i, dof, -1.0)] + [(k, dof, v) for k, v in items]
                f.write(f"*EQUATION\n{len(terms)}\n")
                for t in range(0, len(terms), 4):
                    f.write(",".join(f"{k},{d},{v:.12e}" for k, d, v in terms[t:t + 4]) + "\n")
        for terms in equations:
            f.write(f"*EQUATION\n{len(terms)}\n")
            for t in range(0, len(terms), 4):
                f.write(",".join(f"{k},{d},{v:.12e}" for k, d, v in terms[t:t + 4]) + "\n")
        if support:
            f.write("*NSET, NSET=SUPPORT\n")
            f.writelines(f"{k}\n" for k in support)
            f.write("*BOUNDARY\nSUPPORT,2,2,0.\n")
        for loads in steps:
            f.write("*STEP\n*STATIC\n*CLOAD, OP=NEW\n")
            for i, radial, axial in loads:
                f.write(f"{first + i},1,{radial:.12e}\n{first + i},2,{axial:.12e}\n")
            f.write("*NODE PRINT, NSET=REF\nU\n")
            if rf:
                f.write("*NODE PRINT, NSET=SUPPORT, TOTALS=ONLY\nRF\n" if rf != "nodes" else "*NODE PRINT, NSET=SUPPORT\nRF\n")
            f.write("*END STEP\n")
    return first


def run_ccx(path):
    job = path[:-4]
    env = dict(os.environ, OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1")
    t0 = time.time()
    with open(job + ".log", "w") as log:
        subprocess.run(["ccx", os.path.basename(job)], cwd=os.path.dirname(job), stdout=log, stderr=log, env=env, check=True)
    return time.time() - t0


def read_dat(path):
    """List of steps: {'U': {node: (u1,u2,u3)}, 'RF': ..., 'TOTAL': (f1,f2,f3)}."""
    steps, table, last = [], None, None
    for line in open(path):
        if line.startswith(" displacements"):
            steps.append({"U": {}, "RF": {}})
            table = "U"
        elif line.startswith(" total force"):
            table = "TOTAL"
        elif line.startswith(" forces"):
            table = "RF"
        elif line.strip() and table:
            v = line.split()
            if table == "TOTAL":
                steps[-1]["TOTAL"] = tuple(map(float, v[-3:]))
            elif re.match(r"\s*\d+\s", line):
                steps[-1][table][int(v[0])] = tuple(map(float, v[1:4]))
    return steps


def section_mean(mesh, x):
    """Terms of the equation: mean axial displacement of the section at x (weighted with r) is zero."""
    terms = {}
    for a, m, b in mesh.edge(x, x, lambda r, z: np.abs(z - x) < 1e-9):
        length = abs(mesh.coords[b - 1][0] - mesh.coords[a - 1][0])
        for k, w in ((a, 1 / 6), (m, 4 / 6), (b, 1 / 6)):
            terms[k] = terms.get(k, 0) + w * length * max(mesh.coords[k - 1][0], 1e-3)
    order = sorted(terms, key=lambda k: -terms[k])
    return [(k, 2, terms[k] / terms[order[0]]) for k in order]


def shoulder_nodes(mesh, outer):
    on = (np.abs(mesh.coords[:, 1] - FLANGE_LENGTH) < 1e-9) & (mesh.coords[:, 0] > NUT_OUTER_R - 1e-9)
    on &= mesh.coords[:, 0] < outer + 1e-9
    nodes = np.where(on)[0] + 1
    return sorted(nodes, key=lambda k: mesh.coords[k - 1][0])


def shoulder_radius(folder, config, n=2, loads=None):
    """Outer radius of the part of the shoulder that presses, for the given contact forces (default: equal).

    Element edges with a reaction against the total are released from the rim inwards. The result lies on the coarse mesh."""
    loads = np.ones(TEETH) if loads is None else np.array(loads)
    mesh, x, weights, d = nut_mesh(config, n)
    coarse = nut_mesh(config, 1)[0]
    radii = sorted({round(coarse.coords[k - 1][0], 9) for e in coarse.edge(FLANGE_LENGTH, FLANGE_LENGTH,
                    lambda r, z: (np.abs(z - FLANGE_LENGTH) < 1e-9) & (r > NUT_OUTER_R - 1e-9)) for k in (e[0], e[2])})
    outer = radii[-1]
    path = os.path.join(folder, f"shoulder{config}.inp")
    history = []
    while True:
        nodes = shoulder_nodes(mesh, outer)
        write_deck(path, mesh, weights, nodes, [[(j, loads[j] * d[j][0], loads[j] * d[j][1]) for j in range(TEETH)]], rf="nodes")
        run_ccx(path)
        step = read_dat(path[:-4] + ".dat")[0]
        r = np.array([mesh.coords[k - 1][0] for k in nodes])
        f = np.array([step["RF"][k][1] for k in nodes])
        share = -f[f < 0].sum() / f.sum()
        history.append((outer, share))
        # the largest zone whose force outside of it sums to no pull
        inside = [v for v in radii if v <= outer + 1e-9]
        pulls = [v for v in inside[:-1] if f[r > v + 1e-9].sum() < 0]
        last = f[r > inside[-2] + 1e-9].sum()
        if last >= 0 and not pulls:
            return outer, history
        # at most the part that pulls as a whole, at least one element
        new = min([v for v in inside[:-1] if f[r > v + 1e-9].sum() < 0 and f[(r > v + 1e-9)][0] < 0], default=inside[-2])
        outer = new if new < outer else inside[-2]


def solve(folder, name, build, support_of, contacts_loaded=None, equations=()):
    """Influence matrix (normal) and means (radial, axial) per unit TOTAL ring force; the run's report."""
    mesh, x, weights, d = build
    loaded = range(len(x)) if contacts_loaded is None else contacts_loaded
    steps = [[(j, d[j][0], d[j][1])] for j in loaded]
    os.makedirs(folder, exist_ok=True)
    path = os.path.join(folder, name + ".inp")
    support = support_of(mesh)
    first = write_deck(path, mesh, weights, support, steps, bool(support), equations)
    seconds = run_ccx(path)
    result = read_dat(path[:-4] + ".dat")
    assert len(result) == len(steps), (len(result), len(steps))
    radial = np.array([[step["U"][first + i][0] for step in result] for i in range(len(x))])
    axial = np.array([[step["U"][first + i][1] for step in result] for i in range(len(x))])
    dd = np.array(d)
    normal = dd[:, :1] * radial + dd[:, 1:] * axial
    reaction = np.array([step.get("TOTAL", (0, 0, 0))[1] for step in result])
    return normal, radial, axial, reaction, seconds, len(mesh.coords)


# ---------------------------------------------------------------- runs

def run_case(scratch, body, case, n, loads, scale=1.0):
    """One body and case on mesh n; result in scratch/body_case_n.npz. scale: of the screw's patch, in the name if not 1."""
    equations = ()
    if body == "screw":
        build = screw_mesh({"tension": -1, "compression": +1}[case], n, scale)
        support = lambda m: list(np.where(np.abs(m.coords[:, 1]) < 1e-9)[0] + 1)
    elif body == "nut":
        build = nut_mesh(int(case[-1]), n)
        outer_file = os.path.join(scratch, f"shoulder_{case}.txt")
        if not os.path.exists(outer_file):
            outer, history = shoulder_radius(scratch, int(case[-1]))
            with open(outer_file, "w") as f:
                f.write(f"{outer}\n{history}\n")
        outer = float(open(outer_file).readline())
        support = lambda m: shoulder_nodes(m, outer)
    else:
        build = roller_mesh(n)
        support = lambda m: []
        equations = (section_mean(build[0], 0.0),)
    name = f"{body}_{case}_{n}" + (f"_{scale}" if scale != 1.0 else "")
    normal, radial, axial, reaction, seconds, nodes = solve(scratch, name, build, support, loads, equations)
    np.savez(os.path.join(scratch, name + ".npz"), normal=normal, radial=radial, axial=axial, reaction=reaction,
             seconds=seconds, nodes=nodes, loads=np.arange(len(build[1])) if loads is None else np.array(loads), x=build[1])
    print(f"{name}: {nodes} nodes, {normal.shape[1]} loads, {seconds:.1f} s, self {normal[:, 0].max():.6e}", flush=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", required=True)
    parser.add_argument("--mesh", type=int, required=True, help="subdivision of the coarse mesh: 1, 2, 3")
    parser.add_argument("--loads", help="comma-separated contacts; all by default")
    parser.add_argument("--patch", type=float, default=1.0, help="scale of the screw's patch")
    parser.add_argument("cases", nargs="+", help="screw:tension screw:compression nut:config1..3 roller:tension")
    args = parser.parse_args()
    os.makedirs(args.scratch, exist_ok=True)
    for item in args.cases:
        run_case(args.scratch, *item.split(":"), args.mesh, [int(v) for v in args.loads.split(",")] if args.loads else None, args.patch)
