"""A whole mechanism of few rollers and threads by CalculiX (C3D20): flexibilities of screw, nut and roller under single contacts.

Five rollers, four threads, pitch and sections of axisymmetric.py, ring-shaped teeth, tension. Each body is half a body, 0 <= phi <= pi,
since a contact's force lies in the plane through its roller. Unit forces are Hertz ellipses on one flank at phi = 0, the response is the
displacement along the inward normal of every flank at the azimuth of every roller; of the loaded one the pressure's half-space is
taken out, which the contact law has. curves.py's kind of contact problem on them: full_curves.py.

- screw: plain to its first groove, clamped at x = 0 (all displacements), 10 mm before the first contact; its far end is free.
- nut: tube of outer radius 23 and length NUT_LENGTH, first contact at x = 10. Face x = 0: no axial displacement; `clamped` no
  displacement at all, `free` no sideways displacement in the mean only, so that the face may ovalise.
- roller: that of roller_bending.py with four teeth; whole sections of its ends do not move sideways (both_end_nodes).

Units: mm per N. Usage: full_mechanism.py --scratch DIR BODY LEVEL; BODY in screw, nut_free, nut_clamped, roller; LEVEL 0, 1, 2: mesh. The result is DIR/full_BODY_LEVEL.npz.
"""
import argparse
import os

import axisymmetric as ax
import cyclic_3d as c3
import numpy as np

ROLLERS, TEETH, FORCE, POSITION, NUT_LENGTH = 5, 4, 4000.0, 10.0, 25.0
AZIMUTHS = 2 * np.pi / ROLLERS * np.arange(ROLLERS // 2 + 1)
C45 = np.cos(np.pi / 4)
# crests to depth: rows of elements; growth and largest element below them
ROWS = {0: [0, 0.7, 1.0], 1: [0, 0.55, 0.85, 1.0], 2: [0, 0.37, 0.62, 0.79, 0.91, 1.0]}
GROWTH = {0: 2.5, 1: 2.0, 2: 1.5}
ACROSS = {0: 1, 1: 2, 2: 4}  # elements across a patch; half as many next to its plane, at least one
LARGEST = {0: 0.6, 1: 0.45, 2: 0.32}  # rad, of an element around
HOLE = 0.3  # mm, of the roller in place of its axis, 5e-5 of its bending section


def flank(level, span):
    """Break points from a tooth's centre to the groove's middle; span: axial half length of a patch, 0 where none is."""
    crest, root, mid = ax.PITCH / 4 - ax.ABOVE, ax.PITCH / 4 + ax.BELOW, ax.PITCH / 4
    inner = list(np.linspace(mid - span, mid + span, ACROSS[level] + 1)) if span else [mid]
    return [0.0, crest] + inner + [root, ax.PITCH / 2]


def teeth_breaks(centres, level, right, left):
    return [c + v for c in centres for v in flank(level, right)] + [c - v for c in centres for v in flank(level, left)]


def unique(points):
    return sorted(set(np.round(points, 9)))


def layers(level, around):
    """Angles of the layers over half a turn, fine at phi in `around` {phi: half width of the patch over the radius}."""
    marks = sorted({round(v, 12): v for v in [*AZIMUTHS, np.pi]}.values()) if 1 == len(around) else [0.0, np.pi / 2, np.pi]
    elements_off_plane = max(1, ACROSS[level] // 2)
    out = []
    for a, b in zip(marks[:-1], marks[1:]):
        step = lambda phi: around[phi] / elements_off_plane if phi in around else 0.0
        lo, hi = a, b
        head = list(np.linspace(0, around[a], elements_off_plane + 1)) if a in around else [0.0]
        tail = list(np.linspace(around[b], 0, elements_off_plane + 1)) if b in around else [0.0]
        lo, hi = a + head[-1], b - tail[0]
        middle = ax.graded(lo, hi, 1.3 * step(a), 1.3 * step(b), GROWTH[level], LARGEST[level])
        out += [a + v for v in head[:-1]] + middle + [b - v for v in tail[1:]]
    return np.array(unique(out))


def screw(level):
    a_s = ax.patches()["screw"][0] * C45
    contacts = ax.FREE_LENGTH + ax.PITCH * np.arange(TEETH)
    centres = contacts + ax.PITCH / 4  # tension: the loaded flank faces -x
    begin, end = centres[0] - 0.75 * ax.PITCH, centres[-1] + ax.PITCH / 2
    breaks = ax.graded(0, begin, 0, 0.4, GROWTH[level], 2.0 / max(level, 1)) + [begin + ax.BELOW]
    breaks += list(teeth_breaks(centres, level, 0.0, a_s))
    inner = ax.SCREW_R - ax.BELOW - 0.45
    deep = np.array(ax.graded(ax.BORE_R, inner, 0, 0.5, GROWTH[level], 2.5))
    radius = ax.profile(centres, +1, ax.SCREW_R, lambda x: x > begin)
    mesh = ax.Mesh(unique(breaks), [((deep - ax.BORE_R) / (inner - ax.BORE_R), lambda x: ax.BORE_R, lambda x: inner, lambda x: True),
                                    (ROWS[level], lambda x: inner, radius, lambda x: True)], 1)
    return mesh, radius, contacts, (-C45, +C45)


def nut(level):
    a_s = ax.patches()["nut"][0] * C45
    contacts = POSITION + ax.PITCH * np.arange(TEETH)
    centres = contacts - ax.PITCH / 4  # the loaded flank faces +x
    begin, end = centres[0] - 0.75 * ax.PITCH, centres[-1] + 0.75 * ax.PITCH
    radius = ax.profile(centres, -1, ax.NUT_R, lambda x: begin < x < end)
    breaks = ax.graded(0, begin, 0, 0.4, GROWTH[level], 2.0 / max(level, 1)) + [begin + ax.BELOW] + teeth_breaks(centres, level, a_s, 0.0)
    breaks += [end - ax.BELOW] + ax.graded(end, NUT_LENGTH, 0.4, 0, GROWTH[level], 2.5 / max(level, 1))
    outer = ax.NUT_R + ax.BELOW + 0.45
    deep = np.array(ax.graded(outer, ax.NUT_OUTER_R, 0.5, 0, GROWTH[level], 2.0))
    mesh = ax.Mesh(unique(breaks), [(1 - np.array(ROWS[level][::-1]), radius, lambda x: outer, lambda x: True),
                                    ((deep - outer) / (ax.NUT_OUTER_R - outer), lambda x: outer, lambda x: ax.NUT_OUTER_R, lambda x: True)], 1)
    return mesh, radius, contacts, (+C45, -C45)


def roller(level):
    p = ax.patches()
    begin = ax.END_LENGTH
    centres = begin + ax.PITCH / 2 + ax.PITCH * np.arange(TEETH)
    end = centres[-1] + ax.PITCH / 2
    breaks = ax.graded(0, begin, 0, 0.4, GROWTH[level], 1.5) + teeth_breaks(centres, level, p["screw"][0] * C45, p["nut"][0] * C45)
    breaks += ax.graded(end, end + begin, 0.4, 0, GROWTH[level], 1.5)
    radius = ax.profile(centres, +1, ax.ROLLER_R, lambda x: True)
    inner = ax.ROLLER_R - ax.BELOW - 0.45
    deep = np.array(ax.graded(HOLE, ax.END_R, 0, 0.3, GROWTH[level], 0.9))
    threaded = lambda x: begin < x < end
    mesh = ax.Mesh(unique(breaks), [
        ((deep - HOLE) / (ax.END_R - HOLE), lambda x: HOLE, lambda x: ax.END_R, lambda x: True),
        (np.array([0.0, 1.0]), lambda x: ax.END_R, lambda x: inner, threaded),
        (ROWS[level], lambda x: inner, radius, threaded)], 1)
    return mesh, radius, centres, end + begin


def surface_of(radius):
    return lambda r, z: np.abs(r - np.array([radius(v) for v in z])) < 1e-9


def write_deck(path, block, fixed, equations, steps, printed):
    """fixed: [(nodes, dof)]; equations: lists of (node, dof, factor) whose sum is zero; steps: {node: force}."""
    r, z, phi = block.rzp.T
    with open(path, "w") as f:
        f.write("*NODE, NSET=ALL\n")
        f.writelines(f"{k},{x:.12e},{y:.12e},{w:.12e}\n" for k, (x, y, w) in enumerate(zip(r * np.cos(phi), r * np.sin(phi), z), 1))
        f.write("*ELEMENT, TYPE=C3D20, ELSET=BODY\n")
        for k, e in enumerate(block.elements, 1):
            f.write(f"{k}," + ",".join(map(str, e[:15])) + ",\n" + ",".join(map(str, e[15:])) + "\n")
        f.write(f"*MATERIAL, NAME=STEEL\n*ELASTIC\n{ax.E},{ax.NU}\n*SOLID SECTION, ELSET=BODY, MATERIAL=STEEL\n")
        for terms in equations:
            f.write(f"*EQUATION\n{len(terms)}\n")
            for t in range(0, len(terms), 4):
                f.write(",".join(f"{k},{d},{v:.12e}" for k, d, v in terms[t:t + 4]) + "\n")
        for i, (nodes, _) in enumerate(fixed):
            f.write(f"*NSET, NSET=FIX{i}\n" + "".join(f"{k}\n" for k in nodes))
        f.write("*NSET, NSET=OUT\n" + "".join(f"{k}\n" for k in sorted(printed)))
        f.write("*BOUNDARY\n" + "".join(f"FIX{i},{dof},{dof},0.\n" for i, (_, dof) in enumerate(fixed)))
        for loads in steps:
            f.write("*STEP\n*STATIC\n*CLOAD, OP=NEW\n")
            for k, force in sorted(loads.items()):
                f.writelines(f"{k},{d + 1},{v:.12e}\n" for d, v in enumerate(force) if v != 0.0)
            f.write("*NODE PRINT, NSET=OUT\nU\n*END STEP\n")


def at_azimuth(block, mesh, radius, contact, a_s, pitch_r, d, phi):
    """Displacement along the inward normal on the line of the flank at phi, weighted as the pressure along it."""
    layer = int(np.argmin(np.abs(block.phi - phi)))
    assert abs(block.phi[layer] - phi) < 1e-9
    turned = np.array([d[0] * np.cos(phi), d[0] * np.sin(phi), d[1]])
    weights = ax.patch_weights(mesh, (pitch_r, contact), a_s, surface_of(radius))
    return {block.node(k, layer): w * turned for k, w in weights.items()}


def face_mean(block, nodes):
    """Terms of the mean displacement across (dof 1) of the nodes of a flat face, weighted by r; half a body."""
    terms = sorted(((k, 1, block.rzp[k - 1][0]) for k in nodes), key=lambda t: -t[2])
    return [(k, d, v / terms[0][2]) for k, d, v in terms]


def solved(scratch, name, block, fixed, equations, loads, answers):
    path = os.path.join(scratch, f"full_{name}.inp")
    write_deck(path, block, fixed, equations, loads, set().union(*answers))
    seconds = ax.run_ccx(path)
    steps = ax.read_dat(path[:-4] + ".dat")
    assert len(steps) == len(loads)
    for end in (".frd", ".sta", ".cvg", ".12d"):
        if os.path.exists(path[:-4] + end):
            os.remove(path[:-4] + end)
    return np.array([[c3.work(a, step["U"]) for step in steps] for a in answers]), seconds


def ring_body(scratch, body, level, loaded):
    """matrix[azimuth, answering tooth, loaded tooth]."""
    which, pitch_r = ("screw", ax.SCREW_R) if body == "screw" else ("nut", ax.NUT_R)
    a_s, a_t = ax.patches()[which][:2]
    mesh, radius, contacts, d = (screw if body == "screw" else nut)(level)
    block = c3.Block(mesh, layers(level, {0.0: a_t / pitch_r}))
    r, z, phi = block.rzp.T
    symmetry = np.where((phi < 1e-12) | (np.abs(phi - np.pi) < 1e-9))[0] + 1
    face = np.where(z < 1e-9)[0] + 1
    edges = [mesh.edge(c - a_s * C45 - 1e-9, c + a_s * C45 + 1e-9, surface_of(radius)) for c in contacts]
    # Half the force: the other half of the body takes the rest.
    loads = [c3.pressure_load(block, e, c3.density_patch(pitch_r, c, 0.0, a_s, a_t), d, 24, 0.5) for e, c in zip(edges, contacts)]
    fixed, equations = [(symmetry, 2), (face, 3)], []
    if body != "nut_free":
        fixed += [(face, 1), (np.setdiff1d(face, symmetry), 2)]
    else:
        equations.append(face_mean(block, face))
    answers = [{k: 2.0 * f for k, f in load.items()} for load in loads]
    for azimuth in AZIMUTHS[1:]:
        answers += [at_azimuth(block, mesh, radius, c, a_s, pitch_r, d, azimuth) for c in contacts]
    matrix, seconds = solved(scratch, f"{body}_{level}", block, fixed, equations, [loads[k] for k in loaded], answers)
    matrix = matrix.reshape(len(AZIMUTHS), TEETH, len(loaded))
    for i, k in enumerate(loaded):
        matrix[0, k, i] -= c3.half_space(which)
    return matrix, len(block.rzp), seconds


def roller_body(scratch, level, loaded):
    """matrix[contact, loaded contact]; contacts of the screw (phi = pi), then of the nut (phi = 0)."""
    p = ax.patches()
    mesh, radius, centres, length = roller(level)
    block = c3.Block(mesh, layers(level, {0.0: p["nut"][1] / ax.ROLLER_R, np.pi: p["screw"][1] / ax.ROLLER_R}))
    r, z, phi = block.rzp.T
    symmetry = np.where((phi < 1e-12) | (np.abs(phi - np.pi) < 1e-9))[0] + 1
    held = [k for x in (0.0, ax.END_LENGTH, length - ax.END_LENGTH, length)
            for k in np.where((np.abs(z - x) < 1e-9) & (r < ax.END_R + 1e-9))[0] + 1]
    along = np.where((z < 1e-9) & (r < HOLE + 1e-9))[0] + 1  # a gauge: balanced loads do not feel it
    loads, spaces = [], []
    for name, side, where in (("screw", +1, np.pi), ("nut", -1, 0.0)):
        a_s, a_t = p[name][:2]
        for c in centres + side * ax.PITCH / 4:
            edges = mesh.edge(c - a_s * C45 - 1e-9, c + a_s * C45 + 1e-9, surface_of(radius))
            loads.append(c3.pressure_load(block, edges, c3.density_patch(ax.ROLLER_R, c, where, a_s, a_t), (-C45, -side * C45), 24, 0.5))
            spaces.append(c3.half_space(name))
    fixed = [(symmetry, 2), (held, 1), (np.setdiff1d(held, symmetry), 2), (along, 3)]
    answers = [{k: 2.0 * f for k, f in load.items()} for load in loads]
    matrix, seconds = solved(scratch, f"roller_{level}", block, fixed, [], [loads[k] for k in loaded], answers)
    for i, k in enumerate(loaded):
        matrix[k, i] -= spaces[k]
    return matrix, len(block.rzp), seconds


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", required=True)
    parser.add_argument("--loads", help="comma-separated contacts; all by default")
    parser.add_argument("body", choices=["screw", "nut_free", "nut_clamped", "roller"])
    parser.add_argument("level", type=int)
    args = parser.parse_args()
    os.makedirs(args.scratch, exist_ok=True)
    ax.ROLLERS, ax.TEETH, ax.FORCE = ROLLERS, TEETH, FORCE
    contacts = 2 * TEETH if args.body == "roller" else TEETH
    loaded = [int(v) for v in args.loads.split(",")] if args.loads else list(range(contacts))
    run = (lambda: roller_body(args.scratch, args.level, loaded)) if args.body == "roller" else (
        lambda: ring_body(args.scratch, args.body, args.level, loaded))
    matrix, nodes, seconds = run()
    np.savez(os.path.join(args.scratch, f"full_{args.body}_{args.level}.npz"), matrix=matrix, loaded=loaded, nodes=nodes, seconds=seconds)
    print(args.body, args.level, nodes, "nodes", f"{seconds:.0f} s")
    print(matrix if args.body == "roller" else matrix[0])
