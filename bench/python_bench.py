"""What Python adds to the engine, against the same work in prs_bench, in turns.

    python bench/python_bench.py [build/bench/bench/prs_bench]

From the top of the repository, with rollerscrew installed and the bench preset built.
"""

import json
import statistics
import subprocess
import sys
import time
from collections.abc import Callable

import numpy as np
import rollerscrew as rs

ROUNDS = 7
DESIGNS = 100_000
THREADS = 2


def engine_times(program: str) -> dict[str, float]:
    """Seconds an iteration of each benchmark."""
    command = [
        program,
        "--benchmark_filter=^(RunContact|RunSolve|FullChainComputed/200000/real_time)$",
        "--benchmark_format=json",
    ]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3}
    return {
        run["name"]: run["real_time"] * unit[run["time_unit"]]
        for run in json.loads(output)["benchmarks"]
    }


def seconds(call: Callable[[], object], least: float = 0.5) -> float:
    """Of one call, the mean over at least so many seconds."""
    calls, start = 0, time.perf_counter()
    while (spent := time.perf_counter() - start) < least:
        call()
        calls += 1
    return spent / calls


def designs_call() -> Callable[[], object]:
    """The designs of FullChainComputed as arrays."""
    case = rs.Case.from_text(
        subprocess.run(
            ["sed", "-n", '/R"(mechanism/,/)";/p', "tests/prs/input/abevi.h"],
            check=True,
            capture_output=True,
            text=True,
        )
        .stdout.split('R"(')[1]
        .split(')"')[0]
    )
    random = np.random.default_rng(1)

    def within(value: float, unit: str) -> tuple[np.ndarray, str]:
        return value * random.uniform(0.97, 1.03, DESIGNS), unit

    inputs = {
        "mechanism.flank_angle": within(45, "deg"),
        "mechanism.profile.roller.convex": within(4.949747468, "mm"),
        "structure.nut.outer_diameter": within(46, "mm"),
        "structure.screw.bore": within(6, "mm"),
        "materials.youngs_modulus": within(209, "GPa"),
        "load_cases[0].axial_force": (np.exp(random.uniform(-0.8, 3.8, DESIGNS)), "kN"),
    }
    responses = [
        "axial_displacement_um",
        "axial_stiffness_N_per_um",
        "screw.load_rate_percent.max",
        "nut.load_rate_percent.max",
        "screw.peak_pressure_MPa.max",
        "nut.peak_pressure_MPa.max",
    ]
    return lambda: case.evaluate(inputs, responses, threads=THREADS)


def main() -> None:
    program = sys.argv[1] if len(sys.argv) > 1 else "build/bench/bench/prs_bench"
    contact = rs.Case.from_yaml("configs/08_design_by_backlash.yaml")
    solve = rs.Case.from_yaml("configs/05_standard_screw.yaml")
    evaluate = designs_call()
    added: dict[str, list[float]] = {"contact": [], "solve": []}
    ratio: list[float] = []
    for _ in range(ROUNDS):
        engine = engine_times(program)
        added["contact"].append(seconds(contact.contact) - engine["RunContact"])
        added["solve"].append(seconds(solve.solve) - engine["RunSolve"])
        per_design = engine["FullChainComputed/200000/real_time"] / 200_000
        ratio.append(seconds(evaluate) / DESIGNS / per_design)
    for name, values in added.items():
        low, high = min(values) * 1e6, max(values) * 1e6
        median = statistics.median(values) * 1e6
        print(f"{name}: {median:.1f} us a call above the engine ({low:.1f} to {high:.1f})")
    print(
        f"{DESIGNS} designs as arrays: {statistics.median(ratio):.3f} of the study engine's time "
        f"({min(ratio):.3f} to {max(ratio):.3f})"
    )


if __name__ == "__main__":
    main()
