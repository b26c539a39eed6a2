#!/usr/bin/env bash
# Installs what is missing, builds and runs the quick tests: those of the numbers and those of the
# Python package as shipped, and all but the latter on an engine by clang under the address and
# undefined-behaviour sanitizers. Both at once. Arguments go to CMake's configuration; --tools alone
# installs only.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh clang libclang-rt-dev llvm lld
if [[ ${1:-} == --tools ]]; then
  exec scripts/test_python.sh --tools
fi
mkdir -p build
scripts/test_python.sh --tools >build/test_tools.txt 2>&1 &
tools=$!
# In large pages clang takes a fifteenth less time.
by_clang() { GLIBC_TUNABLES=glibc.malloc.hugetlb=1 cmake --build "$@"; }

# Both engines are linked with the same compiled tests.
cmake --preset tests "$@" >/dev/null
cmake --preset release -DPRS_BUILD_TESTS=ON -DPRS_TESTS_FROM="$PWD/build/tests" "$@" >/dev/null
cmake --build --preset release --target prs prs-validate
by_clang --preset tests
cmake --build --preset release --target prs_tests
wait "$tools" || { cat build/test_tools.txt; exit 1; }

# Both build in build/release, one at a time.
as_shipped() {
  local status=0
  { flock build/release.lock scripts/test_python.sh --install &&
    scripts/test_python.sh --run; } >build/test_python.txt 2>&1 || status=1
  ctest --preset numbers -j "$(nproc)" >build/test_numbers.txt 2>&1 || status=1
  return "$status"
}
sanitized() {  # It takes kernels of the release build.
  cmake --preset sanitized -DPRS_BUILD_TESTS=ON "$@" >/dev/null &&
    by_clang --preset sanitized --target prs prs-validate &&
    flock build/release.lock cmake --build --preset sanitized || return
  local reports=$PWD/build/sanitized/reports
  rm -rf "$reports" && mkdir "$reports"
  ASAN_OPTIONS=log_path=$reports/asan ctest --preset quick-sanitized -j "$(nproc)" && return
  # LeakSanitizer itself ends some of many programs whose threads are just ending. Where that is all that
  # was reported, what failed is run once more.
  cat "$reports"/* >&2 || return 1
  [[ -z $(grep -L "LeakSanitizer has encountered a fatal error" "$reports"/*) ]] || return 1
  ctest --preset quick-sanitized --rerun-failed
}
failed=()
as_shipped &
shipped=$!
sanitized "$@" || failed+=(sanitized)
wait "$shipped" || failed+=("as shipped")
cat build/test_python.txt build/test_numbers.txt
if ((${#failed[@]})); then
  echo "test: failed: ${failed[*]}" >&2
  exit 1
fi
