#!/usr/bin/env bash
# Installs what is missing, builds all, and runs the quick tests: those of the program, of its engine for
# pages and of the Python package, all as shipped. --sanitized: instead, the tests of the program under the
# address and undefined-behaviour sanitizers (preset asan); --threads: what runs side by side, under the
# thread sanitizer (preset tsan).
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh test
case ${1:-} in
  --sanitized)
    cmake --preset asan
    cmake --build --preset asan
    ASAN_OPTIONS=detect_leaks=1 ctest --preset asan -j "$(nproc)"
    ;;
  --threads)
    cmake --preset tsan
    cmake --build --preset tsan --target prs_tests
    TSAN_OPTIONS="suppressions=tests/support/thread_sanitizer.supp second_deadlock_stack=1" \
      build/tsan/tests/prs_tests --gtest_filter='EngineThreads.*'
    ;;
  "")
    scripts/web.sh
    [[ -d web/node_modules ]] || (cd web && npm ci --loglevel=error --ignore-scripts --no-audit --no-fund)  # The tests' axe.
    CTEST_PARALLEL_LEVEL=$(nproc) cmake --workflow --preset test
    scripts/test_python.sh
    ;;
  *)
    echo "test: got $1; expected --sanitized, --threads or nothing" >&2
    exit 2
    ;;
esac
