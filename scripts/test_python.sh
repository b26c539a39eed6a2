#!/usr/bin/env bash
# Builds the Python package on build/release, installs it into an environment of its own, build/venv, and
# runs type checks, tests and notebooks; arguments go to pytest. --tools: installs what that needs, only.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh test
venv=$PWD/build/venv
[[ -x $venv/bin/python ]] || python3 -m venv "$venv"
pip=("$venv/bin/pip" install -q --disable-pip-version-check)
"${pip[@]}" --no-compile -r <(python3 -c '
import tomllib

read = tomllib.load(open("pyproject.toml", "rb"))
extras = read["project"]["optional-dependencies"]
for part in (read["build-system"]["requires"], read["project"]["dependencies"],
             extras["test"], extras["examples"], extras["notebooks"], extras["lint"]):
    print(*part, sep="\n")')
[[ ${1:-} != --tools ]] || exit 0

# By the same CMake as the rest: another one, which packages bring, would compile everything again.
CMAKE_EXECUTABLE=$(command -v cmake) "${pip[@]}" --no-deps --no-build-isolation \
  --config-settings=build-dir=build/release --config-settings=cmake.define.PRS_FULL=ON \
  --config-settings=cmake.define.PRS_BUILD_TESTS=ON .
unset PYTHONDONTWRITEBYTECODE  # Hundreds of processes load the same modules.
export PYTHONPYCACHEPREFIX=$PWD/build/pycache PRS_EXECUTABLE=$PWD/build/release/prs/cli/prs PRS_CACHE_DIR= MPLBACKEND=Agg
"$venv/bin/mypy"
# Tests that share answers in one process, which keeps them (conftest.py).
"$venv/bin/pytest" -q -n "$(nproc)" --dist loadgroup "$@"
