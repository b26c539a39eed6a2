#!/usr/bin/env bash
# Builds the Python package on the libraries of build/release, installs it into an environment of its
# own, build/venv, and runs type checks, tests and notebooks. With --sanitized instead: the tests on
# an engine of build/sanitized, under the address and undefined-behaviour sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh
venv=$PWD/build/venv
[[ -x $venv/bin/python ]] || python3 -m venv "$venv"
"$venv/bin/pip" install -q --disable-pip-version-check "scikit-build-core>=0.11" "nanobind>=2.4"
"$venv/bin/pip" install -q --disable-pip-version-check --no-build-isolation \
  -C build-dir=build/release -C cmake.define.PRS_BUILD_TESTS=ON ".[test,notebooks,lint]"

export PRS_EXECUTABLE=$PWD/build/release/prs/cli/prs PRS_CACHE_DIR= MPLBACKEND=Agg
if [[ ${1:-} != --sanitized ]]; then
  "$venv/bin/mypy"
  # Tests that share answers in one process, which keeps them (conftest.py).
  "$venv/bin/pytest" -q -n "$(nproc)" --dist loadgroup "$@"
  exit
fi

cmake --preset sanitized -DPRS_BUILD_PYTHON=ON -DPython_EXECUTABLE="$venv/bin/python" >/dev/null
cmake --build --preset sanitized --target rollerscrew_engine prs prs-validate
site=build/sanitized/site
rm -rf "$site"
mkdir -p "$site"
cp -r python/rollerscrew "$site"
cp build/sanitized/python/_engine*.so build/sanitized/lib/prs/*.so "$site/rollerscrew"
sanitizers="$(g++ -print-file-name=libasan.so) $(g++ -print-file-name=libubsan.so)"
# Leaks: the interpreter's own are many. New and delete: NumPy's libraries bring their own. Forks of
# processes with threads: the sanitizer's allocator may be locked in the child.
PRS_EXECUTABLE=$PWD/build/sanitized/prs/cli/prs LD_PRELOAD=$sanitizers ASAN_OPTIONS=detect_leaks=0:alloc_dealloc_mismatch=0 \
  PYTHONMALLOC=malloc PYTHONPATH=$site \
  "$venv/bin/pytest" -q -n "$(nproc)" -p no:cacheprovider --deselect python/tests/test_notebooks.py \
  --deselect python/tests/test_plots.py --deselect python/tests/test_program.py -k "not (fork and threads)"
