"""Concentrated contact against ring load: 3D block of teeth by CalculiX (C3D20). A check of harmonic_sum.py in one solution.

    delta_k = [u_k(patch) - u_k(ring)] / P  -  (k = 0)  <u>/P of the half-space,
    <u>/P = (delta/2 - rho_s a_s^2/20 - rho_t a_t^2/20)/P, pressure-weighted displacement of ONE body of the Hertz contact.

u_k: displacement along the flank's inward normal at tooth k of the block, weighted with the contact pressure. Both loads act
on the same mesh, so what is common to both (axial stretch, hoop expansion) drops out. Screw and nut: half a sector of pi/11,
symmetry planes through the contact and between two contacts. Roller: half of it, plane of symmetry through both contacts;
there the harmonic n = 1 is taken out with the ring, see roller().

Units: mm, N. Usage: cyclic_3d.py --scratch DIR BODY MESH, BODY in screw, nut, roller; MESH 1, 2, 3; or cyclic_3d.py --scratch DIR collect.
"""
import argparse
import json
import os

import axisymmetric as ax
import numpy as np

C45 = np.cos(np.pi / 4)
SIDE = 2  # teeth on either side of the loaded one


def section(body, n, side=SIDE, ends=1.0):
    """Section mesh of a block of 2 side + 1 teeth; the loaded tooth's flanks fine. Contact of tooth k at z = k pitch."""
    p = ax.patches()
    sign = -1 if body == "nut" else +1
    pitch_r = {"screw": ax.SCREW_R, "nut": ax.NUT_R, "roller": ax.ROLLER_R}[body]
    face = {"screw": {-1}, "nut": {+1}, "roller": {-1, +1}}[body]
    crest, root, mid = ax.PITCH / 4 - ax.ABOVE, ax.PITCH / 4 + ax.BELOW, ax.PITCH / 4
    first = {"screw": +mid, "nut": -mid, "roller": 0.0}[body]  # tooth's centre from its contact
    centres = first + ax.PITCH * np.arange(-side, side + 1)
    spans = {+1: p["nut" if body == "nut" else "screw"][0] * C45, -1: p["screw" if body == "screw" else "nut"][0] * C45}
    steps = {1: (2, 1), 2: (3, 1), 3: (4, 2)}[n]  # elements on half a patch, elements beside it
    def half(fine, flank):
        is_face, span = flank in face, spans[flank]
        if fine and is_face:
            inner = list(np.linspace(mid - span, mid + span, 2 * steps[0] + 1))
            return ([crest] + list(np.linspace(crest, mid - span, steps[1] + 1)[1:-1]) + inner +
                    list(np.linspace(mid + span, root, steps[1] + 1)[1:]))
        if is_face:
            return [crest] + list(np.linspace(mid - span, mid + span, 3)) + [root]
        return list(np.linspace(crest, root, 3))
    breaks = []
    for k, c in enumerate(centres):
        fine = k == side
        right, left = half(fine, +1), half(fine, -1)
        breaks += [c] if fine else []
        breaks += [c + v for v in right] + [c - v for v in left] + [c - ax.PITCH / 2, c + ax.PITCH / 2]
    lo, hi = centres[0] - ax.PITCH / 2, centres[-1] + ax.PITCH / 2
    breaks += [lo - ends, hi + ends]
    breaks = sorted(set(np.round(breaks, 9)))
    radius = ax.profile(centres, sign, pitch_r, lambda x: lo - 1e-9 <= x <= hi + 1e-9)
    groove = pitch_r - sign * ax.BELOW
    radius_in = lambda x: radius(x) if lo - 1e-9 <= x <= hi + 1e-9 else groove
    depth = groove - sign * 0.45
    far = {"screw": ax.BORE_R, "nut": ax.NUT_OUTER_R, "roller": 0.3}[body]  # roller: a hole instead of the axis, 5e-5 of the bending section
    rows = {1: [0, 0.4, 0.7, 0.88, 1.0], 2: [0, 0.33, 0.58, 0.77, 0.90, 1.0], 3: [0, 0.25, 0.46, 0.63, 0.77, 0.88, 0.95, 1.0]}[n]
    size = {1: 0.5, 2: 0.4, 3: 0.35}[n]
    if sign > 0:
        deep = np.array(ax.graded(far, depth, 0, size, 1.6, 3.0 if body == "screw" else 0.9))
        groups = [((deep - far) / (depth - far), lambda x: far, lambda x: depth, lambda x: True),
                  (rows, lambda x: depth, radius_in, lambda x: True)]
    else:
        deep = np.array(ax.graded(depth, far, size, 0, 1.6, 3.0))
        groups = [(1 - np.array(rows[::-1]), radius_in, lambda x: depth, lambda x: True),
                  ((deep - depth) / (far - depth), lambda x: depth, lambda x: far, lambda x: True)]
    mesh = ax.Mesh(breaks, groups, 1)
    return mesh, centres, lambda r, z: np.abs(r - np.array([radius_in(v) for v in z])) < 1e-9


class Block:
    """The section swept around: C3D20 in cylindrical layers at `angles`. Axis z."""

    def __init__(self, mesh, angles):
        phi = np.sort(np.concatenate([angles, (angles[1:] + angles[:-1]) / 2]))
        self.index, self.rzp = {}, []
        on_axis = mesh.coords[:, 0] < 1e-9
        def node(k, j):
            key = (k, 0 if on_axis[k - 1] else j)
            if key not in self.index:
                self.index[key] = len(self.rzp) + 1
                self.rzp.append((mesh.coords[k - 1][0], mesh.coords[k - 1][1], phi[j]))
            return self.index[key]
        self.elements = []
        for j in range(0, len(phi) - 1, 2):
            for e in mesh.elements:
                c, m = [e[0], e[3], e[2], e[1]], [e[7], e[6], e[5], e[4]]  # clockwise in (r, z): outward along phi
                self.elements.append([node(k, j) for k in c] + [node(k, j + 2) for k in c] + [node(k, j) for k in m] +
                                     [node(k, j + 2) for k in m] + [node(k, j + 1) for k in c])
        self.phi, self.mesh, self.node = phi, mesh, node
        self.rzp = np.array(self.rzp)

    def weights(self, edges, density, order):
        """integral of N_k density(r, z, phi) r dphi ds over the swept `edges`; 8-node faces."""
        g, w = np.polynomial.legendre.leggauss(order)
        out = {}
        X, Y = np.meshgrid(g, g, indexing="ij")
        shapes = {}
        for i, xi in enumerate((-1, 0, 1)):
            for j, eta in enumerate((-1, 0, 1)):
                if xi and eta:
                    shapes[i, j] = (1 + X * xi) * (1 + Y * eta) * (X * xi + Y * eta - 1) / 4
                elif eta:
                    shapes[i, j] = (1 - X * X) * (1 + Y * eta) / 2
                elif xi:
                    shapes[i, j] = (1 - Y * Y) * (1 + X * xi) / 2
        for a, m, b in edges:
            pa, pb = self.mesh.coords[a - 1], self.mesh.coords[b - 1]
            length = np.linalg.norm(pb - pa)
            r, z = (pa[i] + (pb[i] - pa[i]) * (X + 1) / 2 for i in (0, 1))
            for j in range(0, len(self.phi) - 1, 2):
                p0, p1 = self.phi[j], self.phi[j + 2]
                phi = p0 + (p1 - p0) * (Y + 1) / 2
                f = density(r, z, phi) * r * (p1 - p0) / 2 * length / 2 * np.outer(w, w)
                if not f.any():
                    continue
                for (i, k), shape in shapes.items():
                    key = self.node((a, m, b)[i], j + k)
                    out[key] = out.get(key, 0) + (f * shape).sum()
        return out


def density_patch(r0, z0, phi0, a_s, a_t):
    """Hertz pressure of a unit load; s along the flank from (r0, z0), t around from phi0."""
    def density(r, z, phi):
        s2 = ((r - r0) ** 2 + (z - z0) ** 2) / a_s**2
        t2 = (r * (phi - phi0)) ** 2 / a_t**2
        return 3 / (2 * np.pi * a_s * a_t) * np.sqrt(np.maximum(0, 1 - s2 - t2))
    return density


def density_ring(r0, z0, a_s, harmonic=None):
    """The same load summed around the circle, unit total force; harmonic: None (n = 0) or the function of phi it is times."""
    def density(r, z, phi):
        s2 = ((r - r0) ** 2 + (z - z0) ** 2) / a_s**2
        return 3 / (4 * a_s) * np.maximum(0, 1 - s2) / (2 * np.pi * r) * (1 if harmonic is None else harmonic(phi))
    return density


def write_deck(path, block, fixed, plane, steps, printed):
    """fixed: [(nodes, dof)]; plane: (nodes, angle, dofs) fixed in the system radial 1, circumferential 2, axial 3, in which their forces
    and displacements are too; steps: {node: force}."""
    xyz = np.stack([block.rzp[:, 0] * np.cos(block.rzp[:, 2]), block.rzp[:, 0] * np.sin(block.rzp[:, 2]), block.rzp[:, 1]], 1)
    with open(path, "w") as f:
        f.write("*NODE, NSET=ALL\n")
        f.writelines(f"{k},{x:.12e},{y:.12e},{z:.12e}\n" for k, (x, y, z) in enumerate(xyz, 1))
        f.write("*ELEMENT, TYPE=C3D20, ELSET=BODY\n")
        for k, e in enumerate(block.elements, 1):
            f.write(f"{k}," + ",".join(map(str, e[:15])) + ",\n" + ",".join(map(str, e[15:])) + "\n")
        f.write(f"*MATERIAL, NAME=STEEL\n*ELASTIC\n{ax.E},{ax.NU}\n*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL\n")
        if plane is not None:
            nodes, angle, _ = plane
            f.write("*NSET, NSET=PLANE\n" + "".join(f"{k}\n" for k in nodes))
            c, s = np.cos(angle), np.sin(angle)
            f.write(f"*TRANSFORM, NSET=PLANE, TYPE=R\n{c:.12e},{s:.12e},0.,{-s:.12e},{c:.12e},0.\n")
        for i, (nodes, dof) in enumerate(fixed):
            f.write(f"*NSET, NSET=FIX{i}\n" + "".join(f"{k}\n" for k in nodes))
        f.write("*NSET, NSET=OUT\n" + "".join(f"{k}\n" for k in sorted(printed)))
        f.write("*BOUNDARY\n")
        if plane is not None:
            f.writelines(f"PLANE,{dof},{dof},0.\n" for dof in plane[2])
        for i, (nodes, dof) in enumerate(fixed):
            f.write(f"FIX{i},{dof},{dof},0.\n")
        for loads in steps:
            f.write("*STEP\n*STATIC\n*CLOAD, OP=NEW\n")
            for k, force in sorted(loads.items()):
                f.writelines(f"{k},{d + 1},{v:.12e}\n" for d, v in enumerate(force) if v != 0.0)
            f.write("*NODE PRINT, NSET=OUT\nU\n*NODE PRINT, NSET=FIX0, TOTALS=ONLY\nRF\n*END STEP\n")


def pressure_load(block, edges, density, d, order, total=None):
    """Consistent nodal forces of a pressure along the inward normal d = (radial, axial), which turns around with phi; scaled to a
    pressure of `total` in all where given."""
    plain = block.weights(edges, density, order)
    cos = block.weights(edges, lambda r, z, p: density(r, z, p) * np.cos(p), order)
    sin = block.weights(edges, lambda r, z, p: density(r, z, p) * np.sin(p), order)
    scale = total / sum(plain.values()) if total else 1.0
    return {k: scale * np.array([d[0] * cos.get(k, 0.0), d[0] * sin.get(k, 0.0), d[1] * w]) for k, w in plain.items()}


def turned(loads, nodes, angle):
    """The loads with those at `nodes` in the system (radial, circumferential, axial) of a plane: what CalculiX reads and prints
    at nodes with *TRANSFORM."""
    c, s = np.cos(angle), np.sin(angle)
    return {k: (np.array([c * f[0] + s * f[1], -s * f[0] + c * f[1], f[2]]) if k in nodes else f) for k, f in loads.items()}


def work(load, displacement):
    return sum(float(np.dot(f, displacement[k])) for k, f in load.items())


def combined(*terms):
    """Sum of factor * load over (factor, load)."""
    out = {}
    for factor, load in terms:
        for k, f in load.items():
            out[k] = out.get(k, np.zeros(3)) + factor * f
    return out


def layers(a_t, radius, span, n):
    """Angles: `steps` layers over the patch's half width, then growing."""
    steps = {1: 2, 2: 3, 3: 4}[n]
    inner = list(np.linspace(0, a_t / radius, steps + 1))
    rest = ax.graded(a_t / radius, span, a_t / radius / steps * 1.2, 0, {1: 1.7, 2: 1.6, 3: 1.5}[n], span / 3.2)
    return np.array(inner + rest[1:])


def half_space(name):
    """Pressure-weighted mean displacement of one body of the Hertz contact, per unit load."""
    a_s, a_t, delta, rho_s, rho_t, load = ax.patches()[name]
    return (delta / 2 - rho_s * a_s**2 / 20 - rho_t * a_t**2 / 20) / load


def sector(scratch, body, n):
    """Screw or nut: delta by tooth offset, and the run's facts."""
    p = ax.patches()[body]
    a_s, a_t = p[:2]
    radius = {"screw": ax.SCREW_R, "nut": ax.NUT_R}[body]
    d = {"screw": (-C45, +C45), "nut": (+C45, -C45)}[body]
    span = np.pi / ax.ROLLERS
    mesh, centres, surface = section(body, n)
    block = Block(mesh, layers(a_t, radius, span, n))
    z = block.rzp[:, 1]
    symmetry = np.where(block.rzp[:, 2] < 1e-12)[0] + 1
    plane = np.where(np.abs(block.rzp[:, 2] - span) < 1e-9)[0] + 1
    end = np.where(np.abs(z - z.min()) < 1e-9)[0] + 1
    patch, ring = [], None
    for k in range(-SIDE, SIDE + 1):
        c = k * ax.PITCH
        edges = mesh.edge(c - a_s * C45 - 1e-9, c + a_s * C45 + 1e-9, surface)
        patch.append(pressure_load(block, edges, density_patch(radius, c, 0.0, a_s, a_t), d, 24, 0.5))
        if k == 0:
            ring = turned(pressure_load(block, edges, density_ring(radius, c, a_s), d, 8, 0.5), set(plane), span)
    path = os.path.join(scratch, f"{body}3d_{n}.inp")
    write_deck(path, block, [(end, 3), (symmetry, 2)], (plane, span, (2,)), [patch[SIDE], ring], set().union(*patch, ring))
    seconds = ax.run_ccx(path)
    result = ax.read_dat(path[:-4] + ".dat")
    u_patch, u_ring = (np.array([2 * work(load, step["U"]) for load in patch]) for step in result)
    delta = u_patch - u_ring
    delta[SIDE] -= half_space(body)
    return {"body": body, "mesh": n, "nodes": len(block.rzp), "elements": len(block.elements), "seconds": seconds,
            "half_space": half_space(body), "u_patch": u_patch.tolist(), "u_ring": u_ring.tolist(),
            "u_ring_self_ring_weights": 2 * work(ring, result[1]["U"]), "reaction": [r["TOTAL"][2] for r in result],
            "offsets": list(range(-SIDE, SIDE + 1)), "delta": delta.tolist()}


def roller(scratch, n, side=2, ends=3.0):
    """Roller: local part of harmonics n >= 2 by tooth offset, and the bending section of the threaded part.

    Half a block of 2 side + 1 teeth held at one end. Nut side at phi = 0 (flanks facing -x), screw side at phi = pi (+x). Loads and
    weights are patch less ring (n = 0) less ring times 2 cos (n = 1): in balance, so that neither beam nor support take part."""
    p = ax.patches()
    mesh, centres, surface = section("roller", n, side, ends)
    near_nut = layers(p["nut"][1], ax.ROLLER_R, np.pi / 2, n)
    near_screw = np.pi - layers(p["screw"][1], ax.ROLLER_R, np.pi / 2, n)[::-1]
    block = Block(mesh, np.concatenate([near_nut, near_screw[1:]]))
    r, z, phi = block.rzp.T
    symmetry = np.where((phi < 1e-12) | (np.abs(phi - np.pi) < 1e-9))[0] + 1
    clamp = np.where(np.abs(z - z.min()) < 1e-9)[0] + 1
    teeth = np.arange(-side, side + 1)
    at = {"nut": teeth * ax.PITCH - ax.PITCH / 4, "screw": teeth * ax.PITCH + ax.PITCH / 4}
    d = {"nut": (-C45, +C45), "screw": (-C45, -C45)}
    where = {"nut": 0.0, "screw": np.pi}
    load = {}
    for name in ("nut", "screw"):
        a_s, a_t = p[name][:2]
        for k, c in zip(teeth, at[name]):
            edges = mesh.edge(c - a_s * C45 - 1e-9, c + a_s * C45 + 1e-9, surface)
            around = lambda ph, phi0=where[name]: 1 + 2 * np.cos(ph - phi0)
            patch = pressure_load(block, edges, density_patch(ax.ROLLER_R, c, where[name], a_s, a_t), d[name], 24, 0.5)
            rings = pressure_load(block, edges, density_ring(ax.ROLLER_R, c, a_s, around), d[name], 8)
            load[name, k] = combined((1.0, patch), (-1.0, rings))
    # pure bending: axial traction proportional to x on the free end
    end = mesh.edge(z.max(), z.max(), lambda rr, zz: np.abs(zz - z.max()) < 1e-9)
    bend = block.weights(end, lambda rr, zz, ph: rr * np.cos(ph), 8)
    moment = -2 * sum(w * r[k - 1] * np.cos(phi[k - 1]) for k, w in bend.items())  # theta = dv/dz: -x gives +theta
    steps = [load["nut", 0], load["screw", 0], {k: (0.0, 0.0, w) for k, w in bend.items()}]
    line = [k for k in np.where((phi < 1e-12) | (np.abs(phi - np.pi) < 1e-9))[0] + 1 if surface(r[k - 1:k], z[k - 1:k])[0]]
    path = os.path.join(scratch, f"roller3d_{n}.inp")
    write_deck(path, block, [(clamp, 3), (symmetry, 2), (clamp, 1)], None, steps, set(line).union(*load.values()))
    seconds = ax.run_ccx(path)
    result = ax.read_dat(path[:-4] + ".dat")
    crests = [[k for k in line if abs(z[k - 1] - c) < 1e-9 and abs(phi[k - 1] - a) < 1e-9] for a in (0.0, np.pi) for c in centres]
    axial = np.array([result[2]["U"][k[0]][2] / np.cos(phi[k[0] - 1]) / r[k[0] - 1] for k in crests]).reshape(2, -1).mean(0)
    slope = -np.polyfit(centres[1:-1], axial[1:-1], 1)[0]
    out = {"mesh": n, "nodes": len(block.rzp), "elements": len(block.elements), "seconds": seconds, "teeth": teeth.tolist(),
           "bending_r": (4 * moment / slope / (np.pi * ax.E)) ** 0.25, "reaction": [q["TOTAL"][2] for q in result]}
    for step, loaded in enumerate(("nut", "screw")):
        for answer in ("nut", "screw"):
            delta = np.array([2 * work(load[answer, k], result[step]["U"]) for k in teeth])
            if loaded == answer:
                delta[side] -= half_space(loaded)
            out[f"load {loaded} response {answer}"] = delta.tolist()
    return out


def collect(scratch, out):
    """data/patch_3d.json: by tooth offset, extrapolated over the meshes that were run, with the distance between them."""
    report = {"unit": "mm/N per contact force of one roller"}
    fold = lambda v: np.array([v[SIDE]] + [(v[SIDE - k] + v[SIDE + k]) / 2 for k in range(1, SIDE + 1)])
    for body in ("screw", "nut", "roller"):
        meshes = [n for n in (1, 2, 3) if os.path.exists(os.path.join(scratch, f"{body}3d_{n}.json"))]
        runs = [json.load(open(os.path.join(scratch, f"{body}3d_{n}.json"))) for n in meshes]
        keys = ["delta"] if body != "roller" else [f"load {a} response {b}" for a in ("screw", "nut") for b in ("screw", "nut")]
        report[body] = {"meshes": meshes, "nodes": [r["nodes"] for r in runs], "seconds": [r["seconds"] for r in runs]}
        if body == "roller":
            report[body]["bending_r_mm"] = [r["bending_r"] for r in runs]
        for key in keys:
            crossed = len(key.split()) > 1 and key.split()[1] != key.split()[3]
            values = [np.array(r[key]) if crossed else fold(r[key]) for r in runs]
            best, error = values[-1], np.abs(values[-1]) * 0.05
            if len(values) > 1:  # elements on half the patch: 2, 3, 4; order 2
                h = [1 / (n + 1) for n in meshes]
                best = values[-1] + (values[-1] - values[-2]) * h[-1] ** 2 / (h[-2] ** 2 - h[-1] ** 2)
                error = np.abs(best - values[-1])
            report[body][key] = {"values": best.tolist(), "error_bar": error.tolist(), "by_mesh": [v.tolist() for v in values]}
    json.dump(report, open(out, "w"), indent=1)
    print(json.dumps(report, indent=1))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", required=True)
    parser.add_argument("body", choices=["screw", "nut", "roller", "collect"])
    parser.add_argument("mesh", type=int, nargs="?", default=1)
    args = parser.parse_args()
    os.makedirs(args.scratch, exist_ok=True)
    if args.body == "collect":
        collect(args.scratch, os.path.join(os.path.dirname(os.path.abspath(__file__)), "data", "patch_3d.json"))
        raise SystemExit
    out = roller(args.scratch, args.mesh) if args.body == "roller" else sector(args.scratch, args.body, args.mesh)
    json.dump(out, open(os.path.join(args.scratch, f"{args.body}3d_{args.mesh}.json"), "w"), indent=1)
    print(json.dumps(out, indent=1))
