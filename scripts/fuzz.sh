#!/usr/bin/env bash
# Builds the fuzz targets and runs each for so many seconds (600 by default): scripts/fuzz.sh [SECONDS
# [TARGET..]]. Findings lie in build/fuzz/findings, new inputs that reach more in build/fuzz/corpus; `-merge=1`
# of libFuzzer adds what is worth keeping to tests/fuzz/corpus.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh full clang libclang-rt-dev llvm
cmake --preset fuzz
cmake --build --preset fuzz
seconds=${1:-600}
targets=("${@:2}")
((${#targets[@]})) || targets=(documents force_history journals matrix_cache measured_curves overrides)
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1 UBSAN_OPTIONS=print_stacktrace=1
TMPDIR=$(mktemp -d -p /dev/shm)  # Journals are synced to the disk.
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
for target in "${targets[@]}"; do
  mkdir -p build/fuzz/{corpus,findings}/"$target"
  end=$((SECONDS + seconds))
  while ((left = end - SECONDS, left > 0)); do  # Also after a finding. Without the entropy of all features, which takes long.
    build/fuzz/tests/fuzz/fuzz_"$target" -timeout=60 -rss_limit_mb=2048 -max_len=16000 -entropic=0 -print_funcs=0 \
      -max_total_time="$left" -print_final_stats=1 -artifact_prefix=build/fuzz/findings/"$target"/ \
      build/fuzz/corpus/"$target" tests/fuzz/corpus/"$target" 2>&1 | tee -a build/fuzz/"$target".log || true
  done
done
find build/fuzz/findings -type f
