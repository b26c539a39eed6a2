#!/usr/bin/env bash
# Order of rooms, shipped engine, width and links of documents, format, Python's style and types, and whether
# validation records and the benchmark's page are what the program of build/release gives, by the tools on the
# PATH and those that scripts/test_python.sh installs. clang-tidy reads the FILEs named, with --all every source.
# --strict: a missing tool is an error.
set -euo pipefail
cd "$(dirname "$0")/.."

strict=0 tidy=()
for argument in "$@"; do
  case $argument in
    --strict) strict=1 ;;
    --all) mapfile -t tidy < <(git ls-files '*.cpp' ':!python') ;;
    *) tidy+=("$argument") ;;
  esac
done

failed=0
check() { # NAME COMMAND..: whether the command passes
  echo "== $1"
  "${@:2}" || failed=1
}
has() { # TOOL
  command -v "$1" >/dev/null && return
  echo "lint: no $1" >&2
  failed=$((failed | strict))
  return 1
}

export PATH=$PWD/build/venv/bin:$PATH
check rooms scripts/check_rooms.py
check engine scripts/engine.sh --check
check web scripts/web.sh --check
check markdown scripts/wrap_markdown.py
check links scripts/check_links.py
# A lambda with a return type as a template argument, which clang-format takes for the end of a namespace.
check namespaces bash -c '! git grep -nE "^[>,]" -- "*.h" "*.cpp"'
check comments bash -c '! git grep -nE "///< (Of|That|Where|With) " -- "*.h" "*.cpp"'
if has clang-format; then
  check format xargs -a <(git ls-files '*.h' '*.cpp') -P "$(nproc)" -n 50 clang-format --dry-run --Werror
fi
if has ruff; then check ruff ruff check -q; fi
prs=build/release/prs/cli/prs
if has "$prs"; then
  check records python3 scripts/validation_records.py "$prs" --check
  check benchmark python3 benchmark/results_page.py "$prs" --check
fi
if has mypy; then check mypy mypy; fi
if ((${#tidy[@]})) && has clang-tidy; then
  cmake --preset folders >/dev/null
  check tidy xargs -P "$(nproc)" -n 4 clang-tidy -p build/folders --quiet \
    < <(printf '%s\n' "${tidy[@]}")
fi
exit "$failed"
