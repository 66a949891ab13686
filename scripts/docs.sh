#!/usr/bin/env bash
# scripts/docs.sh [FOLDER]: the documents as a site for a browser, in FOLDER (build/site): open its README.html. A link that leads
# nowhere is an error.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly site=${1:-build/site}
readonly source=build/site-source

if [[ $# -gt 1 || ${1-} == -* ]]; then
  echo "usage: scripts/docs.sh [FOLDER]" >&2
  exit 2
fi
scripts/install-packages.sh docs

# The pages lie in the folders of the repository, so that their links hold there, on a forge and in the site alike.
rm -rf "$source"
mkdir -p "$source/pages/slurm" "$source/pages/src"
cp -r README.md ARCHITECTURE.md LICENSE docs jobs examples "$source/pages"
cp slurm/README.md "$source/pages/slurm"
cp src/rooms.txt "$source/pages/src"
mv "$source/pages/docs/mkdocs.yml" "$source"
mkdocs build --quiet --clean --config-file "$source/mkdocs.yml" --site-dir "$(realpath -m "$site")"
echo "The site: $site/index.html"
