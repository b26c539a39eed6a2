#!/usr/bin/env bash
# Runs the tests under sanitizers and makes all that a release consists of, in dist/: packages, the workbench
# as one page, the site of documents, the list of all libraries used, what has changed, checksums. Refuses a
# tree with changes that no commit has, and a version of which CHANGELOG.md says nothing; tags and uploads
# nothing.
set -euo pipefail
cd "$(dirname "$0")/.."

version=$(sed -n 's/.*kVersion = "\([^"]*\)".*/\1/p' prs/version.h)
changes=$(awk -v heading="## $version" '/^## / { inside = index($0, heading) == 1; next } inside' CHANGELOG.md)
[[ -z $(git status --porcelain) && -n ${changes//[[:space:]]/} ]] || {
  echo "release: commit what \`git status\` shows, and let CHANGELOG.md have an entry \`## $version\`" >&2
  exit 1
}
scripts/web.sh
cmp build/web/source_id web/built/source_id || {
  echo "release: copy build/web to web/built and commit it: released sources have live pages" >&2
  exit 1
}
scripts/test.sh --sanitized
scripts/test.sh --threads
scripts/package.sh
build/release/prs/cli/prs workbench --output "dist/prs-workbench-$version.html"
scripts/site.sh
tar -C build/site --transform "s/^html/prs-$version-documents/" --sort=name --owner=0 --group=0 --numeric-owner \
  --mtime="@$(git log -1 --format=%ct)" -czf "dist/prs-$version-documents.tar.gz" html
printf '%s\n' "$changes" >"dist/CHANGES-$version.md"
(cd dist && sha256sum -- * >SHA256SUMS.tmp && mv SHA256SUMS.tmp SHA256SUMS)
echo "Left to do by hand: a contact for the packages (CPACK_PACKAGE_CONTACT), \`git tag v$version\`, try the packages where nothing else is installed, upload dist/"
