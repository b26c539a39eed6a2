"""Reference curves: the contact problem of one roller sector on influence matrices. numpy only; shares no code with the program.

Unknown contact forces N (20 screw-roller, 20 nut-roller) and two rigid displacements q = (screw against roller, roller against
thrust section):
    (N_i / k_i)^(2/3) + sum_j C_ij N_j - R_iq q = 0,     sum R_i N_i = F / rollers for each interface,
R = cos(psi) on its own interface, C = C_screw + C_nut + C_roller (n = 0) + roller bending (n = 1) + harmonics of each body.
Axial displacement = q_1 + q_2. Newton in N, damped so that N stays positive.

Matrices (mm/N per roller) are those of axisymmetric.py, roller_bending.py and harmonic_sum.py, stored in data/. Compression: CONFIG k of the
nut is CONFIG 4 - k in tension mirrored; the roller is its own mirror image; the screw has its own matrix.
Usage: curves.py [--check-bars]; writes curves*.csv, summary.csv and error_bars.json.
"""
import argparse
import json
import os

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
E, NU = 209000.0, 0.3  # MPa
ROLLERS, TEETH, PITCH = 11, 20, 5.0 / 3.0
HERTZ = (3.6062e5, 4.2140e5)  # N/mm^1.5, screw-roller and nut-roller
PSI = (np.radians(45.0288), np.radians(45.0803))
ROLLER_R, ROLLER_LENGTH, END_LENGTH, END_R = 3.5, TEETH * PITCH + 10.0, 5.0, 2.5  # mm
POSITIONS = {1: 54.0 + 1.0 / 3.0, 2: 29.0 + 1.0 / 6.0, 3: 4.0}
LOADS = [1, 2, 3, 5, 7, 10, 15, 20, 25, 30, 35, 40, 45]  # kN


def beam_flexibility(direction, guidance, lever, bending_r=ROLLER_R, shear=True, angles=PSI, end_r=END_R, shear_r=None):
    """C = B K^-1 B' of the roller as a beam on its guidance; 40 contacts. v up (outwards), theta counter-clockwise.

    lever: 'opposite' (contacts of a pair at one section, as on a one-start helix) or 'half_pitch' (on one ring-shaped tooth)."""
    centre = END_LENGTH + PITCH / 2 + PITCH * np.arange(TEETH)
    half = {"opposite": 0.0, "half_pitch": PITCH / 4}[lever]
    at_screw, at_nut = centre - direction * half, centre + direction * half  # tension (-1): screw's flank faces +x
    ends = [0.0, END_LENGTH, ROLLER_LENGTH - END_LENGTH, ROLLER_LENGTH]
    x = np.array(sorted(set(np.round(np.concatenate([at_screw, at_nut, ends]), 9))))
    find = lambda v: int(np.argmin(np.abs(x - v)))
    K = np.zeros((2 * len(x), 2 * len(x)))
    for e in range(len(x) - 1):
        l, mid = x[e + 1] - x[e], (x[e + 1] + x[e]) / 2
        r = end_r if mid < END_LENGTH or mid > ROLLER_LENGTH - END_LENGTH else bending_r
        EI = E * np.pi * r**4 / 4
        rs = r if (shear_r is None or r == end_r) else shear_r
        kappa = 6 * (1 + NU) / (7 + 6 * NU)  # Cowper, circular section
        phi = 12 * EI / (kappa * E / (2 * (1 + NU)) * np.pi * rs**2 * l**2) if shear else 0.0
        k = EI / (l**3 * (1 + phi)) * np.array([[12, 6 * l, -12, 6 * l], [6 * l, (4 + phi) * l * l, -6 * l, (2 - phi) * l * l],
                                              [-12, -6 * l, 12, -6 * l], [6 * l, (2 - phi) * l * l, -6 * l, (4 + phi) * l * l]])
        K[2 * e:2 * e + 4, 2 * e:2 * e + 4] += k
    held = [0.0, ROLLER_LENGTH] if guidance == "outer_node" else ends
    fixed = [2 * find(v) for v in held]
    free = [i for i in range(len(K)) if i not in fixed]
    B = np.zeros((2 * TEETH, 2 * len(x)))
    for i in range(TEETH):
        s, n = find(at_screw[i]), find(at_nut[i])
        B[i, 2 * s], B[i, 2 * s + 1] = np.sin(angles[0]), direction * np.cos(angles[0]) * ROLLER_R
        B[TEETH + i, 2 * n], B[TEETH + i, 2 * n + 1] = -np.sin(angles[1]), direction * np.cos(angles[1]) * ROLLER_R
    return B[:, free] @ np.linalg.solve(K[np.ix_(free, free)], B[:, free].T)


def solve(C, force, guess=None):
    """Contact forces (40), rigid displacements (2), residual, iterations; force: axial, of one roller."""
    k = np.repeat(HERTZ, TEETH)
    cos = np.repeat(np.cos(PSI), TEETH)
    R = np.zeros((2 * TEETH, 2))
    R[:TEETH, 0], R[TEETH:, 1] = cos[:TEETH], cos[TEETH:]
    N = force / TEETH / cos if guess is None else guess
    q = np.array([((N / k) ** (2 / 3) + C @ N)[s].mean() / cos[s][0] for s in (slice(0, TEETH), slice(TEETH, None))])
    for iteration in range(60):
        w = (N / k) ** (2 / 3)
        residual = np.concatenate([w + C @ N - R @ q, R.T @ N - force])
        scaled = max(np.abs(residual[:-2]).max() / w.max(), np.abs(residual[-2:]).max() / force)
        if scaled < 1e-13:
            break
        J = np.block([[C + np.diag(2 / 3 * w / N), -R], [R.T, np.zeros((2, 2))]])
        step = np.linalg.solve(J, -residual)
        t = min(1.0, 0.7 / max(1e-300, np.max(-step[:-2] / N)))
        N, q = N + t * step[:-2], q + t * step[-2:]
    assert scaled < 1e-10, scaled
    return N, q, scaled, iteration


def bar_matrices(config, direction):
    """The paper's bars, for the check of this script against the program: (screw, nut, roller n = 0)."""
    i = np.arange(TEETH)
    cs, cn = np.cos(PSI[0]), np.cos(PSI[1])
    x = 10.0 + PITCH * i
    screw = cs * cs * np.minimum.outer(x, x) / (E * np.pi * (10.5**2 - 3.0**2) / ROLLERS)
    thrust = 10.0 if direction < 0 else 80.0
    def compliance(a, b):  # integral of dx/(EA) from a to b
        total, cuts = 0.0, [0.0, 10.0, 80.0, 90.0]
        for p, q, r in zip(cuts[:-1], cuts[1:], (31.0, 23.0, 31.0)):
            total += max(0.0, min(q, b) - max(p, a)) / (E * np.pi * (r * r - 17.5**2) / ROLLERS)
        return total
    y = POSITIONS[config] + PITCH * i
    nut = np.zeros((TEETH, TEETH))
    for a in i:
        for b in i:
            if (y[a] - thrust) * (y[b] - thrust) > 0:
                near = min(abs(y[a] - thrust), abs(y[b] - thrust))
                nut[a, b] = cn * cn * compliance(*sorted((thrust, thrust + near * np.sign(y[a] - thrust))))
    z = PITCH * (i + 1.0)
    s = np.concatenate([np.full(TEETH, -cs), np.full(TEETH, cn)])  # sign of the axial force
    roller = np.outer(s, s) * np.tile(np.minimum.outer(z, z), (2, 2)) / (E * np.pi * ROLLER_R**2)
    return screw, nut, roller


def assemble(screw, nut, roller, beam):
    C = roller + beam
    C[:TEETH, :TEETH] += screw
    C[TEETH:, TEETH:] += nut
    return C


def mirrored(matrix):
    return matrix[::-1, ::-1]


def mirrored_roller(matrix):
    order = np.concatenate([np.arange(TEETH)[::-1], TEETH + np.arange(TEETH)[::-1]])
    return matrix[np.ix_(order, order)]


def load_matrices(folder):
    read = lambda name: np.loadtxt(os.path.join(folder, name + ".csv"), delimiter=",")
    return {"screw": {-1: read("screw_tension"), +1: read("screw_compression")},
            "nut": {c: read(f"nut_config{c}") for c in (1, 2, 3)}, "roller": read("roller_tension"),
            "bending": {g: read(f"roller_bending_{g}") for g in ("both_end_nodes", "outer_node")}}


def banded(values):
    """Symmetric Toeplitz matrix from (self, neighbour, second neighbour, ...)."""
    out = np.zeros((TEETH, TEETH))
    for k, v in enumerate(values):
        out += v * (np.eye(TEETH, k=k) + (np.eye(TEETH, k=-k) if k else 0))
    return out


def rod(guidance, lever, bending_r):
    """Roller in tension as a beam (n = 1) and a bar (n = 0, left end held), flanks at 45 deg, threaded part of one radius for both."""
    beam = beam_flexibility(-1, guidance, lever, bending_r=bending_r, shear_r=bending_r, angles=(np.pi / 4, np.pi / 4))
    centre = END_LENGTH + PITCH / 2 + PITCH * np.arange(TEETH)
    half = {"opposite": 0.0, "half_pitch": PITCH / 4}[lever]
    x = np.concatenate([centre + half, centre - half])
    sign = np.repeat([-1.0, 1.0], TEETH)
    stretch = END_LENGTH / END_R**2 + (np.minimum.outer(x, x) - END_LENGTH) / bending_r**2
    return beam + 0.5 * np.outer(sign, sign) * stretch / (np.pi * E)


def opposite(half_pitch, guidance, bending_r):
    """Roller's matrix in tension with the contacts of a tooth at one section, its centre, from that of ring-shaped teeth, where they lie
    a quarter pitch before and behind. A rod gives the change; what there is beyond it is interpolated: linearly along x at a fixed distance
    of the two contacts on the same side, as the mean of half a pitch before and behind between the two sides."""
    rest = half_pitch - rod(guidance, "half_pitch", bending_r)
    S, G = slice(0, TEETH), slice(TEETH, None)
    def extended(block):  # one tooth more on every side, linearly along the diagonal
        out = np.zeros((TEETH + 2, TEETH + 2))
        out[1:-1, 1:-1] = block
        out[0, :-2], out[:-2, 0] = 2 * out[1, 1:-1] - out[2, 2:], 2 * out[1:-1, 1] - out[2:, 2]
        out[-1, 2:], out[2:, -1] = 2 * out[-2, 1:-1] - out[-3, :-2], 2 * out[1:-1, -2] - out[:-2, -3]
        out[0, -2:], out[-2:, 0] = out[0, -3], out[-3, 0]
        out[-1, :2], out[:2, -1] = out[-1, 2], out[2, -1]
        return out
    screw, nut, cross = extended(rest[S, S]), extended(rest[G, G]), extended(rest[S, G])
    rest[S, S] = 0.75 * screw[1:-1, 1:-1] + 0.25 * screw[:-2, :-2]  # contacts at centre + p/4
    rest[G, G] = 0.75 * nut[1:-1, 1:-1] + 0.25 * nut[2:, 2:]
    rest[S, G] = 0.5 * cross[1:-1, 1:-1] + 0.25 * (cross[1:-1, 2:] + cross[:-2, 1:-1])
    rest[G, S] = rest[S, G].T
    return rest + rod(guidance, "opposite", bending_r)


def case_matrix(data, harmonics, config, direction, guidance, lever, bending_r):
    """Full compliance matrix of a case; harmonics None: rings only (n = 0) and the roller's n = 1."""
    screw = data["screw"][direction].copy()
    nut = (data["nut"][config] if direction < 0 else mirrored(data["nut"][4 - config])).copy()
    roller = data["roller"] + data["bending"][guidance]
    if harmonics:
        screw += banded(harmonics["screw"]["values"])
        nut += banded(harmonics["nut"]["values"])
        for key, rows, cols in (("roller_screw", 0, 0), ("roller_nut", 1, 1), ("roller_cross", 0, 1)):
            offsets = {int(k): v for k, v in harmonics[key]["values_by_offset"].items()}  # column's tooth less row's
            block = sum(v * np.eye(TEETH, k=k) for k, v in offsets.items())
            roller[rows * TEETH:(rows + 1) * TEETH, cols * TEETH:(cols + 1) * TEETH] += block
            if rows != cols:
                roller[cols * TEETH:(cols + 1) * TEETH, rows * TEETH:(rows + 1) * TEETH] += block.T
    if lever == "opposite":
        roller = opposite(roller, guidance, bending_r)
    return assemble(screw, nut, roller if direction < 0 else mirrored_roller(roller), 0.0)


def result(C, kilonewton):
    N, q, residual, iterations = solve(C, kilonewton * 1000.0 / ROLLERS)
    share = N * np.repeat(np.cos(PSI), TEETH) / (kilonewton * 1000.0 / ROLLERS)
    return q.sum() * 1000, kilonewton / (q.sum() * 1000) * 1000, share[:TEETH], share[TEETH:]  # um, N/um


def bar_case(config, direction, guidance):
    return assemble(*bar_matrices(config, direction), beam_flexibility(direction, guidance, "opposite", shear=False))


def mixed(data, harmonics, config, direction, guidance, lever, refined, bending_r):
    """Bars with one body replaced by its finite-element matrices."""
    screw, nut, roller = bar_matrices(config, direction)
    bars = bar_case(config, direction, guidance)
    if refined == "roller":
        nothing = {"screw": {direction: 0 * screw}, "nut": dict.fromkeys((1, 2, 3), 0 * nut), "roller": data["roller"], "bending": data["bending"]}
        own = {k: v for k, v in harmonics.items() if k.startswith("roller_")} | {"screw": {"values": [0.0]}, "nut": {"values": [0.0]}}
        C = case_matrix(nothing, own, config, direction, guidance, lever, bending_r)
        C[:TEETH, :TEETH] += screw
        C[TEETH:, TEETH:] += nut
        return C
    block = slice(0, TEETH) if refined == "screw" else slice(TEETH, None)
    nothing = {"screw": data["screw"], "nut": data["nut"], "roller": 0 * data["roller"], "bending": {guidance: 0 * data["roller"]}}
    own = {k: {"values_by_offset": {"0": 0.0}} if k.startswith("roller_") else v for k, v in harmonics.items()}
    C = bars
    C[block, block] += case_matrix(nothing, own, config, direction, guidance, "half_pitch", bending_r)[block, block]
    C[block, block] -= screw if refined == "screw" else nut
    return C


def write_curves(out, data, harmonics, bending_r, name):
    shares = [f"screw_{i + 1}_%" for i in range(TEETH)] + [f"nut_{i + 1}_%" for i in range(TEETH)]
    with open(os.path.join(out, name), "w") as f:
        f.write(",".join(["config", "direction", "guidance", "lever", "load_kN", "displacement_um", "stiffness_N_per_um"] + shares) + "\n")
        for config in (1, 2, 3):
            for direction, label in ((-1, "tension"), (1, "compression")):
                for guidance in ("both_end_nodes", "outer_node"):
                    for lever in ("opposite", "half_pitch"):
                        C = case_matrix(data, harmonics, config, direction, guidance, lever, bending_r)
                        for kilonewton in LOADS:
                            um, stiffness, s, n = result(C, kilonewton)
                            row = [str(config), label, guidance, lever, str(kilonewton), f"{um:.5f}", f"{stiffness:.4f}"]
                            f.write(",".join(row + [f"{100 * v:.5f}" for v in np.concatenate([s, n])]) + "\n")


def write_summary(out, data, harmonics, bending_r):
    """45 kN, displacement in um: bars, rings only, everything, and each body alone in place of its bar."""
    header = ["config", "direction", "guidance", "lever", "bars_um", "rings_um", "all_um", "bars_N_per_um", "rings_N_per_um", "all_N_per_um",
              "screw_increment_um", "nut_increment_um", "roller_increment_um", "largest_share_change_%"]
    with open(os.path.join(out, "summary.csv"), "w") as f:
        f.write(",".join(header) + "\n")
        for guidance in ("both_end_nodes", "outer_node"):
            for lever in ("opposite", "half_pitch"):
                for direction, label in ((-1, "tension"), (1, "compression")):
                    for config in (1, 2, 3):
                        bars = result(bar_case(config, direction, guidance), 45)
                        rings = result(case_matrix(data, None, config, direction, guidance, lever, bending_r), 45)
                        whole = result(case_matrix(data, harmonics, config, direction, guidance, lever, bending_r), 45)
                        alone = [result(mixed(data, harmonics, config, direction, guidance, lever, b, bending_r), 45)[0] - bars[0]
                                 for b in ("screw", "nut", "roller")]
                        change = 100 * max(np.abs(whole[2] - bars[2]).max(), np.abs(whole[3] - bars[3]).max())
                        f.write(",".join([str(config), label, guidance, lever] + [f"{v[0]:.4f}" for v in (bars, rings, whole)] +
                                         [f"{v[1]:.3f}" for v in (bars, rings, whole)] + [f"{v:.4f}" for v in alone] + [f"{change:.4f}"]) + "\n")


def error_bars(data, harmonics, bending_r, errors):
    """Largest change in stiffness (%) and in a thread's load (% of the sector load) at 45 kN when one part moves by its error bar."""
    report = {}
    cases = [(c, d, g, l) for c in (1, 2, 3) for d in (-1, 1) for g in ("both_end_nodes", "outer_node") for l in ("opposite", "half_pitch")]
    base = {case: result(case_matrix(data, harmonics, *case, bending_r), 45) for case in cases}
    def moved(name, changed_data, changed_harmonics):
        largest = np.zeros(2)
        for case in cases:
            new, old = result(case_matrix(changed_data, changed_harmonics, *case, bending_r), 45), base[case]
            largest = np.maximum(largest, [abs(new[1] / old[1] - 1), max(np.abs(new[2] - old[2]).max(), np.abs(new[3] - old[3]).max())])
        report[name] = (100 * largest).tolist()
    for body in ("screw", "nut"):
        values = np.array(harmonics[body]["values"]) + np.array(harmonics[body]["error_bar"])
        moved(f"{body} harmonics", data, harmonics | {body: {"values": values.tolist()}})
        moved(f"{body} n = 0", data | {body: {k: m + errors[body] * np.abs(m).max() * np.eye(TEETH) for k, m in data[body].items()}}, harmonics)
    for key in ("roller_screw", "roller_nut", "roller_cross"):
        values = {k: v + (harmonics["roller"]["error_bar"] if k == "0" else 0.0) for k, v in harmonics[key]["values_by_offset"].items()}
        moved(f"{key} harmonics", data, harmonics | {key: {"values_by_offset": values}})
    moved("roller n = 0", data | {"roller": data["roller"] * (1 + errors["roller"])}, harmonics)
    moved("roller n = 1", data | {"bending": {k: m * (1 + errors["bending"]) for k, m in data["bending"].items()}}, harmonics)
    report["all, added"] = np.sum(list(report.values()), axis=0).tolist()
    return report


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check-bars", action="store_true", help="print the bar model's results, to compare with `prs solve`")
    parser.add_argument("--data", default=os.path.join(HERE, "data"))
    args = parser.parse_args()
    if args.check_bars:
        for direction in (-1, 1):
            for config in (1, 2, 3):
                beam = beam_flexibility(direction, "both_end_nodes", "opposite", shear=False)
                um, stiffness, s, n = result(assemble(*bar_matrices(config, direction), beam), 45)
                print(config, {-1: "tension", 1: "compression"}[direction], f"{um:.6f} um {stiffness:.6f} N/um", s[0], n[0], n[-1])
        raise SystemExit
    data = load_matrices(args.data)
    read = lambda name: json.load(open(os.path.join(args.data, name)))
    harmonics = read("harmonics.json")
    bending_r = harmonics["roller"]["bending_r_mm"]
    write_curves(args.data, data, harmonics, bending_r, "curves.csv")
    write_curves(args.data, data, None, bending_r, "curves_rings_only.csv")
    write_summary(args.data, data, harmonics, bending_r)
    print(open(os.path.join(args.data, "summary.csv")).read())
    known, bending = read("convergence.json"), read("roller_bending.json")
    errors = {body: known[body]["error_bar_self"] for body in ("screw", "nut", "roller")}
    errors["bending"] = max(r["error_bar"] for r in bending.values())
    report = {"relative_errors_assumed": errors, "stiffness_and_loads_percent": error_bars(data, harmonics, bending_r, errors)}
    json.dump(report, open(os.path.join(args.data, "error_bars.json"), "w"), indent=1)
    print(json.dumps(report, indent=1))
