#!/usr/bin/env bash
# Installs the Debian packages that building, testing and plotting need, and those given, where they are
# missing.
set -euo pipefail

packages=(
  cmake ninja-build g++ pkg-config ccache
  libeigen3-dev libspectra-dev libsuitesparse-dev libyaml-cpp-dev libboost-dev
  libcli11-dev libfmt-dev nlohmann-json3-dev libcsv-dev nettle-dev libxsimd-dev
  libtbb-dev libnetcdf-dev librsvg2-dev zlib1g-dev libopenmpi-dev libpagmo-dev libceres-dev openmpi-bin libsundials-dev
  python3-dev python3-venv
  libgtest-dev libgmock-dev libbenchmark-dev python3-jsonschema
  nodejs strace
  chromium chromium-driver
  "$@"
)

if ! command -v dpkg-query >/dev/null; then
  echo "setup: this is not a Debian system; install the equivalents of: ${packages[*]}" >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [[ $status == "install ok installed" ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  exit 0
fi

if ((EUID == 0)); then
  as_root=()
elif command -v sudo >/dev/null; then
  as_root=(sudo)
else
  echo "setup: missing packages and neither root nor sudo to install them. Ask an administrator for:" >&2
  echo "  apt-get install ${missing[*]}" >&2
  exit 1
fi

echo "setup: installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -q --no-install-recommends "${missing[@]}"
