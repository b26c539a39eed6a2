"""What Python adds to the engine, against the same work in prs_bench, in turns.

    python bench/python_bench.py [build/release/bench/prs_bench]

From the top of the repository, with rollerscrew installed and prs_bench built.
"""

import json
import re
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import rollerscrew as rs

ROUNDS = 7
DESIGNS = 100_000
FEWER = 10_000  #: Designs of `f(x)` in one call.
THREADS = 2


def engine_times(program: str, names: str, time: str) -> dict[str, float]:
    """Seconds an iteration of each benchmark, `real_time` or `cpu_time` of all threads."""
    command = [
        program,
        f"--benchmark_filter=^({names})$",
        "--benchmark_format=json",
    ]
    output = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3}
    return {
        run["name"].partition("/")[0]: run[time] * unit[run["time_unit"]]
        for run in json.loads(output)["benchmarks"]
    }


def seconds(call: Callable[[], object], least: float = 0.5) -> float:
    """Of one call, the mean over at least so many seconds."""
    calls, start = 0, time.perf_counter()
    while (spent := time.perf_counter() - start) < least:
        call()
        calls += 1
    return spent / calls


def cpu_seconds(call: Callable[[], object], calls: int) -> float:
    """CPU time of one call, of all threads."""
    start = time.process_time()
    for _ in range(calls):
        call()
    return (time.process_time() - start) / calls


def of_function(program: str) -> None:
    """`f(x)` of lesson 1 against the same plan in C++: one design, and many against a study.

    The solve inside is DesignEngine::evaluate of that design by its values, as the binding calls
    it. A single design is answered by a batch of which only one lane is used, so that it costs
    several times what it does among others; both are printed.
    """
    f = rs.lesson(1).function(
        ["load_cases[0].axial_force", "materials.youngs_modulus"],
        ["axial_stiffness_N_per_um", "screw.peak_pressure_MPa.max"],
    )
    random = np.random.default_rng(1)
    many = np.column_stack([random.uniform(40e3, 50e3, FEWER), random.uniform(200e3, 220e3, FEWER)])
    one: list[float] = []
    all_: list[float] = []
    inside: list[float] = []
    among: list[float] = []
    for _ in range(ROUNDS):
        engine = engine_times(program, "FunctionOfOneDesign|FunctionAsStudy/.*", "cpu_time")
        inside.append(engine["FunctionOfOneDesign"])
        among.append(engine["FunctionAsStudy"] / FEWER)
        one.append(cpu_seconds(lambda: f(f.x0), 20_000) / inside[-1])
        all_.append(cpu_seconds(lambda: f(many), 20) / engine["FunctionAsStudy"])
    for what, ratios in (
        ("f(x) of one design: {} of the CPU time inside", one),
        (f"f(x) of {FEWER} designs: {{}} of the study engine's CPU time", all_),
    ):
        told = f"{statistics.median(ratios):.3f} ({min(ratios):.3f} to {max(ratios):.3f})"
        print(what.format(told))
    print(
        f"inside: one design alone {statistics.median(inside) * 1e6:.1f} us, "
        f"among {FEWER} {statistics.median(among) * 1e6:.1f} us"
    )


def designs_call() -> Callable[[], object]:
    """The designs of FullChainComputed as arrays."""
    header = Path("tests/prs/input/abevi.h").read_text(encoding="utf-8")
    parts = re.findall(r'R"\((.*?)\)"', header, re.DOTALL)  # The threads, and all that follows.
    case = rs.Case.from_text("".join(parts))
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
    program = sys.argv[1] if len(sys.argv) > 1 else "build/release/bench/prs_bench"
    contact = rs.Case.from_yaml("configs/08_design_by_backlash.yaml")
    solve = rs.Case.from_yaml("configs/05_standard_screw.yaml")
    evaluate = designs_call()
    added: dict[str, list[float]] = {"contact": [], "solve": []}
    ratio: list[float] = []
    for _ in range(ROUNDS):
        engine = engine_times(program, "RunContact|RunSolve", "real_time")
        added["contact"].append(seconds(contact.contact) - engine["RunContact"])
        added["solve"].append(seconds(solve.solve) - engine["RunSolve"])
        of_study = engine_times(program, "FullChainComputed/200000/.*", "cpu_time")
        per_design = of_study["FullChainComputed"] / 200_000
        ratio.append(cpu_seconds(evaluate, 3) / DESIGNS / per_design)
    for name, values in added.items():
        low, high = min(values) * 1e6, max(values) * 1e6
        median = statistics.median(values) * 1e6
        print(f"{name}: {median:.1f} us a call above the engine ({low:.1f} to {high:.1f})")
    told = f"{statistics.median(ratio):.3f} ({min(ratio):.3f} to {max(ratio):.3f})"
    print(f"{DESIGNS} designs as arrays: {told} of the study engine's CPU time")
    of_function(program)


if __name__ == "__main__":
    main()
