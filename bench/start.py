#!/usr/bin/env python3
"""Time of whole processes against /bin/true: bench/start.py [PROGRAM]

Runs alternate, so that all of them see the same machine; medians of 200 runs.
"""

import os
import statistics
import subprocess
import sys
import time

RUNS = 200
SILENT = [(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)]
program = sys.argv[1] if len(sys.argv) > 1 else "build/release/prs/cli/prs"
commands = {
    "/bin/true": ["/bin/true"],
    "prs --version": [program, "--version"],
    "prs solve, lesson 1": [program, "solve", "configs/01_config_1_to_3.yaml", "--quiet"],
}


def milliseconds(command: list[str]) -> float:
    start = time.perf_counter()
    os.waitpid(os.posix_spawnp(command[0], command, os.environ, file_actions=SILENT), 0)
    return 1e3 * (time.perf_counter() - start)


def libraries(command: list[str]) -> int:
    run = subprocess.run(command, env=os.environ | {"LD_DEBUG": "files"}, capture_output=True)
    return run.stderr.count(b"calling init: ")



times: dict[str, list[float]] = {name: [] for name in commands}
for _ in range(RUNS):
    for name, command in commands.items():
        times[name].append(milliseconds(command))
true = statistics.median(times["/bin/true"])
for name, command in commands.items():
    median = statistics.median(times[name])
    print(
        f"{name:20} {median:6.2f} ms, {median / true:4.1f} times /bin/true, "
        f"{libraries(command)} libraries"
    )
