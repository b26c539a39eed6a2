#!/usr/bin/env bash
# Builds the engine of live pages by emscripten and ships it as prs/engine/engine.wasm.lzma, with the list
# of its sources and their hash in prs/engine/engine.sources. --check: whether these sources are still
# those; needs no emscripten.
set -euo pipefail
cd "$(dirname "$0")/.."

module=prs/engine/engine.wasm.lzma
manifest=prs/engine/engine.sources

hash_of() { # FILE..: of their names and contents
  sha256sum -- "$@" | sha256sum | cut -d ' ' -f 1
}

if [[ ${1:-} == --check ]]; then
  mapfile -t lines <"$manifest"
  if [[ $(hash_of "$module" "${lines[@]:1}") != "${lines[0]}" ]]; then
    echo "engine: $module is not that of its sources ($manifest); run scripts/engine.sh" >&2
    exit 1
  fi
  exit
fi

scripts/setup.sh emscripten libfast-float-dev xz-utils
cmake --preset wasm
# What clang 14 writes depends on where its memory lies: without random addresses, and with a compiler
# cache of its own, the same sources give the same bytes.
CCACHE_NAMESPACE=engine setarch -R cmake --build --preset wasm
xz --format=lzma --lzma1=preset=9e,dict=8MiB,pb=0,lc=4 -c build/wasm/wasm/engine.wasm >"$module"

mapfile -t sources < <(
  {
    ninja -C build/wasm -t deps | awk '/^ / { print $1 }' | (cd build/wasm && xargs realpath)
    realpath cmake/webassembly.cmake wasm/CMakeLists.txt prs/measures/measures.yaml \
      validation/standard_screws/screws.csv
  } | grep "^$PWD/" | grep -v "^$PWD/build/" | sed "s|^$PWD/||" | LC_ALL=C sort -u
)
{
  hash_of "$module" "${sources[@]}"
  printf '%s\n' "${sources[@]}"
} >"$manifest"
ls -l build/wasm/wasm/engine.wasm "$module"
