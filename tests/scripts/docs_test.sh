#!/usr/bin/env bash
# docs_test.sh NEW_FOLDER: scripts/docs.sh makes a site without a warning. A browser that shows it loads nothing from another host.
set -euo pipefail
folder=$1
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
fail() { echo "FAILED $1"; exit 1; }

rm -rf "$folder"
output=$(scripts/docs.sh "$folder" 2>&1) || fail "scripts/docs.sh: $output"
[[ $(grep -v DeprecationWarning <<<"$output" | tail -n 1) == "The site: $folder/index.html" && $output != *WARNING* ]] || fail "it says: $output"
pages=$(find "$folder" -name '*.html' | wc -l)
((pages >= 30)) || fail "$pages pages"
for page in index.html docs/guide/first-collage.html docs/job-format.html docs/measurements.html docs/scaling.html; do
  [[ -s $folder/$page ]] || fail "no $page"
done
# Readers may follow links to other hosts. But scripts, style sheets, pictures and fonts would be loaded.
loaded=$(grep -rnoE '<(script|img|iframe|source)[^>]* src="?(https?:)?//[^"> ]+|<link[^>]*(stylesheet|preconnect|icon)[^>]* href="?(https?:)?//[^"> ]+' \
         "$folder" --include='*.html' | head -n 5 || true)
[[ -z $loaded ]] || fail "a page loads: $loaded"
loaded=$(grep -rnoE '(url\(|@import )["'\'' ]?(https?:)?//[^)"]+' "$folder" --include='*.css' | head -n 5 || true)
[[ -z $loaded ]] || fail "a style sheet loads: $loaded"
echo "ok $pages pages"
