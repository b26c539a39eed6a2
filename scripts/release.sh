#!/usr/bin/env bash
# Runs the tests under sanitizers and makes all that a release consists of, in dist/: packages, the workbench
# as one page, the site of documents, the list of all libraries used, what has changed, checksums. release.sh
# [PYTHON..]: further wheels (scripts/package.sh). Refuses a tree with changes that no commit has, and a version
# of which CHANGELOG.md says nothing; tags and uploads nothing.
set -euo pipefail
cd "$(dirname "$0")/.."

version=$(sed -n 's/.*kVersion = "\([^"]*\)".*/\1/p' prs/version.h)
if [[ -n $(git status --porcelain) ]]; then
  echo "release: the tree has changes that no commit has; commit or remove them (git status)" >&2
  exit 1
fi
changes=$(awk -v heading="## $version" '/^## / { inside = index($0, heading) == 1; next } inside' CHANGELOG.md)
if [[ -z ${changes//[[:space:]]/} ]]; then
  echo "release: CHANGELOG.md has no entry \`## $version\`, the version of prs/version.h; rename \`## Unreleased\`" >&2
  exit 1
fi

scripts/test.sh --sanitized
scripts/package.sh "$@"
prs=build/release/prs/cli/prs
[[ $("$prs" --version) == "$version" ]] || { echo "release: $prs is not of version $version" >&2; exit 1; }
"$prs" workbench --output "dist/prs-workbench-$version.html"
scripts/site.sh "$prs"
tar -C build/site --transform "s/^html/prs-$version-documents/" --sort=name --owner=0 --group=0 --numeric-owner \
  --mtime="@$(git log -1 --format=%ct)" -czf "dist/prs-$version-documents.tar.gz" html
printf '%s\n' "$changes" >"dist/CHANGES-$version.md"
(cd dist && sha256sum -- * >SHA256SUMS.tmp && mv SHA256SUMS.tmp SHA256SUMS)
ls -l dist
cat <<END
Left to do by hand: \`git tag v$version\`, try the packages where nothing else is installed (docs/CONTRIBUTING.md),
upload dist/.
END
