#!/usr/bin/env bash
# Installs what is missing, builds and runs the quick tests: those of the numbers and those of the
# Python package as shipped, and those of documents on an engine whose rooms that take files apart
# (preset `reading`) clang compiled under the address and undefined-behaviour sanitizers. Both at once.
# --sanitized: instead, numbers and documents on an engine that is compiled so as a whole. --tools
# installs only. Options of CMake, -D.., are passed on.
set -euo pipefail
cd "$(dirname "$0")/.."

step=quick options=()
for argument in "$@"; do
  case $argument in
    --tools | --sanitized) step=${argument#--} ;;
    -D?*) options+=("$argument") ;;
    *) echo "test: got $argument; expected --tools, --sanitized or -D.. for CMake" >&2; exit 2 ;;
  esac
done
scripts/setup.sh clang libclang-rt-dev llvm lld
if [[ $step == tools ]]; then
  exec scripts/test_python.sh --tools
fi
mkdir -p build
if [[ $step == quick ]]; then
  scripts/test_python.sh --tools >build/test_tools.txt 2>&1 &
  tools=$!
fi
# In large pages clang takes a fifteenth less time.
by_clang=(env GLIBC_TUNABLES=glibc.malloc.hugetlb=1 cmake --build)

# All engines are linked with the same compiled tests.
cmake --preset tests "${options[@]}" >/dev/null
cmake --preset release -DPRS_BUILD_TESTS=ON -DPRS_TESTS_FROM="$PWD/build/tests" "${options[@]}" >/dev/null
cmake --build --preset release --target prs prs-validate
"${by_clang[@]}" --preset tests

# What has no sanitizers comes from the release build, which is built by one at a time.
build_with_sanitizers() { # PRESET
  cmake --preset "$1" -DPRS_BUILD_TESTS=ON "${options[@]}" >/dev/null &&
    flock build/release.lock "${by_clang[@]}" --preset "$1"
}
run_with_sanitizers() { # PRESET TESTS
  local reports=$PWD/build/$1/reports
  rm -rf "$reports" && mkdir "$reports"
  ASAN_OPTIONS=log_path=$reports/asan ctest --preset "$2" -j "$(nproc)" && return
  # LeakSanitizer itself ends some of many programs whose threads are just ending. Where that is all that
  # was reported, what failed is run once more.
  cat "$reports"/* >&2 || return 1
  [[ -z $(grep -L "LeakSanitizer has encountered a fatal error" "$reports"/*) ]] || return 1
  ctest --preset "$2" --rerun-failed
}
if [[ $step == sanitized ]]; then
  build_with_sanitizers sanitized
  run_with_sanitizers sanitized quick-sanitized
  exit
fi
cmake --build --preset release --target prs_tests
wait "$tools" || { cat build/test_tools.txt; exit 1; }

# Numbers first: meanwhile the build under sanitizers has the release build for itself.
as_shipped() {
  local status=0
  ctest --preset numbers -j "$(nproc)" >build/test_numbers.txt 2>&1 || status=1
  { flock build/release.lock scripts/test_python.sh --install &&
    scripts/test_python.sh --run; } >build/test_python.txt 2>&1 || status=1
  return "$status"
}
failed=()
as_shipped &
shipped=$!
{ build_with_sanitizers reading && run_with_sanitizers reading reading; } || failed+=("under sanitizers")
wait "$shipped" || failed+=("as shipped")
cat build/test_python.txt build/test_numbers.txt
if ((${#failed[@]})); then
  echo "test: failed: ${failed[*]}" >&2
  exit 1
fi
