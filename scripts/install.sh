#!/usr/bin/env bash
# Builds all and installs it into PREFIX, by default ~/.local: program, lessons, validation data, manual,
# completions, documents, and what `find_package(prs)` needs.
set -euo pipefail
prefix=$(realpath -m "${1:-$HOME/.local}")
cd "$(dirname "$0")/.."

scripts/setup.sh full
cmake --preset release -DPRS_FULL=ON -DPRS_BUILD_TESTS=OFF
cmake --build --preset release --target all
cmake --install build/release --prefix "$prefix" --strip >/dev/null
"$prefix/bin/prs" --version
echo "Installed in $prefix"
