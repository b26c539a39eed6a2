#!/usr/bin/env bash
# Runs lessons, all of configs/ unless some are given: each command for which the file has all that it needs
# (`prs list commands FILE`), then the report. Files go to build/ci/NAME, what the program says to
# build/ci/NAME.log. Fails where a lesson does. PRS names another program than that of build/release.
set -euo pipefail
cd "$(dirname "$0")/.."

run_lesson() {
  local files log commands
  files=build/ci/$(basename "$1" .yaml)
  log=$files.log
  commands=$("$PRS" list commands "$1") || return 1
  : >"$log"
  for command in $commands report; do
    [[ $command == report ]] && set -- "$1" "$files/report.html" || set -- "$1" "$files"
    "$PRS" "$command" "$1" --quiet --output "$2" >>"$log" 2>&1 || { echo "FAILED  prs $command $1"; cat "$log"; return 1; }
  done
  echo "ok      $1"
}
export -f run_lesson
export PRS=${PRS:-$PWD/build/release/prs/cli/prs}
mkdir -p build/ci
((${#@})) || set -- configs/*.yaml
printf '%s\0' "$@" | xargs -0 -n 1 -P "$(nproc)" bash -c 'run_lesson "$0"'
