#!/usr/bin/env bash
# Installs what is missing, builds and runs the quick tests: all of them on an engine under the
# address and undefined-behaviour sanitizers, those of the numbers also as shipped, and beside them
# those of the Python package. Arguments go to CMake's configuration.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh
cmake --preset release -DPRS_BUILD_TESTS=ON "$@" >/dev/null
cmake --build --preset release --target prs prs-validate prs_tests prs_document_cases
# It takes objects of the release build, which must be there.
cmake --preset sanitized -DPRS_BUILD_TESTS=ON "$@" >/dev/null
cmake --build --preset sanitized

scripts/test_python.sh >build/test_python.txt 2>&1 &
python=$!
failed=()
ctest --preset quick-sanitized -j "$(nproc)" || failed+=(quick-sanitized)
wait "$python" || failed+=(python)
cat build/test_python.txt
ctest --preset numbers -j "$(nproc)" || failed+=(numbers)
if ((${#failed[@]})); then
  echo "test: failed: ${failed[*]}" >&2
  exit 1
fi
