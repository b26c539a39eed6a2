#!/usr/bin/env bash
# Installs what is missing, builds and runs the quick tests: all of them under the address and
# undefined-behaviour sanitizers, those of the numbers also as shipped, then those of the Python
# package. Arguments go to CMake's configuration.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh
for preset in release debug; do
  cmake --preset "$preset" -DPRS_BUILD_TESTS=ON "$@" >/dev/null
done
cmake --build --preset release --target prs prs-validate prs_tests
cmake --build --preset debug
ctest --preset quick-sanitized -j "$(nproc)"
ctest --preset numbers -j "$(nproc)"
scripts/test_python.sh
