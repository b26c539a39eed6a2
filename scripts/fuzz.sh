#!/usr/bin/env bash
# Builds the fuzz targets and runs each for so many seconds (600 by default): scripts/fuzz.sh
# [SECONDS [TARGET..]]. Findings lie minimised in build/fuzz/findings, what the targets reached in
# build/fuzz/coverage.txt; at the end stands a table. New inputs that reach more are kept in
# build/fuzz/corpus; `scripts/fuzz.sh merge` adds those that matter to tests/fuzz/corpus.
set -uo pipefail
cd "$(dirname "$0")/.."

targets=(documents force_history journals matrix_cache overrides)
root=$PWD
out=$root/build/fuzz
kept=$root/tests/fuzz/corpus
limits=(-timeout=20 -rss_limit_mb=2048 -max_len=8000)
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1
export UBSAN_OPTIONS=print_stacktrace=1
export LLVM_PROFILE_FILE=/dev/null
# What the targets write belongs to them.
TMPDIR=$(mktemp -d) || exit 1
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT

program() { echo "$out/tests/fuzz/fuzz_$1"; }

if [[ ${1:-} == merge ]]; then  # The smallest inputs that reach all that is reached.
  for target in "${targets[@]}"; do
    mkdir -p "$TMPDIR/$target"
    "$(program "$target")" -merge=1 "${limits[@]}" "$TMPDIR/$target" "$kept/$target" \
      "$out/corpus/$target" 2>&1 | tail -n 1
    ls -lS "$TMPDIR/$target" | head -n 5
  done
  exit
fi

seconds=${1:-600}
(($# > 1)) && targets=("${@:2}")
cmake --preset release >/dev/null && cmake --build --preset release --target prs >/dev/null &&
  cmake --preset fuzz >/dev/null && cmake --build --preset fuzz || exit 1

table=()
for target in "${targets[@]}"; do
  mkdir -p "$out/corpus/$target" "$out/findings/$target"
  log=$out/$target.log
  # Goes on after a finding, in another process.
  "$(program "$target")" "${limits[@]}" -fork=1 -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1 \
    -max_total_time="$seconds" -artifact_prefix="$out/findings/$target/" \
    "$out/corpus/$target" "$kept/$target" >"$log" 2>&1
  for found in "$out/findings/$target"/crash-*; do
    [[ -e $found && $found != *.min && ! -e $found.min ]] || continue
    "$(program "$target")" "${limits[@]}" -minimize_crash=1 -max_total_time=60 \
      -exact_artifact_path="$found.min" "$found" >/dev/null 2>&1
  done
  findings=$(find "$out/findings/$target" -type f ! -name '*.min' | wc -l)
  # Of the last line: #EXECUTIONS: cov: EDGES ft: ..
  last=$(grep -E '^#[0-9]+: cov: ' "$log" | tail -n 1)
  table+=("$(printf '%-14s %8s %12s %9s' "$target" "$(sed -E 's/.*cov: ([0-9]+).*/\1/' <<<"$last")" \
    "$(sed -E 's/^#([0-9]+):.*/\1/' <<<"$last")" "$findings")")
  LLVM_PROFILE_FILE=$out/$target.profraw "$(program "$target")" -runs=0 "${limits[@]}" \
    "$out/corpus/$target" "$kept/$target" >/dev/null 2>&1
done

llvm-profdata merge -sparse "$out"/*.profraw -o "$out/fuzz.profdata" &&
  llvm-cov report "$(program documents)" -instr-profile="$out/fuzz.profdata" \
    -ignore-filename-regex='/usr/|tests/' >"$out/coverage.txt"
printf '%-14s %8s %12s %9s\n' target edges executions findings
printf '%s\n' "${table[@]}"
tail -n 1 "$out/coverage.txt"
