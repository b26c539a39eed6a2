#!/usr/bin/env bash
# Builds the Python package on the libraries of build/release, installs it into an environment of its
# own, build/venv, and runs type checks, tests and notebooks; what else is given goes to pytest. One
# step of this alone: --tools installs what the rest needs, --install the package, --run runs the
# tests. Instead, on an engine built for it: --sanitized runs the tests under the address and
# undefined-behaviour sanitizers (build/debug), --threads those of threads under the thread sanitizer
# (build/threads).
set -euo pipefail
cd "$(dirname "$0")/.."

venv=$PWD/build/venv
pip=("$venv/bin/pip" install -q --disable-pip-version-check)

tools() {
  scripts/setup.sh
  [[ -x $venv/bin/python ]] || python3 -m venv "$venv"
  # Thousands of modules, of which the tests load few: Python compiles these when it does.
  "${pip[@]}" --no-compile -r <(python3 -c '
import tomllib

read = tomllib.load(open("pyproject.toml", "rb"))
extras = read["project"]["optional-dependencies"]
for part in (read["build-system"]["requires"], read["project"]["dependencies"],
             extras["test"], extras["examples"], extras["notebooks"], extras["lint"]):
    print(*part, sep="\n")')
}

package() {
  # By the same CMake as the rest: another one, which packages bring, compiles everything again.
  CMAKE_EXECUTABLE=$(command -v cmake) "${pip[@]}" --no-deps --no-build-isolation -C build-dir=build/release -C cmake.define.PRS_BUILD_TESTS=ON .
}

# Python keeps what it compiled of a module: hundreds of processes load the same.
unset PYTHONDONTWRITEBYTECODE
export PYTHONPYCACHEPREFIX=$PWD/build/pycache

step=all
case ${1:-} in
  --tools | --install | --run | --sanitized | --threads) step=${1#--}; shift ;;
esac
case $step in
  tools) tools; exit ;;
  install) package; exit ;;
  all | sanitized | threads) tools; package ;;
esac

export PRS_EXECUTABLE=$PWD/build/release/prs/cli/prs PRS_CACHE_DIR= MPLBACKEND=Agg
if [[ $step == all || $step == run ]]; then
  "$venv/bin/mypy"
  # Tests that share answers in one process, which keeps them (conftest.py).
  "$venv/bin/pytest" -q -n "$(nproc)" --dist loadgroup "$@"
  exit
fi

# pytest_on PRESET LIBRARIES ..: the tests on an engine of that preset, with its sanitizers' libraries
# loaded first.
pytest_on() {
  local build=build/$1 libraries=$2
  cmake --preset "$1" -DPRS_BUILD_PYTHON=ON -DPython_EXECUTABLE="$venv/bin/python" >/dev/null
  cmake --build "$build" --target rollerscrew_engine prs prs-validate
  rm -rf "$build/site"
  mkdir -p "$build/site"
  cp -r python/rollerscrew "$build/site"
  cp "$build"/python/_engine*.so "$build"/lib/prs/*.so "$build/site/rollerscrew"
  PRS_EXECUTABLE=$PWD/$build/prs/cli/prs LD_PRELOAD=$libraries PYTHONMALLOC=malloc PYTHONPATH=$build/site \
    "$venv/bin/pytest" -q -p no:cacheprovider "${@:3}"
}

if [[ $step == threads ]]; then
  # clang's own library cannot be loaded first; GCC's has all that clang 14 calls.
  export TSAN_OPTIONS="suppressions=$PWD/tests/support/thread_sanitizer.supp second_deadlock_stack=1"
  pytest_on threads "$(g++ -print-file-name=libtsan.so)" \
    -s python/tests/test_case.py python/tests/test_designs.py -k thread "$@"  # -s: reports are seen.
  exit
fi

# Leaks: the interpreter's own are many. New and delete: NumPy's libraries bring their own. Forks of
# processes with threads: the sanitizer's allocator may be locked in the child.
export ASAN_OPTIONS=detect_leaks=0:alloc_dealloc_mismatch=0
pytest_on debug "$(g++ -print-file-name=libasan.so) $(g++ -print-file-name=libubsan.so)" \
  -n "$(nproc)" --deselect python/tests/test_notebooks.py \
  --deselect python/tests/test_benchmark.py --deselect python/tests/test_plots.py --deselect python/tests/test_program.py -k "not (fork and threads)" "$@"
