#!/usr/bin/env bash
# doxygen_test.sh NEW_FOLDER: doxygen makes pages of the public headers without a warning.
set -euo pipefail
folder=$1
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
rm -rf "$folder"
mkdir -p "$folder"
{ cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = \"$folder\""; } | doxygen -
for page in match_8h pad_8h classtessera_1_1matching_1_1Descriptor; do
  [[ -s $folder/html/$page.html ]] || { echo "FAILED: no $page.html" >&2; exit 1; }
done
