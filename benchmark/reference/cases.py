"""The twenty cases in numbers: what each expects, how sure that is, and where it comes from.

Nothing here uses the program that the benchmark was made beside. Case NN is the function `case_NN`; it fills rows
(quantity, unit, value, uncertainty, reason, source, counts).
"""
import csv
import json
from math import atan, cos, log10, pi, radians, sqrt, tan
from pathlib import Path

import numpy as np
import running
from drive import OMEGA, SUMS, Drive, X, flank_constant
from hertz import Contact, effective_modulus
from mechanism import Mechanism
from sector import Sector, gaps
from slip import Law, Oil, Slip
from threads import Flank, TouchPoint, axial_play

HERE = Path(__file__).resolve().parent
DATA = HERE.parents[1] / "validation" / "reference_fe" / "data"
RPM = 2.0 * pi / 60.0
PER_MM = 10.0**4.5  # N/mm^1.5 to N/m^1.5

CLOSED = "closed form"
TWO = "two codes"
ELEMENTS = "finite elements"
PAPER = "paper"


class Rows(list):
    def add(self, quantity, unit, value, uncertainty, reason, source, counts=True):
        self.append({"quantity": quantity, "unit": unit, "value": float(value), "uncertainty": float(uncertainty),
                     "reason": reason, "source": source, "counts": "yes" if counts else "no"})

    def relative(self, quantity, unit, value, part, reason, source, counts=True):
        self.add(quantity, unit, value, part * abs(value), f"{part:g} of the value: {reason}", source, counts)

    def threads(self, prefix, unit, normal, part=1e-6, source=TWO, reason=None, counts=True, name="thread_load"):
        """Normal forces of screw and nut, threads from 1 at the loaded end of the screw."""
        for body, loads in zip(("screw", "nut"), normal):
            largest = max(abs(np.asarray(loads).ravel()))
            why = f"{part:g} of the largest: {reason or 'rounding and the end of the iteration'}"
            for index, value in np.ndenumerate(np.asarray(loads)):
                place = "_".join(str(i + 1) for i in index)
                self.add(f"{prefix}{name}_{body}_{place}_{unit}", unit, value, part * largest, why, source, counts)


# --- 1: two threads by hand

def case_01(rows):
    rollers, force, p, e = 8, 8000.0, 5e-3 / 3, 209e9
    area = lambda outer, inner: pi / 4 * (outer**2 - inner**2)
    f, cosine = force / rollers, cos(pi / 4)
    k = (3.6e5 * PER_MM, 4.2e5 * PER_MM)
    c_s, c_n, c_r = (p / (e * a) for a in (area(0.021, 0.006) / rollers, area(0.046, 0.035) / rollers, area(0.007, 0)))
    free, behind = 0.010 / p * c_s, 0.010 / p * c_n
    give = lambda load, i: (load / (k[i] * cosine)) ** (2 / 3) / cosine
    # P_1, P_2 = f - P_1 on the screw's threads, Q_1, Q_2 on the nut's: bisection in P_2 within bisection in Q_2.

    def root(function, low=0.0, high=f):
        for _ in range(200):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if function(middle) < 0.0 else (low, middle)
        return 0.5 * (low + high)

    def q_2(p_2):
        return root(lambda q: give(q, 1) - give(f - q, 1) + q * c_n + (q - p_2) * c_r)

    p_2 = root(lambda x: give(x, 0) - give(f - x, 0) + x * c_s - (q_2(x) - x) * c_r)
    q = q_2(p_2)
    why = "bisection to the last digit, other rounding"
    for name, load in (("screw_1", f - p_2), ("screw_2", p_2), ("nut_1", f - q), ("nut_2", q)):
        rows.relative(f"thread_load_{name}_N", "N", load / cosine, 1e-8, why, CLOSED)
    u = f * free + give(f - p_2, 0) + give(f - q, 1) + f * behind
    rows.relative("displacement_um", "um", 1e6 * u, 1e-8, why, CLOSED)
    rows.relative("stiffness_N_per_um", "N/um", 1e-6 * force / u, 1e-8, why, CLOSED)


# --- 2: Hertz contacts

def standard_threads(screw_radius, roller_radius, nut_radius, lead, starts, convex, centre_distance):
    screw = Flank(screw_radius, lead, starts, pi / 4)
    roller = Flank(roller_radius, lead / starts, 1, pi / 4, convex)
    nut = Flank(nut_radius, lead, starts, pi / 4)
    return (TouchPoint(screw, roller, centre_distance, True), TouchPoint(nut, roller, centre_distance, False),
            axial_play(screw, roller, nut, centre_distance))


def case_02(rows):
    *points, play = standard_threads(0.015, 0.005, 0.025, 0.010, 5, 7.07e-3, 0.020)
    modulus, load = effective_modulus(210e9, 0.3, 210e9, 0.3), 200.0
    why = "two solutions of the same equations in double precision agree to 1e-12"
    for body, p, gap in zip(("screw", "nut"), points, play):
        h = Contact(*p.kappa, modulus)
        rows.relative(f"radius_on_{body}_mm", "mm", 1e3 * p.radius_on_body, 1e-9, why, TWO)
        rows.relative(f"radius_on_roller_at_{body}_mm", "mm", 1e3 * p.radius_on_roller, 1e-9, why, TWO)
        rows.relative(f"normal_angle_{body}_deg", "deg", p.normal_angle * 180 / pi, 1e-9, why, TWO)
        for n in (0, 1):
            rows.relative(f"relative_curvature_{n + 1}_{body}_per_mm", "1/mm", 1e-3 * p.kappa[n], 1e-8, why, TWO)
        rows.add(f"axial_play_{body}_mm", "mm", 1e3 * gap, 1e-9, "1e-9 mm: " + why, TWO)
        rows.relative(f"hertz_constant_{body}_N_per_mm1_5", "N/mm^1.5", h.hertz_constant / PER_MM, 1e-8, why, TWO)
        rows.relative(f"semi_major_{body}_mm", "mm", 1e3 * h.major(load), 1e-8, why, TWO)
        rows.relative(f"semi_minor_{body}_mm", "mm", 1e3 * h.minor(load), 1e-8, why, TWO)
        rows.relative(f"approach_{body}_um", "um", 1e6 * h.approach(load), 1e-8, why, TWO)
        rows.relative(f"peak_pressure_{body}_MPa", "MPa", 1e-6 * h.peak_pressure(load), 1e-8, why, TWO)
    for quantity, value in (("printed_radius_on_screw_mm", 15.0351), ("printed_radius_on_roller_at_screw_mm", 5.0177),
                            ("printed_radius_on_nut_mm", 25.0), ("printed_radius_on_roller_at_nut_mm", 5.0)):
        rows.add(quantity, "mm", value, 6e-5, "the last printed digit", PAPER + ": Sandu 2018, table 1.6, example 1")


# --- 3 to 6: sectors

SCREW_A = dict(rollers=11, threads=20, pitch=5e-3 / 3, screw_diameter=0.021, roller_diameter=0.007,
               nut_diameter=0.035, bore=0.006, free_length=0.010, end_length=0.005, end_diameter=0.005,
               nut_length=0.090, nut_outer=0.046, flanges=((0.0, 0.010, 0.062), (0.080, 0.090, 0.062)),
               youngs_modulus=209e9, constant=(3.6062e5 * PER_MM, 4.2140e5 * PER_MM),
               angle=(radians(45.0288), radians(45.0803)))
POSITIONS = {"position_1": 0.0543333333, "position_2": 0.0291666667, "position_3": 0.004}
DIRECTIONS = {"tension": (-1, 0.010), "compression": (1, 0.080)}


def sector_a(position, direction, force=45e3, **changes):
    sense, thrust = DIRECTIONS[direction]
    return Sector(force=force, sense=sense, thrust=thrust, position=POSITIONS[position], **(SCREW_A | changes))


def sector_rows(rows, prefix, sector):
    r = sector.solve()
    why = "rounding and the end of the iteration"
    rows.relative(prefix + "displacement_um", "um", 1e6 * r["displacement"], 1e-6, why, TWO)
    rows.relative(prefix + "stiffness_N_per_um", "N/um", 1e-6 * r["stiffness"], 1e-6, why, TWO)
    rows.threads(prefix, "N", r["normal"])
    return r


def case_03(rows):
    for position in POSITIONS:
        for direction in DIRECTIONS:
            sector_rows(rows, f"{position}_{direction}.", sector_a(position, direction))


def calculix(position, direction, lever, load="45"):
    with open(DATA / "curves.csv") as file:
        for row in csv.DictReader(file):
            if (row["config"], row["direction"], row["guidance"], row["lever"]) == (
                    position[-1], direction, "both_end_nodes", lever) and float(row["load_kN"]) == float(load):
                return row
    raise KeyError(position)


def case_04(rows):
    for direction in DIRECTIONS:
        sector_rows(rows, f"position_2_{direction}.", sector_a("position_2", direction, apart=True))
        row = calculix("position_2", direction, "half_pitch")
        rows.relative(f"real_bodies_position_2_{direction}.displacement_um", "um", float(row["displacement_um"]), 0.002,
                      "mesh 0.0003, the rest what the definition of real bodies leaves open", ELEMENTS, counts=False)


def case_05(rows):
    i = np.arange(20)
    screw = 4e-6 * i / 19
    roller = 1e-6 * np.sin(2 * pi * i / 5)
    nut = 1e-6 * np.array(NUT_ERRORS)
    crowning = -2e-6 * (2 * i / 19 - 1) ** 2
    zero = np.zeros(20)
    for direction in DIRECTIONS:
        s = sector_a("position_2", direction)
        s.gaps = gaps(s.sense, s.angle, (screw, roller, nut), (zero, crowning, zero))
        sector_rows(rows, f"{direction}.", s)


NUT_ERRORS = [0.0, 0.5, -0.3, 0.8, 1.1, 0.2, -0.6, -0.1, 0.4, 0.9, 1.3, 0.7, -0.2, -0.9, 0.1, 0.6, 1.0, -0.4, 0.3, 1.2]


def case_06(rows):
    row = calculix("position_2", "tension", "half_pitch")
    why = "mesh 0.0003, the rest what the definition leaves open (README)"
    rows.relative("displacement_um", "um", float(row["displacement_um"]), 0.002, why, ELEMENTS)
    rows.relative("stiffness_N_per_um", "N/um", float(row["stiffness_N_per_um"]), 0.002, why, ELEMENTS)
    for body in ("screw", "nut"):
        for k in range(1, 21):
            rows.add(f"thread_share_{body}_{k}_percent", "%", float(row[f"{body}_{k}_%"]), 0.1,
                     "0.1 % of the load, a fiftieth of a mean thread: mesh 0.006, the rest the definition",
                     ELEMENTS)


# --- 7 to 11: all rollers

SCREW_B = dict(force=4e3, sense=-1, position=0.010, rollers=5, threads=4, pitch=5e-3 / 3, screw_diameter=0.021,
               roller_diameter=0.007, nut_diameter=0.035, centre_distance=0.014, bore=0.006, free_length=0.010,
               end_length=0.005, end_diameter=0.005, nut_length=0.025, nut_outer=0.046, thrust=0.0,
               youngs_modulus=209e9, constant=(3.17554607333e5 * PER_MM, 3.60564417262e5 * PER_MM),
               angle=(pi / 4, pi / 4))
ALIGNED = []


def mechanism_rows(rows, real=None, **changes):
    if not ALIGNED:
        ALIGNED.append(Mechanism(**SCREW_B).solve())
    r = Mechanism(**(SCREW_B | changes)).solve()
    why = "rounding and the end of the iteration"
    rows.relative("displacement_um", "um", 1e6 * r["displacement"], 1e-6, why, TWO)
    if not changes.get("clamped"):
        rows.add("screw_end_y_um", "um", 1e6 * r["lateral"][0], 1e-4, "1e-4 um: " + why, TWO)
        rows.add("screw_end_rotation_z_mrad", "mrad", 1e3 * r["rotation"][1], 1e-5, "1e-5 mrad: " + why, TWO)
    for i, body in enumerate(("screw", "nut")):
        total = r["normal"][i].sum()
        factor = r["normal"][i].max() / ALIGNED[0]["normal"][i].max()
        rows.relative(f"overload_factor_{body}", "-", factor, 1e-6, why, TWO)
        for j in range(5):
            rows.add(f"roller_share_{body}_{j + 1}_percent", "%", 100 * r["normal"][i][j].sum() / total, 1e-4,
                     "1e-4 %: " + why, TWO)
    rows.threads("", "N", r["normal"])
    if real:
        data = json.loads((DATA / "full_mechanism.json").read_text())
        bar = data["error_bar"][real]
        for body in ("screw", "nut"):
            at = data["finite elements"][real][body]
            rows.add(f"real_bodies.overload_factor_{body}", "-", at["overload_factor"],
                     at["overload_factor"] * max(0.001, bar["overload_factor"]), "mesh", ELEMENTS, counts=False)
            rows.add(f"real_bodies.largest_roller_share_{body}_percent", "%", max(at["roller_share_percent"]),
                     max(0.03, bar["roller_share_percent"]), "mesh", ELEMENTS, counts=False)


def case_07(rows):
    mechanism_rows(rows, tilt=(0.0, radians(0.05)), clamped=True)


def case_08(rows):
    mechanism_rows(rows, "moment", moment=(0.0, 2.0))


def case_09(rows):
    mechanism_rows(rows, "side force", side_force=(60.0, 0.0))


def case_10(rows):
    mechanism_rows(rows, "missing roller", missing=(0,))


def case_11(rows):
    mechanism_rows(rows, "thick roller", diameters=(4e-6, 0.0, 0.0, 0.0, 0.0))


def case_17(rows):
    """The clamped screw with a thick roller, eccentric screw and nut, over two turns."""
    epsilon, steps, turns = 21.0 / (21.0 + 35.0), 12, 2
    why = "rounding and the end of the iteration"
    deviation, loads = [], []
    for k in range(steps * turns + 1):
        theta = 2 * pi * k / steps
        m = Mechanism(**(SCREW_B | dict(
            clamped=True, diameters=(3e-6, 0.0, -1e-6, 2e-6, 0.0), turn=epsilon * theta,
            eccentric=((6e-6, radians(20) + theta), (4e-6, radians(-70))))))
        r = m.solve()
        deviation.append(r["travel"])
        loads.append(r["normal"])
    deviation = np.array(deviation) - np.mean(deviation)
    travel = np.arange(len(deviation)) / (steps * turns)
    slope = np.polyfit(travel, deviation, 1)[0]
    off = deviation - slope * (travel - travel.mean())
    for k, value in enumerate(deviation):
        rows.add(f"deviation_{k}_um", "um", 1e6 * value, 1e-5, "1e-5 um: " + why, TWO)
    rows.add("peak_to_peak_um", "um", 1e6 * np.ptp(deviation), 1e-5, "1e-5 um: " + why, TWO)
    rows.add("mean_travel_deviation_um", "um", 1e6 * slope, 1e-5, "1e-5 um: " + why, TWO)
    rows.add("variation_um", "um", 1e6 * np.ptp(off), 1e-5, "1e-5 um: " + why, TWO)
    loads = np.array(loads)
    for i, body in enumerate(("screw", "nut")):
        rows.relative(f"largest_thread_load_{body}_N", "N", loads[:, i].max(), 1e-6, why, TWO)
        rows.relative(f"least_thread_load_{body}_N", "N", loads[:, i].min(), 1e-6, why, TWO)
        mean = loads[:, i].mean(axis=0)
        for j in range(5):
            rows.relative(f"mean_thread_load_{body}_{j + 1}_1_N", "N", mean[j, 0], 1e-6, why, TWO)


def case_18(rows):
    """The clamped screw with a mass at its loaded section and unequal rollers."""
    m = Mechanism(**(SCREW_B | dict(clamped=True, diameters=(3e-6, 0.0, -1e-6, 2e-6, 0.0), density=7810.0,
                                    load_mass=5.0)))
    m.solve()
    omega, shapes, mass = m.frame.modes()
    along = np.zeros(m.frame.count)
    along[m.frame.axial] = 1.0
    why = "rounding"
    rows.relative("mass_x_kg", "kg", along @ mass @ along, 1e-7, why, TWO)
    part = shapes.T @ mass @ along
    for k in range(10):
        rows.relative(f"frequency_{k + 1}_Hz", "Hz", omega[k] / (2 * pi), 1e-6, why, TWO)
        rows.add(f"effective_mass_x_{k + 1}_kg", "kg", part[k] ** 2, 1e-8, "1e-8 kg: " + why, TWO)


DRIVE = dict(lead=0.005, constant=flank_constant(5, 4, (1.004195841e10, 1.140204802e10), 45.0), play=20e-6, mass=20.0,
             screw_inertia=1e-4, motor_inertia=2e-4, stiffness=900.0, damping=0.02, beta=20e-6,
             friction=(40.0, 0.1, 0.05), torque=((0.0, 2.0), (0.020, -2.0), (0.035, 0.0)), force=30.0,
             samples=(0.010, 0.020, 0.030, 0.040, 0.050, 0.060))


def case_19(rows):
    """A step of torque, a reversal through the play, rest."""
    drive, part, why = Drive(**DRIVE).run(), 1e-5, "events and rounding"
    for k, y in enumerate(drive.sampled):
        rows.relative(f"position_{k + 1}_mm", "mm", 1e3 * y[X], part, why, TWO)
        if k < 3:
            rows.relative(f"screw_speed_{k + 1}_rpm", "rpm", y[OMEGA] / RPM, part, why, TWO)
    for k, (time, _, speed, force) in enumerate(drive.impacts, 1):
        rows.relative(f"impact_{k}_time_ms", "ms", 1e3 * time, part, why, TWO)
        rows.relative(f"impact_{k}_speed_mm_per_s", "mm/s", 1e3 * speed, part, why, TWO)
        rows.relative(f"impact_{k}_largest_force_N", "N", force, part, why, TWO)
    for sense, name in ((1, "tension"), (-1, "compression")):
        rows.relative(f"largest_{name}_N", "N", drive.peak[sense][1], part, why, TWO)
    rows.relative("lost_motion_um", "um", 1e6 * sum(drive.lag), part, why, TWO)
    energies = dict(zip(SUMS, drive.end[6:]))
    rows.relative("rms_torque_Nm", "N m", sqrt(energies.pop("torque_squared") / drive.samples[-1]), part, why, TWO)
    for name, value in energies.items():
        rows.relative(f"energy_{name}_J", "J", value, part, why, TWO)
    rows.relative("energy_stored_J", "J", drive.stored(drive.end), part, why, TWO)


# --- 12 to 15: the screw turns

def screw_c(lead=0.010, roller_count=9, threads=28, force=35e3, speed=400.0, law=None, radius=0.01494):
    *points, _ = standard_threads(radius, 0.005, 0.025, lead, 5, 6e-3, 0.020)
    each = force / roller_count / threads
    return Slip(tuple(points), 0.020, lead, 0.2, roller_count, speed * RPM, force, law,
                effective_modulus(210e9, 0.3, 210e9, 0.3), loads=([each] * threads, [each] * threads))


GREASE = Oil(0.1665, 30e-9, 12e6)


def slip_rows(rows, prefix, r, part=1e-7):
    why = "the root to the last digit, other rounding"
    power = sum(r["power"])
    rows.relative(prefix + "slip_ratio", "-", r["ratio"], 1e-9, why, TWO)
    rows.relative(prefix + "ideal_slip_ratio", "-", r["ideal"], 1e-9, why, CLOSED)
    rows.relative(prefix + "power_loss_W", "W", power, part, why, TWO)
    rows.relative(prefix + "power_loss_screw_contacts_W", "W", r["power"][0], part, why, TWO)
    rows.relative(prefix + "torque_on_screw_Nm", "N m", r["torque"], part, why, TWO)
    if r["efficiency"] is not None:
        rows.relative(prefix + "efficiency", "-", r["efficiency"], part, why, TWO)
    # Power in less power out is lost: a check of the reference itself.
    assert abs(r["shaft"] + r["load"] - power) < 1e-7 * power


def case_12(rows):
    laws = {"coulomb": Law(coefficient=0.1), "film": Law(oil=GREASE),
            "mixed": Law(coefficient=0.11, oil=GREASE, roughness=0.2e-6 * sqrt(2.0))}
    why = "other rounding"
    for name, law in laws.items():
        r = screw_c(law=law).solve()
        slip_rows(rows, name + ".", r)
        for i, body in enumerate(("screw", "nut")):
            rows.relative(f"{name}.dynamic_normal_load_{body}_N", "N", r["normal"][i][0], 1e-7, why, TWO)
            rows.relative(f"{name}.mean_friction_{body}", "-", r["patch"][i][0]["mean"], 1e-7, why, TWO)
            if name != "coulomb":
                rows.relative(f"{name}.film_{body}_nm", "nm", 1e9 * r["patch"][i][0]["film"], 1e-7, why, TWO)
            if name == "mixed":
                rows.relative(f"mixed.central_film_{body}_nm", "nm", 1e9 * r["patch"][i][0]["central"], 1e-7, why, TWO)
                rows.relative(f"mixed.film_ratio_{body}", "-", r["patch"][i][0]["film_ratio"], 1e-7, why, TWO)


def case_13(rows):
    slip_rows(rows, "screw_drives.", screw_c(force=20e3, law=Law(coefficient=0.1)).solve())
    slip_rows(rows, "load_drives.", screw_c(force=20e3, speed=-400.0, law=Law(coefficient=0.1)).solve())
    slip_rows(rows, "self_locking.", screw_c(lead=0.5e-3, force=20e3, speed=-400.0, law=Law(coefficient=0.3),
                                                radius=0.015).solve())


def case_14(rows):
    *points, _ = standard_threads(0.01247, 0.025 / 6, 0.125 / 6, 0.005, 5, 5e-3, 0.05 / 3)
    modulus = effective_modulus(210e9, 0.3, 210e9, 0.3)
    sector = Sector(force=6e3, sense=-1, position=0.012, rollers=11, threads=10, pitch=1e-3, screw_diameter=0.02494,
                    roller_diameter=0.025 / 3, nut_diameter=0.125 / 3, bore=0.0, free_length=0.012, end_length=0.005,
                    end_diameter=0.007, nut_length=0.034, nut_outer=0.054, thrust=0.0, youngs_modulus=210e9,
                    constant=tuple(Contact(*p.kappa, modulus).hertz_constant for p in points),
                    angle=tuple(p.normal_angle for p in points))
    sector_rows(rows, "at_rest.", sector)
    for name, sense in (("screw_drives", 1.0), ("load_drives", -1.0)):
        state, slip = running.solve(sector, dict(
            points=tuple(points), centre_distance=0.05 / 3, lead=0.005, gear_ratio=0.2, rollers=11,
            speed=sense * 1000 * RPM, force=6e3, law=Law(coefficient=0.1), modulus=modulus))
        rows.relative(name + ".displacement_um", "um", 1e6 * state["displacement"], 1e-6, "end of the iteration", TWO)
        rows.threads(name + ".", "N", state["normal"])
        slip_rows(rows, name + ".", slip, 1e-6)


def walther(celsius, intercept=9.0, slope=3.5, density=890.0):
    """Dynamic viscosity [Pa s] by ASTM D341."""
    return (10 ** 10 ** (intercept - slope * log10(celsius + 273.15)) - 0.7) * 1e-6 * density


def case_15(rows):
    g = {"sa": 2.0, "na": 4.0, "sr": 15.0, "rn": 20.0}
    matrix = np.array([[g["sa"] + g["sr"], -g["sr"], 0.0], [-g["sr"], g["sr"] + g["rn"], -g["rn"]],
                       [0.0, -g["rn"], g["na"] + g["rn"]]])

    def temperatures(power):
        heat = np.array([power[0] / 2, (power[0] + power[1]) / 2, power[1] / 2])
        return heat, 25.0 + np.linalg.solve(matrix, heat)

    def losses(t):
        """Each interface has the oil of its own mean temperature."""
        model = screw_c(force=20e3, speed=200.0, law=None)
        laws = [Law(oil=Oil(walther(0.5 * (a + b)), 24e-9, 12e6)) for a, b in ((t[0], t[1]), (t[1], t[2]))]
        original = model.patch
        model.patch = lambda i, n_0, ratio: (setattr(model, "law", laws[i]), original(i, n_0, ratio))[1]
        return model.solve()

    t = np.full(3, 45.0)
    for _ in range(60):
        r = losses(t)
        heat, new = temperatures(r["power"])
        done = np.abs(new - t).max() < 1e-10
        t = new
        if done:
            break
    why = "1e-5 K: end of both iterations"
    for name, value in zip(("screw", "rollers", "nut"), t):
        rows.add(f"film.temperature_{name}_degC", "degC", value, 1e-5, why, TWO)
    for name, value in zip(("screw", "rollers", "nut"), heat):
        rows.relative(f"film.heat_{name}_W", "W", value, 1e-5, "end of both iterations", TWO)
    rows.relative("film.efficiency", "-", r["efficiency"], 1e-6, "end of both iterations", TWO)
    dry = screw_c(force=20e3, speed=200.0, law=Law(coefficient=0.1)).solve()
    heat, t = temperatures(dry["power"])
    for name, value in zip(("screw", "rollers", "nut"), t):
        rows.add(f"coulomb.temperature_{name}_degC", "degC", value, 1e-5, "1e-5 K: rounding", CLOSED)


# --- 16: life

def lemor(psi, rollers=11, threads=20, p=5.0 / 3, d_s=21.0, d_r=7.0, d_n=35.0, lead=5.0):
    """C_a [N] of Lemor in Jung 2017, (6.1) to (6.3), (8.26), (8.27); mm."""
    alpha = pi / 2 - psi
    ratio = d_r * cos(alpha) / d_n
    f_c = np.polyval([-5394384948.0, 8851856787.0, -6308725579.0, 2564041511.0, -656422710.5, 110470028.7,
                      -12407228.47, 931488.7454, -47724.95951, 1892.829727, 26.98514873], ratio)
    d_c = sqrt(2.5 * p * sqrt(2.0) * d_r)
    beta = atan(lead / (pi * d_s))
    return f_c * cos(alpha) ** 0.86 * (rollers * threads) ** (2 / 3) * d_c**1.8 * tan(alpha) * cos(beta) ** (1 / 3)


def case_16(rows):
    spectrum = [(20e3, "tension", 3e5), (12e3, "tension", 1e6), (8e3, "compression", 2e6)]
    psi = 0.5 * sum(SCREW_A["angle"])
    c_a, total, e = lemor(psi), sum(n for *_, n in spectrum), 10.0 / 9.0
    rows.relative("dynamic_capacity_N", "N", c_a, 1e-9, "rounding", CLOSED)
    mean = (sum(f**3 * n for f, _, n in spectrum) / total) ** (1 / 3)
    rows.relative("mean_load_N", "N", mean, 1e-9, "rounding", CLOSED)
    rows.relative("life_by_mean_load_revolutions", "revolutions", 1e6 * (c_a / mean) ** 3, 1e-9, "rounding", CLOSED)
    flank = {d: (sum(f**3 * n for f, way, n in spectrum if way == d) / total) ** (1 / 3) for d in DIRECTIONS}
    combine = lambda lives: sum(x**-e for x in lives) ** (-1 / e)
    rows.relative("life_equal_threads_revolutions", "revolutions",
                  combine([1e6 * (c_a / f) ** 3 for f in flank.values()]), 1e-9, "rounding", CLOSED)
    gamma = 7.0 * cos(pi / 2 - psi) / 28.0
    lam = ((1 - gamma) / (1 + gamma)) ** 1.72
    w = [1 / (1 + lam ** (10 / 3)), 1 - 1 / (1 + lam ** (10 / 3))]
    rows.relative("failure_share_screw", "-", w[0], 1e-9, "rounding", CLOSED)
    why = "thread loads of two codes; three equilibria here, interpolation to 1e-8 there"
    lives = {d: [] for d in DIRECTIONS}
    for direction in DIRECTIONS:
        shares = []
        for f, way, n in spectrum:
            if way == direction:
                s = sector_a("position_2", direction, force=f)
                r = s.solve()
                shares.append((f, n, [20 * np.asarray(r["normal"][i]) * cos(s.angle[i]) / (f / 11) for i in (0, 1)]))
        for i, body in enumerate(("screw", "nut")):
            load = (sum(n * (f * l[i]) ** 3 for f, n, l in shares) / total) ** (1 / 3)
            life = (20 / w[i]) ** (1 / e) * 1e6 * (c_a / load) ** 3
            lives[direction] += list(life)
            for k in (0, 19):
                rows.relative(f"{direction}.thread_life_{body}_{k + 1}_revolutions", "revolutions", life[k], 1e-5, why,
                              TWO)
    for direction in DIRECTIONS:
        rows.relative(f"{direction}.life_revolutions", "revolutions", combine(lives[direction]), 1e-5, why, TWO)
    rows.relative("life_revolutions", "revolutions", combine(lives["tension"] + lives["compression"]), 1e-5, why, TWO)
    rows.relative("weakest_thread_life_revolutions", "revolutions", min(lives["tension"] + lives["compression"]), 1e-5,
                  why, TWO)


# --- 20: three published axes

AXES = {"horizontal": dict(mass=80.0, mu=0.003, resistance=15.0, speed=1.0, ramp=0.15, steady=0.85, up=0.0, lead=0.010,
                           capacity=100e3, printed=(550.0, 17.0, -516.0)),
        "vertical": dict(mass=50.0, mu=0.0, resistance=20.0, speed=0.3, ramp=0.2, steady=1.8, up=1.0, lead=0.010,
                         capacity=100e3, printed=(585.0, 510.0, 435.0)),
        "vertical_light": dict(mass=30.0, mu=0.0, resistance=10.0, speed=0.3, ramp=0.125, steady=1.0, up=1.0,
                               lead=0.010, capacity=100e3, printed=(376.0, 304.0, 232.0))}


def axis_forces(a, g=9.80665):
    """Forces of the six moves: ramp up, steady, ramp down, there and back."""
    forces, accelerate = [], a["speed"] / a["ramp"]
    for way in (1.0, -1.0):
        friction = way * (a["mu"] * a["mass"] * g * (1.0 - a["up"]) + a["resistance"])
        for part in (1.0, 0.0, -1.0):
            forces.append(a["mass"] * (way * part * accelerate + g * a["up"]) + friction)
    return forces


def case_20(rows):
    moves = ("accelerate", "travel", "brake", "accelerate_back", "travel_back", "brake_back")
    for name, a in AXES.items():
        forces = axis_forces(a)
        travel = [a["speed"] * a["ramp"] / 2, a["speed"] * a["steady"], a["speed"] * a["ramp"] / 2] * 2
        for move, force in zip(moves, forces):
            rows.add(f"{name}.axial_force_{move}_N", "N", force, 1e-6, "1e-6 N: rounding", CLOSED)
        for move, printed in zip(moves, a["printed"]):
            rows.add(f"{name}.printed_axial_force_{move}_N", "N", printed, 1.0,
                     "1 N: printed to 1 N, some digits cut, with g = 9.8 m/s^2 in place of 9.80665",
                     PAPER + ": THK general catalogue, axial loads of ball screws")
        mean = (sum(abs(f) ** 3 * s for f, s in zip(forces, travel)) / sum(travel)) ** (1 / 3)
        rows.relative(f"{name}.mean_load_N", "N", mean, 1e-9, "rounding", CLOSED)
        cycle = 2 * (2 * a["ramp"] + a["steady"]) + 0.5
        v, t = a["speed"], a["ramp"]
        rms = sqrt(2 * (v * v * a["steady"] + 2 * v * v * t / 3) / cycle)
        rows.relative(f"{name}.rms_speed_mm_per_s", "mm/s", 1e3 * rms, 1e-9, "rounding", CLOSED)
        life = 1e6 * (a["capacity"] / mean) ** 3
        rows.relative(f"{name}.life_revolutions", "revolutions", life, 1e-9, "rounding", CLOSED)
        rows.relative(f"{name}.life_hours", "h", life * a["lead"] / sum(travel) * cycle / 3600, 1e-9, "rounding", CLOSED)
        for move, force, way in zip(moves, forces, (1, 1, 1, -1, -1, -1)):
            torque = abs(force) * a["lead"] / (2 * pi)
            torque = torque / 0.8 if force * way > 0 else -torque * 0.75
            rows.relative(f"{name}.torque_{move}_Nm", "N m", torque, 1e-9, "rounding", CLOSED)
        holding = a["mass"] * 9.80665 * a["up"] * a["lead"] / (2 * pi)
        rows.add(f"{name}.holding_torque_Nm", "N m", holding, 1e-9, "1e-9 N m: rounding", CLOSED)
