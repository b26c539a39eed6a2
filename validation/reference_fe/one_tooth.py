"""One tooth of the screw in direct contact with a rigid sphere, by CalculiX (C3D20): is anything left beyond exact Hertz?

The block of cyclic_3d.py (half a sector), the sphere of the roller's flank, frictionless: nodes of the flank inside the Hertz
ellipse take the displacement delta - gap along the flank's normal, all others are free; the ellipse is the exact one of the
load P expected, and an error of the zone enters in second order only. Expected:
    delta = (P/k)^(2/3) + B P,   k: exact Hertz, rigid sphere on one elastic body,
    B = C_ring + delta_0: ring compliance of the block and what cyclic_3d.py gives beyond it ("bracket"), both for P of one contact.
A tooth deflection on top of Hertz would show as P below the expected one.

Usage: one_tooth.py --scratch DIR MESH; needs DIR/screw3d_MESH.json of cyclic_3d.py.
"""
import argparse
import json
import os

import axisymmetric as ax
import cyclic_3d as c3
import numpy as np


def run(scratch, n):
    a_s, a_t, delta, rho_s, rho_t, load = ax.patches()["screw"]
    load *= 2  # a rigid sphere: twice the modulus E*, so twice the load makes the same ellipse and approach
    known = json.load(open(os.path.join(scratch, f"screw3d_{n}.json")))
    bulk = known["u_patch"][c3.SIDE] - known["half_space"]
    ring, bracket = known["u_ring"][c3.SIDE], known["delta"][c3.SIDE]
    approach = delta + bulk * load
    d = np.array([-c3.C45, 0.0, +c3.C45])
    span = np.pi / ax.ROLLERS
    mesh, centres, surface = c3.section("screw", n)
    block = c3.Block(mesh, c3.layers(a_t, ax.SCREW_R, span, n))
    r, z, phi = block.rzp.T
    xyz = np.stack([r * np.cos(phi), r * np.sin(phi), z], 1)
    flank = set(np.where(surface(r, z) & (np.abs(z) < a_s) & (phi < 2 * a_t / ax.SCREW_R))[0])
    rel = xyz - np.array([ax.SCREW_R, 0.0, 0.0])
    depth = rel @ d
    along = rel @ np.array([c3.C45, 0.0, c3.C45])
    R = 1 / rho_s
    gap = R - np.sqrt(np.maximum(0, R * R - along**2 - rel[:, 1] ** 2)) + depth
    inside = [k for k in flank if (along[k] / a_s) ** 2 + (r[k] * phi[k] / a_t) ** 2 < 1 + 1e-6 and abs(depth[k]) < 0.01]
    symmetry = set(np.where(phi < 1e-12)[0])
    plane = np.where(np.abs(phi - span) < 1e-9)[0] + 1
    end = np.where(np.abs(z - z.min()) < 1e-9)[0] + 1
    path = os.path.join(scratch, f"tooth_{n}.inp")
    c3.write_deck(path, block, [(end, 3), (np.array(sorted(symmetry)) + 1, 2)], (plane, span, (2,)), [], {1})
    text = open(path).read()
    with open(path, "w") as f:
        head, boundary = text.split("*BOUNDARY\n")
        f.write(head + "*NSET, NSET=TOUCH\n" + "".join(f"{k + 1}\n" for k in inside))
        f.write(f"*TRANSFORM, NSET=TOUCH, TYPE=R\n{d[0]:.12e},0.,{d[2]:.12e},0.,1.,0.\n*BOUNDARY\n" + boundary)
        f.write("*STEP\n*STATIC\n*BOUNDARY\n" + "".join(f"{k + 1},1,1,{approach - gap[k]:.12e}\n" for k in inside))
        f.write("*NODE PRINT, NSET=TOUCH\nRF\n*NODE PRINT, NSET=FIX0, TOTALS=ONLY\nRF\n*NODE PRINT, NSET=TOUCH\nU\n*END STEP\n")
    seconds = ax.run_ccx(path)
    forces = {}
    table = None
    for line in open(path[:-4] + ".dat"):
        if line.startswith(" forces"):
            table = "RF"
        elif line.startswith((" displacements", " total")):
            table = None if not line.startswith(" total") else "TOTAL"
        elif table == "RF" and line.strip():
            v = line.split()
            forces[int(v[0])] = np.array(list(map(float, v[1:4])))
        elif table == "TOTAL" and line.strip():
            total = [float(v) for v in line.split()[-3:]]
    P = 2 * sum(v[0] for v in forces.values())  # in the local system: along d
    axial = -2 * total[2] / c3.C45  # the same load from the support's reaction
    k1 = load / delta**1.5
    return {"mesh": n, "seconds": seconds, "touching_nodes": len(inside), "load_expected": load, "load": P, "load_by_support": axial,
            "approach": approach, "hertz_alone": delta, "ring_n0": ring, "bracket": bracket, "bulk": bulk,
            "load_error": P / load - 1, "load_if_ring_were_added_to_hertz": solve_load(approach, k1, ring),
            "load_if_hertz_alone": k1 * approach**1.5}


def solve_load(approach, k, compliance):
    P = k * approach**1.5
    for _ in range(50):
        f = (P / k) ** (2 / 3) + compliance * P - approach
        P -= f / (2 / 3 * (P / k) ** (2 / 3) / P + compliance)
    return P


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scratch", required=True)
    parser.add_argument("mesh", type=int)
    args = parser.parse_args()
    out = run(args.scratch, args.mesh)
    json.dump(out, open(os.path.join(args.scratch, f"tooth_{args.mesh}.json"), "w"), indent=1)
    print(json.dumps(out, indent=1))
