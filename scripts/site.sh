#!/usr/bin/env bash
# Writes the documents as one static site, build/site/html: pages, lessons, notebooks, references of commands,
# inputs and results, of C++ (Doxygen) and Python, with a search and live pages of the program of build/release.
# A warning or a link that leads nowhere is an error.
set -euo pipefail
cd "$(dirname "$0")/.."

prs=$PWD/build/release/prs/cli/prs
scripts/setup.sh doxygen
venv=$PWD/build/site/venv
[[ -x $venv/bin/sphinx-build ]] || python3 -m venv "$venv"
"$venv/bin/pip" install -q --disable-pip-version-check --no-compile -r docs/site/requirements.txt

export PRS_SITE_MADE=$PWD/build/site/made PRS_SITE_SOURCE=$PWD/build/site/made/source
rm -rf "$PRS_SITE_MADE" build/site/html
mkdir -p "$PRS_SITE_SOURCE" "$PRS_SITE_MADE/pages"
git ls-files -z -- . ':!tests/fuzz' ':!tests/golden' ':!*.json' | xargs -0 cp --parents -t "$PRS_SITE_SOURCE"
python3 docs/site/pages.py "$PRS_SITE_SOURCE"
"$prs" report configs/05_standard_screw.yaml --output "$PRS_SITE_MADE/pages/report.html" >"$PRS_SITE_MADE/report.txt"
"$prs" workbench --output "$PRS_SITE_MADE/pages/workbench.html" >"$PRS_SITE_MADE/workbench.txt"
(cd "$PRS_SITE_SOURCE" && doxygen docs/site/Doxyfile) >"$PRS_SITE_MADE/doxygen.txt" 2>&1
"$venv/bin/sphinx-build" -q -W --keep-going -j auto -c docs/site "$PRS_SITE_SOURCE" build/site/html
scripts/check_links.py build/site/html
echo "site: build/site/html/index.html"
