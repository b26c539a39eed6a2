#!/usr/bin/env bash
# Builds and installs from source, into PREFIX, by default ~/.local: program, lessons, validation data,
# manual, completions, documents, and what `find_package(prs)` needs.
set -euo pipefail
prefix=$(realpath -m "${1:-$HOME/.local}")
cd "$(dirname "$0")/.."

scripts/setup.sh
cmake --preset release >/dev/null
cmake --build --preset release --target prs prs-validate
cmake --install build/release --prefix "$prefix" --strip >/dev/null
"$prefix/bin/prs" --version
echo "Installed in $prefix"
