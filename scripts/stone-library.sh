#!/usr/bin/env bash
# scripts/stone-library.sh [LIB.h5]: makes a library of 732 grey tiles of stone for mosaics (two more are too small). The default is
# out/stones.h5.
# The stone is that of jobs/photos/flagstones.jpg; the tiles' sheet stays in the folder LIB.parts.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly tessera=${TESSERA:-build/release/src/cli/tessera}
readonly library=${1:-out/stones.h5}
readonly parts=${library%.h5}.parts

if [[ $# -gt 1 || $library != *.h5 ]]; then
  echo "usage: scripts/stone-library.sh [LIB.h5]" >&2
  exit 2
fi
[[ -x $tessera ]] || scripts/build.sh --without-tests tessera
/usr/bin/python3 scripts/stone_tiles.py jobs/photos/flagstones.jpg "$parts"
rsvg-convert "$parts/sheet.svg" -o "$parts/stone.png"
"$tessera" library extract "$parts/stone.png" --labels "$parts/labels.png" -o "$library"
