#!/usr/bin/env bash
# scripts/tile-library.sh [LIB.h5]: makes a library of some thousand tiles for mosaics from Debian's packages and the photos of jobs/. The
# default is out/mosaic_tiles.h5; its sources stay in the folder LIB.parts.
# It has all of openclipart (public domain), the emoji of Google's Noto (SIL Open Font License), and stones and coins from photos.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly tessera=${TESSERA:-build/release/src/cli/tessera}
readonly font=/usr/share/fonts/truetype/noto/NotoColorEmoji.ttf
readonly library=${1:-out/mosaic_tiles.h5}
readonly parts=${library%.h5}.parts

if [[ $# -gt 1 || $library != *.h5 ]]; then
  echo "usage: scripts/tile-library.sh [LIB.h5]" >&2
  exit 2
fi
for package in openclipart-svg fonts-noto-color-emoji python3-fonttools; do
  if ! dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed; then
    echo "tile-library: install $package first: apt-get install --no-install-recommends $package" >&2
    exit 1
  fi
done
[[ -x $tessera ]] || scripts/build.sh --without-tests tessera

mkdir -p "$parts"
started=$SECONDS
"$tessera" library build /usr/share/openclipart/svg -o "$parts/openclipart.h5"
/usr/bin/python3 scripts/emoji_glyphs.py "$font" "$parts/emoji"
"$tessera" library build "$parts/emoji" --embed -o "$parts/emoji.h5"
"$tessera" library extract jobs/photos/flagstones.jpg --element-px 140 -o "$parts/flagstones.h5"
"$tessera" library extract jobs/photos/coins.png --element-px 45 -o "$parts/coins.h5"
"$tessera" library merge "$parts"/{openclipart,emoji,flagstones,coins}.h5 -o "$library"
echo "made in $((SECONDS - started)) s"
