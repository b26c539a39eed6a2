#!/usr/bin/env bash
# Builds what makes pages live, into build/web: their scripts (web/, by npm) and their engine (by emscripten), with
# the identity of their sources, by which a program knows its own (cmake/source_id.cmake). Needs the network.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh web
cmake -D OUTPUT=build/source_id -P cmake/source_id.cmake
cmp -s build/source_id build/web/source_id && exit  # Nothing has changed.
if cmp -s build/source_id web/built/source_id; then  # As released.
  rm -rf build/web
  cp -r web/built build/web
  exit
fi
rm -rf build/web
mkdir -p build/web
(cd web && npm ci --loglevel=error --ignore-scripts --no-audit --no-fund && node build.mjs ../build/web)
cmake --preset wasm >/dev/null
cmake --build --preset wasm
xz --format=lzma --lzma1=preset=9e,dict=8MiB,pb=0,lc=4 -c build/wasm/wasm/engine.wasm >build/web/engine.wasm.lzma
mv build/source_id build/web/source_id  # Last: without it the others are not taken.
