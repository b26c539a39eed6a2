#!/usr/bin/env bash
# Builds the fuzz targets and runs each for so many seconds (600 by default): scripts/fuzz.sh
# [SECONDS [TARGET..]]. Findings lie minimised in build/fuzz/findings, what the targets reached in
# build/fuzz/coverage.txt; at the end stands a table. New inputs that reach more are kept in
# build/fuzz/corpus; `scripts/fuzz.sh merge` adds those that reach much more to tests/fuzz/corpus.
set -uo pipefail
cd "$(dirname "$0")/.."

targets=(documents force_history journals matrix_cache measured_curves overrides)
root=$PWD
out=$root/build/fuzz
kept=$root/tests/fuzz/corpus
# Draws without the entropy of all features: that takes longer than most inputs.
limits=(-timeout=60 -rss_limit_mb=2048 -max_len=16000 -entropic=0 -print_funcs=0)
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1:malloc_context_size=6
export UBSAN_OPTIONS=print_stacktrace=1
export LLVM_PROFILE_FILE=/dev/null
# What the targets write belongs to them; in memory, since journals are synced to the disk.
[[ -w /dev/shm ]] && export TMPDIR=/dev/shm
TMPDIR=$(mktemp -d) || exit 1
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT

program() { echo "$out/tests/fuzz/fuzz_$1"; }

if [[ ${1:-} == merge ]]; then  # What adds at least a five-hundredth of all edges to smaller inputs.
  for target in "${targets[@]}"; do
    mkdir -p "$out/corpus/$target" "$TMPDIR/$target"
    "$(program "$target")" -merge=1 -use_counters=0 "${limits[@]}" \
      -merge_control_file="$TMPDIR/$target.txt" "$TMPDIR/$target" "$kept/$target" \
      "$out/corpus/$target" 2>&1 | tail -n 1
    python3 - "$TMPDIR/$target.txt" "$kept/$target" <<'END'
import pathlib, shutil, sys
lines = open(sys.argv[1]).read().splitlines()
files, kept = lines[2:2 + int(lines[0])], pathlib.Path(sys.argv[2])
added = {files[int(w[1])]: len(w) - 2 for w in map(str.split, lines) if w[:1] == ["COV"]}
for file, edges in added.items():
    if 500 * edges >= sum(added.values()) and not kept.samefile(pathlib.Path(file).parent):
        shutil.copy(file, kept)
END
  done
  du -sh --apparent-size "$kept"
  exit
fi

scripts/setup.sh clang libclang-rt-dev llvm lld || exit 1
seconds=${1:-600}
(($# > 1)) && targets=("${@:2}")
cmake --preset release >/dev/null && cmake --build --preset release --target prs >/dev/null &&
  cmake --preset fuzz >/dev/null && cmake --build --preset fuzz || exit 1

# Fuzzes a target until its time is over, also after a finding. Without `-fork=1`, which starts a
# program and reads corpora for every few inputs.
fuzz() {
  local target=$1 log=$2 end=$((SECONDS + seconds)) status=1
  : >"$log"
  while ((status != 0 && SECONDS < end)); do
    { time "$(program "$target")" "${limits[@]}" -max_total_time=$((end - SECONDS)) \
      -print_final_stats=1 -artifact_prefix="$out/findings/$target/" \
      "$out/corpus/$target" "$kept/$target" >"$TMPDIR/log" 2>&1; status=$?; } 2>>"$log"
    cat "$TMPDIR/log" >>"$log"
    if ((status == 72)); then exit 130; fi  # Interrupted.
    grep -q INITED "$TMPDIR/log" || { echo "$target: the corpora hold a finding" >&2; return; }
  done
}

TIMEFORMAT='cpu %U %S'
table=()
for target in "${targets[@]}"; do
  mkdir -p "$out/corpus/$target" "$out/findings/$target"
  log=$out/$target.log
  fuzz "$target" "$log"
  for found in "$out/findings/$target"/crash-*; do
    [[ -e $found && $found != *.min && ! -e $found.min ]] || continue
    "$(program "$target")" "${limits[@]}" -minimize_crash=1 -max_total_time=60 \
      -exact_artifact_path="$found.min" "$found" >/dev/null 2>&1
  done
  findings=$(find "$out/findings/$target" -type f ! -name '*.min' | wc -l)
  table+=("$(awk -v target="$target" -v findings="$findings" '
    /^cpu / { cpu += $2 + $3 }
    /^stat::number_of_executed_units/ { runs += $2 }
    match($0, /cov: [0-9]+/) { after = substr($0, RSTART + 5, RLENGTH - 5) }
    /INITED/ && !before { before = after }
    END { printf "%-14s %7.0f %11d %7.1f %8d %8d %9d", target, cpu, runs,
                 (cpu > 0 ? runs / cpu : 0), before, after, findings }' "$log")")
  LLVM_PROFILE_FILE=$out/$target.profraw "$(program "$target")" -runs=0 "${limits[@]}" -artifact_prefix="$TMPDIR/" \
    "$out/corpus/$target" "$kept/$target" >/dev/null 2>&1
done

llvm-profdata merge -sparse "$out"/*.profraw -o "$out/fuzz.profdata" &&
  llvm-cov report "$(program documents)" -instr-profile="$out/fuzz.profdata" \
    -ignore-filename-regex='/usr/|tests/' >"$out/coverage.txt"
printf '%-14s %7s %11s %7s %17s %9s\n' target 'CPU s' executions per\ s 'edges from to' findings
printf '%s\n' "${table[@]}"
tail -n 1 "$out/coverage.txt"
