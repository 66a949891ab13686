#!/usr/bin/env bash
# scripts/docs.sh [FOLDER]: makes a site of the documents for a browser in FOLDER (build/site); open its README.html. A link without a
# target is an error.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly site=${1:-build/site}
readonly source=build/site-source

if [[ $# -gt 1 || ${1-} == -* ]]; then
  echo "usage: scripts/docs.sh [FOLDER]" >&2
  exit 2
fi
scripts/install-packages.sh docs

# The pages keep the repository's folders, so that their links work in the repository, on a forge and in the site.
rm -rf "$source"
mkdir -p "$source/pages/slurm" "$source/pages/src" "$source/pages/web"
cp -r README.md ARCHITECTURE.md LICENSE docs jobs examples "$source/pages"
cp slurm/README.md "$source/pages/slurm"
cp web/README.md "$source/pages/web"
cp src/rooms.txt "$source/pages/src"
mv "$source/pages/docs/mkdocs.yml" "$source"
mkdocs build --quiet --clean --config-file "$source/mkdocs.yml" --site-dir "$(realpath -m "$site")"
echo "The site: $site/index.html"
