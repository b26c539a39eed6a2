#!/usr/bin/env bash
# Bundles the pages' scripts, web/, into prs/page/live, with the hash of their sources in web.sources.
# Needs npm; users and builds do not. --check: whether the bundles are those of these sources.
set -euo pipefail
cd "$(dirname "$0")/.."

manifest=prs/page/live/web.sources
bundles=(prs/page/live/{report,workbench,mechanism}.{js.gz,hash} prs/page/live/{start,worker}.js)

hash_of() { # FILE..: of their names and contents
  sha256sum -- "$@" | sha256sum | cut -d ' ' -f 1
}

if [[ ${1:-} == --check ]]; then
  mapfile -t lines <"$manifest"
  if [[ $(hash_of "${bundles[@]}" "${lines[@]:1}") != "${lines[0]}" ]]; then
    echo "web: the bundles in prs/page/live are not those of their sources ($manifest); run scripts/web.sh" >&2
    exit 1
  fi
  exit
fi

(cd web && npm ci --silent --ignore-scripts --no-audit --no-fund && node build.mjs)
mapfile -t sources < <(find web -name node_modules -prune -o -type f -print | LC_ALL=C sort)
{
  hash_of "${bundles[@]}" "${sources[@]}"
  printf '%s\n' "${sources[@]}"
} >"$manifest"
