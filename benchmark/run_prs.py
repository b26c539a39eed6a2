#!/usr/bin/env python3
"""This program's numbers in the benchmark's names: run_prs.py PRS [NN ..] [--output results.csv] [--model refined]

PRS is the program. Case 06 takes about ten seconds where its matrices are not kept from an earlier run;
`--model refined` takes the one-dimensional refined model there instead.
"""
import argparse
import csv
import json
import subprocess
from pathlib import Path

BENCHMARK = Path(__file__).resolve().parent


class Program:
    def __init__(self, prs, model):
        self.prs, self.model = prs, model

    def __call__(self, command, folder, *settings, file="case.yaml"):
        argv = [self.prs, command, str(folder / file), "--json", "--quiet"]
        for setting in settings:
            argv += ["--set", setting]
        done = subprocess.run(argv, capture_output=True, text=True)
        if done.returncode not in (0, 1):
            raise SystemExit(f"{' '.join(argv)}: status {done.returncode}\n{done.stderr}")
        return json.loads(done.stdout)


def threads(values, prefix, body, result, key="normal_load_N", name="thread_load", unit="N"):
    for i, value in enumerate(result[body][key]):
        if isinstance(value, list):
            for k, of_roller in enumerate(value):
                values[f"{prefix}{name}_{body}_{i + 1}_{k + 1}_{unit}"] = of_roller
        else:
            values[f"{prefix}{name}_{body}_{i + 1}_{unit}"] = value


def sector(values, prefix, result):
    values[prefix + "displacement_um"] = result["axial_displacement_um"]
    values[prefix + "stiffness_N_per_um"] = result["axial_stiffness_N_per_um"]
    for body in ("screw", "nut"):
        threads(values, prefix, body, result)


def slip(values, prefix, result):
    s = result["slip"]
    for name, key in (("slip_ratio", "slip_ratio"), ("ideal_slip_ratio", "ideal_slip_ratio"),
                      ("power_loss_W", "power_loss_W"), ("torque_on_screw_Nm", "torque_screw_Nm"),
                      ("efficiency", "efficiency")):
        if key in s:
            values[prefix + name] = s[key]
    values[prefix + "power_loss_screw_contacts_W"] = s["power_loss_W"] * s["share_percent"]["screw"] / 100


def case_01(run, folder):
    result = run("solve", folder)["load_cases"][0]
    values = {}
    sector(values, "", result)
    return values


def case_02(run, folder):
    contact, values = run("contact", folder)["contact"], {}
    for body in ("screw", "nut"):
        c = contact[body]
        values[f"radius_on_{body}_mm"] = values[f"printed_radius_on_{body}_mm"] = c["radius_on_body_mm"]
        for prefix in ("", "printed_"):
            values[f"{prefix}radius_on_roller_at_{body}_mm"] = c["radius_on_roller_mm"]
        values[f"normal_angle_{body}_deg"] = c["normal_angle_deg"]
        for n in (0, 1):
            values[f"relative_curvature_{n + 1}_{body}_per_mm"] = c["relative_curvatures_per_mm"][n]
        values[f"axial_play_{body}_mm"] = c["backlash_mm"]
        k = c["hertz_constant_N_per_mm1_5"]
        a, b = (c[f"semi_{axis}_mm_per_N1_3"] * 200 ** (1 / 3) for axis in ("major", "minor"))
        values[f"hertz_constant_{body}_N_per_mm1_5"] = k
        values[f"semi_major_{body}_mm"], values[f"semi_minor_{body}_mm"] = a, b
        values[f"approach_{body}_um"] = 1e3 * (200 / k) ** (2 / 3)
        values[f"peak_pressure_{body}_MPa"] = 3 * 200 / (2 * 3.141592653589793 * a * b)
    return values


def sectors(run, folder):
    values = {}
    for result in run("solve", folder)["load_cases"]:
        sector(values, result["name"] + ".", result)
    return values


def case_04(run, folder):
    values = sectors(run, folder)
    for direction in ("tension", "compression"):
        name = f"position_2_{direction}.displacement_um"
        values["real_bodies_" + name] = values[name]
    return values


def case_06(run, folder):
    result, values = run("solve", folder, f"model.bodies={run.model}")["load_cases"][0], {}
    values["displacement_um"] = result["axial_displacement_um"]
    values["stiffness_N_per_um"] = result["axial_stiffness_N_per_um"]
    for body in ("screw", "nut"):
        threads(values, "", body, result, "load_rate_percent", "thread_share", "percent")
    return values


def full(run, folder):
    result, values = run("solve", folder)["load_cases"][0], {}
    values["displacement_um"] = result["axial_displacement_um"]
    values["screw_end_y_um"] = result["screw_end"]["displacement_um"][1]
    values["screw_end_rotation_z_mrad"] = result["screw_end"]["rotation_mrad"][1]
    for body in ("screw", "nut"):
        shares = result[body]["roller_share_percent"]
        for prefix in ("", "real_bodies."):
            values[f"{prefix}overload_factor_{body}"] = result[body]["overload_factor"]
        values[f"real_bodies.largest_roller_share_{body}_percent"] = max(shares)
        for j, share in enumerate(shares):
            values[f"roller_share_{body}_{j + 1}_percent"] = share
        threads(values, "", body, result)
    return values


def case_12(run, folder):
    values = {}
    for name, law in (("coulomb", "{coulomb: 0.1}"), ("film", "{model: jacod}"),
                      ("mixed", "{mixed: {boundary: 0.11, exponent: 2}}")):
        result = run("slip", folder, f"friction={law}")["load_cases"][0]
        slip(values, name + ".", result)
        for body in ("screw", "nut"):
            s = result["slip"][body]
            for quantity, key in (("dynamic_normal_load_{}_N", "dynamic_normal_load_N"),
                                  ("mean_friction_{}", "friction_coefficient"), ("film_{}_nm", "film_thickness_nm"),
                                  ("central_film_{}_nm", "central_film_nm"), ("film_ratio_{}", "film_ratio")):
                values[f"{name}.{quantity.format(body)}"] = s[key][0]
    return values


def case_13(run, folder):
    values = {}
    for result in run("slip", folder)["load_cases"]:
        slip(values, result["name"] + ".", result)
    slip(values, "self_locking.", run("slip", folder, "mechanism.lead=0.5 mm",
                                      "mechanism.pitch_diameter.screw=30 mm", "friction={coulomb: 0.3}")["load_cases"][1])
    return values


def case_14(run, folder):
    values = {}
    sector(values, "at_rest.", run("slip", folder, "model.loads=static")["load_cases"][0])
    for result in run("slip", folder)["load_cases"]:
        prefix = result["name"] + "."
        sector(values, prefix, result)
        slip(values, prefix, result)
    return values


def case_15(run, folder):
    values = {}
    for prefix, law in (("film.", "{model: jacod}"), ("coulomb.", "{coulomb: 0.1}")):
        result = run("slip", folder, f"friction={law}")["load_cases"][0]
        for part in ("screw", "rollers", "nut"):
            values[f"{prefix}temperature_{part}_degC"] = result["heat"]["temperature_degC"][part]
            values[f"{prefix}heat_{part}_W"] = result["heat"]["heat_W"][part]
        slip(values, prefix, result)
    return values


def case_16(run, folder):
    life = run("life", folder)["life"]
    values = {"dynamic_capacity_N": life["capacity"]["dynamic_capacity_N"],
              "mean_load_N": life["loads"]["mean_load_N"],
              "life_by_mean_load_revolutions": life["catalogue"]["l10_revolutions"],
              "life_equal_threads_revolutions": life["equal_shares"]["l10_revolutions"],
              "failure_share_screw": life["capacity"]["failure_share"]["screw"],
              "life_revolutions": life["system"]["l10_revolutions"],
              "weakest_thread_life_revolutions": life["weakest_thread"]["l10_revolutions"]}
    for direction in ("tension", "compression"):
        values[f"{direction}.life_revolutions"] = life[direction]["l10_revolutions"]
        for body in ("screw", "nut"):
            threads(values, direction + ".", body, life[direction], "l10_revolutions", "thread_life", "revolutions")
    return values


def case_17(run, folder):
    travel, values = run("solve", folder)["load_cases"][0]["travel"], {}
    for k, value in enumerate(travel["deviation_um"]):
        values[f"deviation_{k}_um"] = value
    for key in ("peak_to_peak_um", "mean_travel_deviation_um", "variation_um"):
        values[key] = travel[key]
    for body in ("screw", "nut"):
        loads = travel[body]
        for name in ("largest", "least"):
            values[f"{name}_thread_load_{body}_N"] = loads[f"{name}_normal_load_N"]
        for j, of_roller in enumerate(loads["mean_normal_load_N"], 1):
            values[f"mean_thread_load_{body}_{j}_1_N"] = of_roller[0]
    return values


def case_18(run, folder):
    modes = run("solve", folder)["load_cases"][0]["modes"]
    values = {"mass_x_kg": modes["mass_kg"]["x"]}
    for k, mode in enumerate(modes["mode"], 1):
        values[f"frequency_{k}_Hz"] = mode["frequency_Hz"]
        values[f"effective_mass_x_{k}_kg"] = mode["effective_mass_kg"]["x"]
    return values


def case_19(run, folder):
    response, values = run("response", folder)["response"], {}
    for k, position in enumerate(response["position_mm"][1:], 1):
        values[f"position_{k}_mm"] = position
    for k in (1, 2, 3):
        values[f"screw_speed_{k}_rpm"] = response["screw_speed_rpm"][k]
    for k, impact in enumerate(response["impacts"], 1):
        for name, factor, key in (("time_ms", 1e3, "time_s"), ("speed_mm_per_s", 1.0, "speed_mm_per_s"),
                                  ("largest_force_N", 1.0, "largest_force_N")):
            values[f"impact_{k}_{name}"] = factor * impact[key]
    for sense in ("tension", "compression"):
        values[f"largest_{sense}_N"] = response["largest"][sense]["force_N"]
    values["lost_motion_um"] = response["lost_motion_um"]
    values["rms_torque_Nm"] = response["rms_motor_torque_Nm"]
    energy = response["energy_J"]
    lost = {key: energy["lost"][key] for key in ("screw_friction", "motor_friction", "load_friction", "coupling", "contact")}
    for key, value in ({"motor": energy["motor"], "load": energy["load"], "stored": energy["stored_end"]} | lost).items():
        values[f"energy_{key}_J"] = value
    return values


def case_20(run, folder):
    values = {}
    for axis, file in (("horizontal", "case.yaml"), ("vertical", "case_vertical.yaml"),
                       ("vertical_light", "case_vertical_light.yaml")):
        document = run("size", folder, file=file)
        needed, screw = document["requirement"], document["candidates"][0]
        for segment in needed["segments"]:
            for prefix in ("", "printed_"):
                values[f"{axis}.{prefix}axial_force_{segment['name']}_N"] = segment["axial_force_N"]
        for segment in screw["segments"]:
            values[f"{axis}.torque_{segment['name']}_Nm"] = segment["torque_Nm"]
        values[f"{axis}.mean_load_N"] = needed["mean_load_N"]
        values[f"{axis}.rms_speed_mm_per_s"] = needed["rms_speed_mm_per_s"]
        values[f"{axis}.life_revolutions"] = screw["life_revolutions"]
        values[f"{axis}.life_hours"] = screw["life_hours"]
        values[f"{axis}.holding_torque_Nm"] = screw["holding_torque_Nm"]
    return values


CASES = {"01": case_01, "02": case_02, "03": sectors, "04": case_04, "05": sectors, "06": case_06, "07": full,
         "08": full, "09": full, "10": full, "11": full, "12": case_12, "13": case_13, "14": case_14, "15": case_15,
         "16": case_16, "17": case_17, "18": case_18, "19": case_19, "20": case_20}


def expected(folder):
    with open(folder / "expected.csv", newline="") as file:
        return list(csv.DictReader(file))


def results(prs, numbers=(), model="influence"):
    """Rows (case, quantity, value, unit) of what each case asks for."""
    run, rows = Program(prs, model), []
    for folder in sorted(BENCHMARK.glob("[0-9][0-9]_*")):
        number = folder.name[:2]
        if numbers and number not in numbers:
            continue
        values = CASES[number](run, folder)
        for row in expected(folder):
            if row["quantity"] in values:
                rows.append((number, row["quantity"], values[row["quantity"]], row["unit"]))
    return rows


def write(rows, path):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("case", "quantity", "value", "unit"))
        writer.writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("prs")
    parser.add_argument("numbers", nargs="*", help="cases, all by default")
    parser.add_argument("--output", default="results.csv")
    parser.add_argument("--model", choices=("influence", "refined"), default="influence", help="of case 06")
    given = parser.parse_args()
    write(results(given.prs, given.numbers, given.model), given.output)


if __name__ == "__main__":
    main()
