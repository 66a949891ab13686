#!/usr/bin/env bash
# scripts/puzzle-library.sh tabs|polygons|tangram LIB.h5: makes the pieces of the gallery's puzzles (jobs/puzzle.toml and others). They are
# cut from a photo of jobs/photos or drawn, then mixed and turned.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly tessera=build/release/src/cli/tessera
kind=${1:?tabs, polygons or tangram}
library=${2:?the library to write}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# drawing FILE COLOUR TURN_DEG X,Y...: draws a turned polygon with a rim; one unit is 100 px.
drawing() {
  local file=$1 colour=$2 turn=$3
  shift 3
  printf '%s\n' "$@" | awk -F, -v colour="$colour" -v turn="$turn" '
    BEGIN { t = turn * atan2(0, -1) / 180 }
    { x[NR] = 100 * ($1 * cos(t) - $2 * sin(t)); y[NR] = 100 * ($1 * sin(t) + $2 * cos(t)) }
    END {
      left = right = x[1]; top = low = y[1]
      for (k = 2; k <= NR; ++k) {
        if (x[k] < left) left = x[k]; if (x[k] > right) right = x[k]
        if (y[k] < top) top = y[k]; if (y[k] > low) low = y[k]
      }
      printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.2f\" height=\"%.2f\">", right - left + 4, low - top + 4
      printf "<path fill=\"%s\" d=\"", colour
      for (k = 1; k <= NR; ++k) printf "%s%.4f,%.4f", k == 1 ? "M" : " ", x[k] - left + 2, y[k] - top + 2
      print "Z\"/></svg>"
    }' >"$folder/pieces/$file.svg"
}

tangram() {
  mkdir "$folder/pieces"
  drawing 1_large '#c8452f' 20 0,0 4,0 2,2
  drawing 2_large '#e58a2f' 75 0,0 2,2 0,4
  drawing 3_middle '#3f7d4e' 200 4,2 4,4 2,4
  drawing 4_small '#2f6fa8' 310 4,0 4,2 3,1
  drawing 5_small '#7a4f9a' 130 2,2 3,3 1,3
  drawing 6_square '#e3bf45' 10 2,2 3,1 4,2 3,3
  drawing 7_parallelogram '#3aa6a0' 260 0,4 1,3 3,3 2,4
}

case $kind in
  tabs) "$tessera" puzzle make jobs/photos/chelsea.png --pieces 36 --out "$folder" ;;
  polygons) "$tessera" puzzle make jobs/photos/flagstones.jpg --pieces 18 --cut polygons --out "$folder" ;;
  tangram) tangram ;;
  *)
    echo "scripts/puzzle-library.sh: found $kind, allowed: tabs, polygons, tangram" >&2
    exit 2
    ;;
esac
"$tessera" library build "$folder/pieces" -o "$library" --puzzle --embed
