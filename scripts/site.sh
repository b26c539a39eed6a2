#!/usr/bin/env bash
# Writes the documents as one static site, build/site/html: pages, lessons, notebooks, references of
# commands, inputs and results, of C++ (Doxygen) and Python, with a search and live pages of the program
# (build/release, or the one that is named: site.sh PRS). A warning or a link that leads nowhere is an error.
set -euo pipefail
cd "$(dirname "$0")/.."

prs=$(realpath -m "${1:-build/release/prs/cli/prs}")
if [[ ! -x $prs ]]; then
  echo "site: no program $prs, which writes the live pages. Build it by \`cmake --preset release && cmake --build" \
    "--preset release --target prs\`, or name one: scripts/site.sh PRS" >&2
  exit 1
fi
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
python3 - build/site/html/searchindex.js <<'END'
import json, sys
text = open(sys.argv[1]).read()
index = json.loads(text[text.index("(") + 1 : text.rindex(")")])
pages = [index["terms"].get(stem, []) for stem in ("static", "safeti")]
pages = [{page} if isinstance(page, int) else set(page) for page in pages]
if not set.intersection(*pages):
    sys.exit('site: the search finds no page with "static safety"')
END
echo "site: build/site/html/index.html"
