#!/usr/bin/env bash
# Installs what is missing, builds and runs the quick tests, as shipped and under the address and
# undefined-behaviour sanitizers. Arguments go to CMake's configuration.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh
for preset in release debug; do
  cmake --preset "$preset" -DPRS_BUILD_TESTS=ON "$@" >/dev/null
  cmake --build --preset "$preset"
done
ctest --preset quick-sanitized -j "$(nproc)"
ctest --preset quick -j "$(nproc)"
