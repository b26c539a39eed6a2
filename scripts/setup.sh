#!/usr/bin/env bash
# Installs the Debian packages of these groups, and others that are named, where they are missing: setup.sh
# [core|full|test|web|PACKAGE ..]. core: the light program; full: all of it; test: its tests; web: the engine
# of live pages. Without arguments: full.
set -euo pipefail

core="cmake ninja-build g++ pkg-config libeigen3-dev libsuitesparse-dev libyaml-cpp-dev libboost-dev libcli11-dev
  libfmt-dev nlohmann-json3-dev libcsv-dev nettle-dev libxsimd-dev zlib1g-dev"
full="$core libspectra-dev libtbb-dev librsvg2-dev libpagmo-dev libceres-dev libsundials-dev
  gcc-mingw-w64-x86-64-win32"
web="$core libspectra-dev emscripten libfast-float-dev xz-utils $(command -v npm >/dev/null || echo nodejs npm)"
test="$full $web python3-dev python3-venv libgtest-dev libgmock-dev libbenchmark-dev python3-jsonschema strace
  chromium chromium-driver wine64"
packages=()
for word in "${@:-full}"; do
  case $word in
    core | full | test | web) packages+=(${!word}) ;;
    *) packages+=("$word") ;;
  esac
done
command -v dpkg-query >/dev/null || { echo "setup: no Debian system; install the like of: ${packages[*]}" >&2; exit 1; }
missing=$(comm -23 <(printf '%s\n' "${packages[@]}" | sort -u) \
  <(dpkg-query -W -f '${db:Status-Abbrev}${Package}\n' | sed -n 's/^ii //p' | sort -u))
[[ -n $missing ]] || exit 0
as_root=$([[ $EUID == 0 ]] || command -v sudo) || { echo "setup: ask an administrator to install" $missing >&2; exit 1; }
echo "setup: installing" $missing
$as_root apt-get update -q
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends $missing
