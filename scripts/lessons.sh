#!/usr/bin/env bash
# Runs lessons, all of configs/ unless some are given, as many at once as there are processors: each
# command for which the file has all that it needs (`prs list commands FILE`), then the report. The files of NAME.yaml
# go to build/ci/NAME, what the program says to build/ci/NAME.log. Fails where a lesson does, and says
# which and why. PRS names another program than that of build/release.
set -euo pipefail
cd "$(dirname "$0")/.."

export PRS=${PRS:-$PWD/build/release/prs/cli/prs}

run_all_commands() {
  local commands
  commands=$("$PRS" list commands "$1")
  for command in $commands; do
    echo "prs $command $1"
    "$PRS" "$command" "$1" --quiet --output "$2"
  done
  echo "prs report $1"
  "$PRS" report "$1" --quiet --output "$2/report.html"
}

run_lesson() {
  local files
  files=build/ci/$(basename "$1" .yaml)
  if bash -euc 'run_all_commands "$0" "$1"' "$1" "$files" >"$files.log" 2>&1; then
    echo "ok      $1"
  else
    echo "FAILED  $1"
    sed 's/^/        /' "$files.log"
    return 1
  fi
}
export -f run_all_commands run_lesson

mkdir -p build/ci
((${#@})) || set -- configs/*.yaml
printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" bash -c 'run_lesson "$0"'
