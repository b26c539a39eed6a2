"""From the runs of single_harmonics.py to data/single_harmonics.csv and to the sum of the harmonics, data/harmonics.json.

Mesh: C = C_s + kappa (C_s - C_(s-1)) in the section, kappa = s^-q/((s-1)^-q - s^-q), q from three meshes; plus 16/15 (C(4 layers) - C(2 layers)), order 4,
around the circle. Sum over the harmonics N, 2N, .. (roller: 2, 3, .., sign (-1)^n between its two sides) of the Hertz ellipse:
    K(distance) = N sum_n C_n(distance) + [distance = 0] (R(k_c) - H),    k_c = (n_last + N/2)/r,
H: half-space, which exact Hertz carries; R(k_c): its part of wave numbers beyond k_c around the circle,
    R(k_c) = 4 (1 - nu^2)/(E (2 pi)^2) integral_{k > k_c} integral_l P^2/sqrt(k^2 + l^2) dl dk,    P = 3 j_1(q)/q,  q^2 = (a_t k)^2 + (a_s l)^2.
Error bar: mesh, and R times what the last harmonic differs from the half-space's own.

Usage: harmonic_sum.py SCRATCH. Units: mm/N per contact force of one roller.
"""
import glob
import json
import os
import sys

import axisymmetric as ax
import cyclic_3d as c3
import numpy as np
import single_harmonics as sh
from scipy.integrate import quad
from scipy.optimize import brentq

HERE = os.path.dirname(os.path.abspath(__file__))
CASES = [("screw", 11), ("screw", 22), ("nut", 11), ("roller", 2), ("roller", 3)]


def runs(scratch, body, n, suffix=""):
    """{(sub, layers): {"loaded answer": array over the distance}} of the longest block that was run."""
    found = {}
    for path in glob.glob(os.path.join(scratch, f"{body}_n{n}_*{suffix}.json")):
        parts = os.path.basename(path)[:-len(suffix + ".json")].split("_")
        if len(parts) == 5:
            teeth, sub, layers = map(int, parts[2:])
            out = json.load(open(path))
            found.setdefault(teeth, {})[sub, layers] = {k: np.array(v) for k, v in out["values"].items()}
    return found[max(found)] if found else {}


def order(values, first):
    """q of v_s = v + c s^-q from subdivisions first, first + 1, first + 2."""
    a, b, c = (float(first + i) for i in range(3))
    f = lambda q: (b**-q - c**-q) / (a**-q - b**-q) - (values[2] - values[1]) / (values[1] - values[0])
    return brentq(f, 0.5, 6.0) if f(0.5) * f(6.0) < 0 else float("nan")


def single(scratch, body, n):
    """Limits and error bars of the smooth load's C_n, the order of the loaded tooth, and kappa that takes meshes 1, 2 there."""
    v = runs(scratch, body, n)
    out, report = {}, {}
    for key in v[1, 2]:
        middle = len(v[1, 2][key]) // 2
        q = order([v[s, 2][key][middle] for s in (2, 3, 4)], 2)
        kappa = 4.0**-q / (3.0**-q - 4.0**-q)
        around = 16 / 15 * (v[1, 4][key] - v[1, 2][key])
        step = v[4, 2][key] - v[3, 2][key]
        best = v[4, 2][key] + kappa * step + around
        error = np.abs(kappa * step) + 0.1 * np.abs(around) + 3e-7 * np.abs(best).max()
        out[key] = best, error
        report[key] = {"order": q, "meshes": [float(v[s, 2][key][middle]) for s in (1, 2, 3, 4)], "around": float(around[middle]),
                       "limit": float(best[middle]), "error": float(error[middle])}
    return out, report


def write_single(scratch, path):
    report = {}
    with open(path, "w") as f:
        f.write("body,harmonic,teeth,flank_from,flank_to,distance,value_mm_per_N,error\n")
        for body, n in CASES:
            values, report[f"{body} {n}"] = single(scratch, body, n)
            for key, (best, error) in values.items():
                reach = len(best) // 2
                for k in range(-2, 3):
                    f.write(f"{body},{n},{2 * reach + 1},{key.replace(' ', ',')},{k},{best[reach + k]:.9e},{error[reach + k]:.2e}\n")
    return report


# ---------------------------------------------------------------- the half-space

FACTOR = 4 * (1 - ax.NU**2) / (ax.E * (2 * np.pi) ** 2)


def squared_spectrum(q):
    return (3 * (np.sin(q) - q * np.cos(q)) / q**3) ** 2 if q > 1e-2 else 1 - q * q / 5


def line(k, a_s, a_t):
    """integral over l of P^2/sqrt(k^2 + l^2); l = k sinh t."""
    f = lambda t: squared_spectrum(np.hypot(a_t * k, a_s * k * np.sinh(t)))
    return 2 * quad(f, 0, np.arcsinh(80 / (a_s * k)), limit=400, epsrel=1e-9)[0]


def below(k, a_s, a_t):
    """The half-space's part of wave numbers up to k."""
    return FACTOR * quad(lambda x: line(np.exp(x), a_s, a_t) * np.exp(x), np.log(1e-7), np.log(k), limit=200, epsrel=1e-8)[0]


# ---------------------------------------------------------------- the sum

def kappas(scratch, body, suffix):
    """log n and kappa of meshes 1, 2 at the loaded tooth: from mesh 3, where there is one; the smooth load has the same."""
    points = []
    for n in range(2, 400):
        for v in (runs(scratch, body, n, suffix), runs(scratch, body, n) if suffix == "_1.0" else {}):
            if (3, 2) in v:
                own = [key for key in v[3, 2] if len(set(key.split())) == 1]
                q = [order([v[s, 2][key][len(v[s, 2][key]) // 2] for s in (1, 2, 3)], 1) for key in own]
                points.append((np.log(n), float(np.mean([2.0**-x / (1 - 2.0**-x) for x in q]))))
                break
    return np.array(points)


def limits(scratch, body, suffix):
    """{n: {key: C_n over the distance}}, kappas, and the self terms' uncertainty by n: half of the section's extrapolation.

    Mesh corrections are interpolated in log n where only the coarse mesh was run, kappa where mesh 3 was not."""
    available = {n: v for n in range(2, 400) if (v := runs(scratch, body, n, suffix))}
    known = kappas(scratch, body, suffix)
    out, doubt = {}, {}
    for key in next(iter(available.values()))[1, 2]:
        own = " ".join(key.split()[:1] * 2)
        fine, correction, extrapolated = [], [], []
        for n, v in available.items():
            if (2, 2) in v and (1, 4) in v:
                kappa = np.interp(np.log(n), *known.T)
                step = v[2, 2][key] - v[1, 2][key]
                middle = len(step) // 2
                scale = v[1, 2][own][middle]
                fine.append(np.log(n))
                correction.append(((1 + kappa) * step + 16 / 15 * (v[1, 4][key] - v[1, 2][key]))[middle - 2:middle + 3] / scale)
                extrapolated.append(abs(kappa * step[middle] / scale))
        correction = np.array(correction)
        for n, v in available.items():
            values = v[1, 2][key].copy()
            middle = len(values) // 2
            scale = v[1, 2][own][middle]
            values[middle - 2:middle + 3] += scale * np.array([np.interp(np.log(n), fine, correction[:, i]) for i in range(5)])
            out.setdefault(n, {})[key] = values
            doubt.setdefault(n, {})[key] = 0.5 * scale * np.interp(np.log(n), fine, extrapolated)
    return out, doubt, known


def total(scratch, body, scale, reach=4):
    """K over the distance -reach..reach by key, error bar of the self terms, and how the harmonics compare with the half-space's."""
    step = 1 if body == "roller" else ax.ROLLERS
    radius = sh.PITCH_R[body]
    v, doubt, known = limits(scratch, body, f"_{scale}")
    last = max(v)
    assert sorted(v) == list(range(min(v), last + 1, step)), sorted(v)
    p = ax.patches()
    sums, facts = {}, {}
    for key in v[last]:
        loaded, answer = key.split()
        sums[key] = np.zeros(2 * reach + 1)
        for n, values in v.items():
            c = values[key]
            m = min(reach, len(c) // 2)
            sign = (-1) ** n if loaded != answer else 1
            sums[key][reach - m:reach + m + 1] += sign * step * c[len(c) // 2 - m:len(c) // 2 + m + 1]
        if loaded == answer:
            a_s, a_t = (s * scale for s in p[sh.FLANKS[body][loaded][1]][:2])
            half_space = c3.half_space(sh.FLANKS[body][loaded][1]) / scale
            series = sums[key][reach]
            rest = half_space - below((last + step / 2) / radius, a_s, a_t)
            sums[key][reach] += rest - half_space
            ratio = {n: float(v[n][key][len(v[n][key]) // 2] / (FACTOR * line(n / radius, a_s, a_t) / radius)) for n in v}
            unsure = step * sum(d[key] for d in doubt.values()) + abs(1 - ratio[last]) * rest
            facts[key] = {"half_space": half_space, "series": series, "remainder": rest, "last": last, "last_wave": last * a_t / radius,
                          "ratio_to_half_space": ratio, "error": unsure, "kappas": {int(round(np.exp(a))): b for a, b in known}}
    return sums, facts


def check_half_space():
    """Relative difference of the spectrum's integral from the closed form of cyclic_3d.half_space()."""
    worst = 0.0
    for name, (a_s, a_t, *_) in ax.patches().items():
        worst = max(worst, abs(below(400 / min(a_s, a_t), a_s, a_t) / c3.half_space(name) - 1))
    return worst


def fold(v):
    """Self, neighbour, second neighbour, ..: reciprocity makes both sides equal but for the block's ends."""
    m = len(v) // 2
    return np.array([v[m]] + [(v[m - k] + v[m + k]) / 2 for k in range(1, m + 1)])


def ring_bracket(scratch, scale):
    """Screw, n = 0: self less the mean of the neighbours at contact 9, limit of meshes 1, 2, 3 of axisymmetric.py, and its last step."""
    suffix = "" if scale == 1.0 else f"_{scale}"
    v = []
    for s in (1, 2, 3):
        run = np.load(os.path.join(scratch, f"screw_tension_{s}{suffix}.npz"))
        u = ax.ROLLERS * run["normal"][:, list(run["loads"]).index(9)]
        v.append(u[9] - (u[8] + u[10]) / 2)
    q = order(v, 1)
    step = 3.0**-q / (2.0**-q - 3.0**-q) * (v[2] - v[1])
    return v[2] + step, abs(step)


def write_sums(scratch, path):
    report = {"unit": "mm/N per contact force of one roller", "half_space": {b: c3.half_space(b) for b in ("screw", "nut")},
              "spectrum_against_closed_form": check_half_space()}
    facts = {}
    for body in ("screw", "nut"):
        sums, facts[body] = total(scratch, body, 1.0)
        (key, v), = sums.items()
        values = fold(v)
        error = np.abs(v - v[::-1])[4:] / 2 + 3e-4 * np.abs(values)
        error[0] = facts[body][key]["error"]
        report[body] = {"values": values.tolist(), "error_bar": error.tolist(), **facts[body][key]}
    sums, half = total(scratch, "screw", 0.5)
    (key, v), = sums.items()
    values = fold(v)
    report["screw_half_patch"] = {"values": values.tolist(), **half[key]}
    report["bracket"] = {}  # self less neighbour with n = 0, half-space taken out: free of the patch
    for scale, run in ((1.0, report["screw"]), (0.5, report["screw_half_patch"])):
        ring, unsure = ring_bracket(scratch, scale)
        report["bracket"][str(scale)] = {"ring": ring, "harmonics": run["values"][0] - run["values"][1],
                                         "sum": ring + run["values"][0] - run["values"][1], "error": unsure + run["error"]}
    report["bracket"]["half_patch_over_whole"] = report["bracket"]["0.5"]["sum"] / report["bracket"]["1.0"]["sum"]
    sums, half = total(scratch, "roller", 1.0)
    bending = [json.load(open(f))["bending_r"] for f in sorted(glob.glob(os.path.join(scratch, "roller3d_*.json")))]
    report["roller"] = {"bending_r_mm": bending[-1], "error_bar": max(h["error"] for h in half.values())}
    for name, flank in (("screw", "forward"), ("nut", "backward")):
        v = fold(sums[f"{flank} {flank}"])
        report["roller_" + name] = {"values_by_offset": {str(k): v[abs(k)] for k in range(-4, 5)}, **half[f"{flank} {flank}"]}
    # rows screw, columns nut, column's tooth less row's
    one, two = sums["forward backward"], sums["backward forward"][::-1]
    report["roller_cross"] = {"values_by_offset": {str(k): (one[k + 4] + two[k + 4]) / 2 for k in range(-4, 5)},
                              "reciprocity": np.abs(one - two).max()}
    json.dump(report, open(path, "w"), indent=1)
    return report


if __name__ == "__main__":
    scratch = sys.argv[1]
    out = os.path.join(HERE, "data")
    report = write_single(scratch, os.path.join(out, "single_harmonics.csv"))
    sums = write_sums(scratch, os.path.join(out, "harmonics.json"))
    json.dump({"unit": "mm/N", "cases": report}, open(os.path.join(out, "single_harmonics.json"), "w"), indent=1)
    print(json.dumps(sums, indent=1))
