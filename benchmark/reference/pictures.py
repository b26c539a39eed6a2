"""Draws picture.svg of every case from its numbers: pictures.py [NN ..]. Needs matplotlib."""
import csv
import re
import sys
from math import cos, pi, sin
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle, Ellipse, Rectangle

sys.path.insert(0, str(Path(__file__).resolve().parent))
import cases

BENCHMARK = Path(__file__).resolve().parents[1]
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "benchmark", "font.size": 9})
BLUE, ORANGE, GREEN, GREY = "#1f77b4", "#e6820e", "#2a9d4f", "#bbbbbb"


def expected(number):
    folder = next(BENCHMARK.glob(number + "_*"))
    with open(folder / "expected.csv") as file:
        return {row["quantity"]: float(row["value"]) for row in csv.DictReader(file)}


def box(ax, x_0, x_1, y_0, y_1, colour):
    for sign in (1, -1) if y_0 >= 0 else (1,):
        ax.add_patch(Rectangle((x_0, min(sign * y_0, sign * y_1)), x_1 - x_0, abs(y_1 - y_0), facecolor=colour,
                               alpha=0.35, edgecolor="black", linewidth=0.6))


def section(ax, s, position, thrust, load="tension", flanges=(), title="mm"):
    """Half section: nut above the roller above the screw; s is a dictionary of dimensions in m."""
    mm, n, p = 1e3, s["threads"], s["pitch"] * 1e3
    x = [position * mm + i * p for i in range(n)]
    screw, roller, nut = (s[k] * mm / 2 for k in ("screw_diameter", "roller_diameter", "nut_diameter"))
    outer, centre = s["nut_outer"] * mm / 2, screw + roller
    box(ax, 0, s["nut_length"] * mm, nut, outer, BLUE)
    for a, b, d in flanges:
        ax.add_patch(Rectangle((a * mm, outer), (b - a) * mm, d * mm / 2 - outer, facecolor=BLUE, alpha=0.35,
                               edgecolor="black", linewidth=0.6))
    first = position * mm - s["free_length"] * mm
    ax.add_patch(Rectangle((first, s["bore"] * mm / 2), x[-1] - first, screw - s["bore"] * mm / 2, facecolor=GREEN,
                           alpha=0.35, edgecolor="black", linewidth=0.6))
    e = s["end_length"] * mm
    for a, b, d in ((x[0] - p / 2 - e, x[0] - p / 2, s["end_diameter"] * mm), (x[0] - p / 2, x[-1] + p / 2, 2 * roller),
                    (x[-1] + p / 2, x[-1] + p / 2 + e, s["end_diameter"] * mm)):
        ax.add_patch(Rectangle((a, centre - d / 2), b - a, d, facecolor=ORANGE, alpha=0.45, edgecolor="black",
                               linewidth=0.6))
    ax.plot(x, [screw] * n, "k.", markersize=3)
    ax.plot(x, [nut] * n, "k.", markersize=3)
    way = -1 if load == "tension" else 1
    ax.annotate("", (first + 9 * way, screw / 2), (first, screw / 2), arrowprops={"arrowstyle": "->", "lw": 1.5})
    ax.text(first + 4 * way, screw / 2 + 1.5, "F", ha="center")
    ax.plot([thrust * mm] * 2, [outer, outer + 9], "k-", linewidth=2)
    ax.text(thrust * mm, outer + 10, "held", ha="center", fontsize=8)
    ax.axhline(0.0, color="grey", linewidth=0.6, linestyle="-.")
    ax.set_aspect("equal")
    ax.set_xlim(min(first - 12, -5), s["nut_length"] * mm + 5)
    ax.set_ylim(-2, outer + 14)
    ax.set_xlabel(f"x, {title}")
    ax.set_yticks([])


def bars(ax, values, pattern, labels):
    """Loads of the threads as groups; `pattern` has BODY for screw and nut."""
    for body, colour in (("screw", GREEN), ("nut", BLUE)):
        for (prefix, label), style in zip(labels, ("-", "--", ":")):
            found = {int(m[1]): v for q, v in values.items()
                     if (m := re.fullmatch(re.escape(prefix) + pattern.replace("BODY", body), q))}
            if found:
                k = sorted(found)
                ax.plot(k, [found[i] for i in k], style, marker=".", color=colour, markersize=4, linewidth=1,
                        label=f"{body}{', ' + label if label else ''}")
    ax.set_xlabel("thread")
    ax.xaxis.get_major_locator().set_params(integer=True)
    ax.legend(fontsize=7, frameon=False)


def sector_case(number, s, position, thrust, labels, pattern=r"thread_load_BODY_(\d+)_N", ylabel="normal force, N",
                direction="tension"):
    fig, (a, b) = plt.subplots(1, 2, figsize=(9.4, 3.0), width_ratios=(1.35, 1))
    section(a, s, position, thrust, direction, s.get("flanges", ()))
    bars(b, expected(number), pattern, labels)
    b.set_ylabel(ylabel)
    return fig


def around(number, note, missing=(), thick=()):
    fig, (a, b) = plt.subplots(1, 2, figsize=(9.4, 3.2), width_ratios=(1, 1.5))
    s = cases.SCREW_B
    screw, roller, nut, outer = (s[k] * 1e3 / 2 for k in ("screw_diameter", "roller_diameter", "nut_diameter",
                                                          "nut_outer"))
    for r, colour in ((outer, BLUE), (nut, "white"), (screw, GREEN), (s["bore"] * 5e2, "white")):
        a.add_patch(Circle((0, 0), r, facecolor=colour, edgecolor="black", linewidth=0.6,
                           alpha=1.0 if colour == "white" else 0.35))
    for j in range(5):
        y, z = (14 * f(2 * pi * j / 5) for f in (cos, sin))
        gone = j in missing
        a.add_patch(Circle((y, z), roller * (1.08 if j in thick else 1.0), facecolor="none" if gone else ORANGE,
                           alpha=0.9 if gone else 0.5, linestyle=":" if gone else "-", edgecolor="black",
                           linewidth=1.4 if j in thick else 0.6))
        a.text(y, z, str(j + 1), ha="center", va="center")
    a.annotate("y", (outer + 5, 0), (outer, 0), arrowprops={"arrowstyle": "-"}, va="center")
    a.annotate("z", (0, outer + 5), (0, outer), arrowprops={"arrowstyle": "-"}, ha="center")
    a.set_aspect("equal")
    a.set_xlim(-26, 32)
    a.set_ylim(-26, 30)
    a.axis("off")
    a.set_title(note, fontsize=9)
    values = expected(number)
    for j in range(5):
        b.plot(range(1, 5), [values[f"thread_load_screw_{j + 1}_{k}_N"] for k in range(1, 5)], marker=".",
               label=f"roller {j + 1}", linestyle=("-", "-", "-", "--", "--")[j])
    b.set_xticks(range(1, 5))
    b.set_xlabel("thread of the screw")
    b.set_ylabel("normal force, N")
    b.legend(fontsize=7, frameon=False)
    return fig


def travel():
    rows = expected("17")
    figure, ax = plt.subplots(figsize=(7, 2.8))
    deviation = [rows[f"deviation_{k}_um"] for k in range(25)]
    ax.plot([k / 12 for k in range(25)], deviation, marker="o", markersize=3)
    ax.set_xlabel("turns of the screw against the nut")
    ax.set_ylabel("travel deviation, um")
    ax.grid(alpha=0.3)
    return figure


def modes():
    rows = expected("18")
    figure, ax = plt.subplots(figsize=(7, 2.8))
    numbers = range(1, 11)
    ax.bar(numbers, [rows[f"frequency_{k}_Hz"] / 1e3 for k in numbers], width=0.6)
    ax.set_xticks(list(numbers))
    ax.set_xlabel("mode")
    ax.set_ylabel("natural frequency, kHz")
    return figure


def reversal():
    drive = cases.Drive(**cases.DRIVE).run(1e-9)
    figure, ax = plt.subplots(figsize=(7, 2.8))
    for times, force in drive.pieces:
        ax.plot(1e3 * times, force, color=BLUE, linewidth=1.2)
    for time, *_ in drive.impacts:
        ax.axvline(1e3 * time, color=ORANGE, linestyle=":", linewidth=1)
    ax.set_xlabel("time, ms")
    ax.set_ylabel("force of the screw, N")
    ax.grid(alpha=0.3)
    return figure


def contacts():
    fig, axes = plt.subplots(1, 2, figsize=(9.0, 3.0))
    *points, _ = cases.standard_threads(0.015, 0.005, 0.025, 0.010, 5, 7.07e-3, 0.020)
    a, b = axes
    for centre, r, colour, name in (((0, 0), 15, GREEN, "screw"), ((20, 0), 5, ORANGE, "roller"), ((0, 0), 25, BLUE, "nut")):
        a.add_patch(Circle(centre, r, fill=False, edgecolor=colour, linewidth=1.5))
        at = {"screw": (10.5, 0), "roller": (20, 0), "nut": (25.5, -4.5)}[name]
        a.text(*at, name, color=colour, ha="left" if name == "nut" else "center")
    for p, name in zip(points, "IJ"):
        a.plot(1e3 * p.x, 1e3 * p.y, "ko", markersize=3)
        a.text(1e3 * p.x + 0.3, 1e3 * p.y + 0.6, name)
    a.set_xlim(8, 29)
    a.set_ylim(-7, 7)
    a.set_aspect("equal")
    a.set_xlabel("x, mm")
    values = expected("02")
    for k, body in enumerate(("screw", "nut")):
        b.add_patch(Ellipse((0.7 * k, 0), 2 * values[f"semi_major_{body}_mm"], 2 * values[f"semi_minor_{body}_mm"],
                            facecolor=(GREEN, BLUE)[k], alpha=0.5, edgecolor="black"))
        b.text(0.7 * k, 0.26, f"{body}: {values[f'peak_pressure_{body}_MPa']:.0f} MPa", ha="center")
    b.set_xlim(-0.4, 1.1)
    b.set_ylim(-0.3, 0.35)
    b.set_aspect("equal")
    b.set_xlabel("ellipses under 200 N, mm")
    return fig


def slip_case(number, cases_of):
    fig, (a, b) = plt.subplots(1, 2, figsize=(9.0, 3.0))
    model = cases.screw_c(law=cases.Law(coefficient=0.1))
    p, h = model.points[0], model.hertz[0]
    n_0 = model.loads[0][0] / p.normal[2]
    slide, _, spin = model.motion(model.ideal(), 0)
    g = np.array([(x, y) for x in np.linspace(-0.9, 0.9, 9) for y in np.linspace(-0.9, 0.9, 9) if x * x + y * y < 0.95])
    t_1, t_2 = 1e3 * h.major(n_0) * g[:, 0], 1e3 * h.minor(n_0) * g[:, 1]
    spin *= p.normal[2]
    a.quiver(t_1, t_2, slide @ p.major_axis - spin * t_2 / 1e3, slide @ p.minor_axis + spin * t_1 / 1e3, color=GREEN)
    a.add_patch(Ellipse((0, 0), 2e3 * h.major(n_0), 2e3 * h.minor(n_0), fill=False))
    a.set_aspect("equal")
    a.set_xlabel("sliding at the screw, along the major axis, mm")
    values = expected(number)
    b.bar(cases_of, [values[f"{c}.power_loss_screw_contacts_W"] for c in cases_of], color=GREEN, alpha=0.6, label="screw")
    b.bar(cases_of, [values[f"{c}.power_loss_W"] - values[f"{c}.power_loss_screw_contacts_W"] for c in cases_of],
          bottom=[values[f"{c}.power_loss_screw_contacts_W"] for c in cases_of], color=BLUE, alpha=0.6, label="nut")
    for i, c in enumerate(cases_of):
        e = values.get(f"{c}.efficiency")
        b.text(i, values[f"{c}.power_loss_W"], f"efficiency {100 * e:.2f} %" if e else "self-locking", ha="center",
               va="bottom", fontsize=8)
    b.margins(y=0.15)
    b.set_ylabel("power lost, W")
    b.legend(fontsize=7, frameon=False)
    return fig


def heat():
    fig, a = plt.subplots(figsize=(7.6, 2.6))
    v = expected("15")
    for x, part in ((1, "screw"), (3, "rollers"), (5, "nut")):
        a.add_patch(Rectangle((x - 0.6, 0.6), 1.2, 0.8, facecolor=ORANGE, alpha=0.4, edgecolor="black"))
        a.text(x, 1.0, f"{part}\n{v[f'film.temperature_{part}_degC']:.2f} °C", ha="center", va="center")
        a.annotate(f"{v[f'film.heat_{part}_W']:.2f} W", (x, 1.4), (x, 2.0), ha="center", arrowprops={"arrowstyle": "->"})
    for x_0, x_1, label in ((1.6, 2.4, "15 W/K"), (3.6, 4.4, "20 W/K")):
        a.plot([x_0, x_1], [1, 1], "k-")
        a.text((x_0 + x_1) / 2, 1.08, label, ha="center", fontsize=8)
    for x, label in ((1, "2 W/K"), (5, "4 W/K")):
        a.plot([x, x], [0.6, 0.1], "k-")
        a.text(x + 0.08, 0.3, label, fontsize=8)
    a.text(3, -0.08, "surroundings 25 °C", ha="center")
    a.plot([0.5, 5.5], [0.1, 0.1], "k-", linewidth=2)
    a.set_xlim(0.2, 5.8)
    a.set_ylim(-0.15, 2.25)
    a.axis("off")
    return fig


def life():
    fig, (a, b) = plt.subplots(1, 2, figsize=(9.0, 2.8))
    a.bar([0.15, 0.8, 2.3], [20, 12, -8], width=[0.3, 1.0, 2.0], color=[GREEN, GREEN, ORANGE], alpha=0.6, edgecolor="black")
    a.axhline(0, color="black", linewidth=0.6)
    a.set_xlabel("revolutions, millions")
    a.set_ylabel("force, kN (tension > 0)")
    v = expected("16")
    names = {"by mean load": "life_by_mean_load_revolutions", "equal threads": "life_equal_threads_revolutions",
             "real threads": "life_revolutions", "weakest thread": "weakest_thread_life_revolutions"}
    b.barh(list(names), [v[q] / 1e6 for q in names.values()], color=BLUE, alpha=0.6)
    b.set_xscale("log")
    b.set_xlabel("life, million revolutions")
    return fig


def axes_over_time():
    fig, all_axes = plt.subplots(1, 3, figsize=(9.4, 2.6))
    for ax, (name, a) in zip(all_axes, cases.AXES.items()):
        f = cases.axis_forces(a)
        t, values, clock = [], [], 0.0
        for i, (force, length) in enumerate(zip(f, [a["ramp"], a["steady"], a["ramp"]] * 2)):
            if i == 3:
                clock += 0.5
            t += [clock, clock + length]
            values += [force, force]
            clock += length
        ax.plot(t, values, color=GREEN)
        ax.axhline(0, color="grey", linewidth=0.6)
        ax.set_title(name.replace("_", " "), fontsize=9)
        ax.set_xlabel("time, s")
    all_axes[0].set_ylabel("axial force, N")
    return fig


def draw(number):
    a = cases.SCREW_A
    two = dict(a, rollers=8, threads=2, nut_length=0.025, flanges=())
    running = dict(threads=10, pitch=1e-3, screw_diameter=0.02494, roller_diameter=0.025 / 3, nut_diameter=0.125 / 3,
                   bore=0.0, free_length=0.012, end_length=0.005, end_diameter=0.007, nut_length=0.034, nut_outer=0.054)
    both = [("tension.", "tension"), ("compression.", "compression")]
    second = [("position_2_" + k, v) for k, v in both]
    middle = (a, cases.POSITIONS["position_2"], 0.010)
    drawings = {
        "01": lambda: sector_case("01", two, 0.010, 0.0, [("", "")]),
        "02": contacts,
        "03": lambda: sector_case("03", a, cases.POSITIONS["position_1"], 0.010,
                                  [(f"position_{i}_tension.", f"position {i}") for i in (1, 2, 3)]),
        "04": lambda: sector_case("04", *middle, second),
        "05": lambda: sector_case("05", *middle, both),
        "06": lambda: sector_case("06", *middle, [("", "")], r"thread_share_BODY_(\d+)_percent", "share of the load, %"),
        "07": lambda: around("07", "nut tilted about z, screw clamped"),
        "08": lambda: around("08", "moment about z at the screw"),
        "09": lambda: around("09", "side force along y at the screw"),
        "10": lambda: around("10", "roller 1 is missing", missing=(0,)),
        "11": lambda: around("11", "roller 1 is thicker", thick=(0,)),
        "17": travel,
        "18": modes,
        "19": reversal,
        "12": lambda: slip_case("12", ("coulomb", "film", "mixed")),
        "13": lambda: slip_case("13", ("screw_drives", "load_drives", "self_locking")),
        "14": lambda: sector_case("14", running, 0.012, 0.0, [("at_rest.", "at rest"), ("screw_drives.", "screw drives"),
                                                              ("load_drives.", "load drives")]),
        "15": heat, "16": life, "20": axes_over_time}
    fig = drawings[number]()
    fig.tight_layout()
    path = next(BENCHMARK.glob(number + "_*")) / "picture.svg"
    fig.savefig(path, metadata={"Date": None, "Creator": None})
    plt.close(fig)
    # matplotlib ends lines with blanks.
    path.write_text("\n".join(line.rstrip() for line in path.read_text().splitlines()) + "\n")


if __name__ == "__main__":
    for one in sys.argv[1:] or [f.name[:2] for f in sorted(BENCHMARK.glob("[0-9][0-9]_*"))]:
        draw(one)
