#!/usr/bin/env bash
# bundle_test.sh SOURCE_FOLDER WORK_FOLDER: the pages' sources pass their own checks and give exactly the committed web/dist.
set -euo pipefail
source_folder=$1
folder=$2
# shellcheck source=tests/web/npm_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/npm_fixture.sh"
need node "builds the pages"
need npm "installs what builds the pages"

rm -rf "$folder"
mkdir -p "$folder"
tar -C "$source_folder/web" --exclude=./node_modules --exclude=./dist -cf - . | tar -C "$folder" -xf -
cd "$folder"
install_packages
for step in check test build; do
  npm run --silent "$step" >"$step.log" 2>&1 || {
    echo "FAILED npm run $step in web/"
    tail -n 60 "$step.log"
    exit 1
  }
  echo "ok npm run $step"
done
for name in report.html LICENSES.txt; do
  cmp "dist/$name" "$source_folder/web/dist/$name" || {
    echo "FAILED web/dist/$name is not what the sources give; mend it: cd web && npm ci && npm run build"
    exit 1
  }
done
echo "ok web/dist is what the sources give"
