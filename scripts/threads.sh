#!/usr/bin/env bash
# Builds what runs side by side (EngineThreads, the module of Python) under clang's thread sanitizer, and
# runs it. Arguments go to the former's tests.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh clang libclang-rt-dev llvm lld
cmake --preset release >/dev/null
cmake --build --preset release --target prs >/dev/null
cmake --preset threads >/dev/null
cmake --build --preset threads
TSAN_OPTIONS="suppressions=$PWD/tests/support/thread_sanitizer.supp second_deadlock_stack=1" \
  build/threads/tests/prs_thread_tests "$@"
scripts/test_python.sh --threads
