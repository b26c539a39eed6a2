#!/usr/bin/env bash
# Compiles the whole project with clang, warnings as errors, without making programs of it:
# build/clang. With --build instead: the program too. Further arguments go to CMake's configuration.
set -euo pipefail
cd "$(dirname "$0")/.."

flags=-fsyntax-only
if [[ ${1:-} == --build ]]; then
  flags=
  shift
fi
cmake -S . -B build/clang -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=clang++ \
  -DPRS_WARNINGS_AS_ERRORS=ON -DPRS_BUILD_BENCH=ON "$@" >/dev/null
if [[ -z $flags ]]; then
  cmake --build build/clang --target prs
  exit
fi
ninja -C build/clang -t compdb |
  python3 -c '
import json, shlex, sys
for entry in json.load(sys.stdin):
    words = shlex.split(entry["command"])
    if "-c" not in words: continue
    out = words.index("-o")
    print(shlex.join(words[:out] + ["-fsyntax-only"] + words[out + 2 :]))' |
  tr '\n' '\0' | (cd build/clang && xargs -0 -P "$(nproc)" -I{} sh -c '{}')
