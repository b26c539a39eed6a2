#!/usr/bin/env bash
# From an empty clone to the answer: installs little, builds the light program, and solves CONFIG 1 to 3 of
# the screw of Abevi et al. 2015 in tension and compression. Tables on the terminal, files in out/.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh core
cmake --preset release -DPRS_FULL=OFF -DPRS_BUILD_TESTS=OFF
cmake --build --preset release --target prs
prs=build/release/prs/cli/prs
echo
"$prs" solve configs/03_load_sweep.yaml --quiet --output out/03_load_sweep
"$prs" solve configs/01_config_1_to_3.yaml --output out/01_config_1_to_3
echo
echo "Pictures: out/01_config_1_to_3/plots and, against the load, out/03_load_sweep/plots"
echo "Next: $prs validate, which compares with the papers; scripts/install.sh, which builds all analyses"
