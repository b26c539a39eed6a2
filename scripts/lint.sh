#!/usr/bin/env bash
# Order of rooms, width, links and counts of documents, format, Python's style and types, and whether validation
# records and the benchmark's page are what the program of build/release gives, by the tools on the PATH and
# those that scripts/test_python.sh --tools installs. clang-tidy reads the FILEs named.
set -uo pipefail
cd "$(dirname "$0")/.."

failed=0
check() { # NAME COMMAND..: whether the command passes
  echo "== $1"
  "${@:2}" || failed=1
}

export PATH=$PWD/build/venv/bin:$PATH
check rooms scripts/check_rooms.py
check markdown scripts/wrap_markdown.py
check links scripts/check_links.py
# A lambda with a return type as a template argument, which clang-format takes for the end of a namespace.
check namespaces bash -c '! git grep -nE "^[>,]" -- "*.h" "*.cpp"'
check comments scripts/check_comments.py
# How many there are of what grows: a list says it, a number in a text ages.
check counts bash -c '! git grep -niE "\b([0-9]{2,}|eleven|twelve|[a-z]+teen|[a-z]+ty(-[a-z]+)?) (numbered )?(lessons|commands|notebooks)\b" -- "*.md" "*.ipynb" "*.py"'
check numbers scripts/check_numbers.py
check format xargs -a <(git ls-files '*.h' '*.cpp') -P "$(nproc)" -n 50 clang-format --dry-run --Werror
check ruff ruff check -q
check records python3 scripts/validation_records.py build/release/prs/cli/prs --check
check benchmark python3 benchmark/results_page.py build/release/prs/cli/prs --check
check mypy mypy
if (($#)); then
  cmake --preset dev >/dev/null
  check tidy clang-tidy -p build/dev --quiet "$@"
fi
exit "$failed"
