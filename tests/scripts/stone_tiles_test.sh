#!/usr/bin/env bash
# scripts/stone_tiles.py: makes a map of the sheet's size, which is the same each time.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

sandbox=$(mktemp -d)
trap 'rm -rf "$sandbox"' EXIT
fail() {
  echo "FAILED $1"
  exit 1
}

for run in first second; do /usr/bin/python3 scripts/stone_tiles.py jobs/photos/flagstones.jpg "$sandbox/$run"; done
cmp "$sandbox/first/labels.png" "$sandbox/second/labels.png" || fail "other tiles the second time"
cmp "$sandbox/first/sheet.svg" "$sandbox/second/sheet.svg" || fail "another sheet the second time"
rsvg-convert "$sandbox/first/sheet.svg" -o "$sandbox/stone.png"
size() { od -An -j 16 -N 8 -t x1 "$1"; }
[[ $(size "$sandbox/stone.png") == "$(size "$sandbox/first/labels.png")" ]] || fail "sheet and map differ in size"
if /usr/bin/python3 scripts/stone_tiles.py jobs/photos/flagstones.jpg 2>/dev/null; then fail "takes one argument"; fi
echo "ok"
