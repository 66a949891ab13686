#!/usr/bin/env bash
# start_test.sh TESSERA MPIRUN NEW_FOLDER: a collage that goes on from an earlier one's pieces, grows outward, and keeps out of drawn
# letters.
# It is the same on one rank and on three. Wrong inputs are reported.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"

enter_folder
cat >letters.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="240" height="180">
<rect x="60" y="60" width="20" height="60" fill="#cc0022"/>
<circle cx="140" cy="90" r="22" fill="none" stroke="#cc0022" stroke-width="16"/></svg>
END
cat >job.toml <<'END'
[library]
file = 'own.h5'
[canvas]
size_px = [240, 180]
keep_out = 'letters.svg'
[pieces]
scale_px = [14, 50]
[improve]
trials = 2
[output]
width_px = 240
END
run 0 collage job.toml --out first --quiet
expect_silence "the first collage"
grep -q 'layer-keep-out' first/collage.svg && fail "letters are drawn unasked"
run 0 draw first --quiet --set output.keep_out=artwork
grep -q '<g id="layer-keep-out"' first/collage.svg || fail "letters are not drawn"

# Deletes some pieces, as the manual describes.
sed '3d;5d;6d' first/pieces.geojson >edited.geojson
kept=$(grep -c '"type":"Feature",' edited.geojson)
again=(collage job.toml --set start.pieces=edited.geojson --set start.keep=free --set start.grow=outward --quiet)
same_on_3_ranks one "${again[@]}"
expect_silence "pieces that a run placed stand well"
[[ $(grep -c '"type":"Feature",' one/pieces.geojson) -gt $kept ]] || fail "nothing was filled"

# Without improving, all kept pieces are still there, first and in their order.
run 0 collage job.toml --set start.pieces=edited.geojson --set improve.trials=0 --quiet --out locked
places() { grep -o '"shape":"[^"]*"\|"x_px":[^,]*\|"y_px":[^,]*' "$1" | head -$((3 * kept)); }
cmp <(places edited.geojson) <(places locked/pieces.geojson) || fail "the pieces that were kept"

run 2 collage job.toml --set start.pieces=first --out first
expect_word "pieces.geojson lies in the folder that the run writes; give another --out"
[[ -e first/manifest.json ]] || fail "a refused run took the result away"
sed 's/"shape":"[a-z]*/&_of_no_library/' edited.geojson >unknown.geojson
run 2 collage job.toml --set start.pieces=unknown.geojson --out none
expect_word 'unknown.geojson: feature 0: shape: found "'
# The plan refuses what the run would refuse.
run 2 plan job.toml --set start.pieces=unknown.geojson
expect_word 'unknown.geojson: feature 0: shape: found "'
run 2 collage job.toml --set canvas.seamless=both --set start.grow=outward --out none
run 0 collage job.toml --set start.pieces=edited.geojson --set 'canvas.size_px=[120, 90]' --set improve.trials=0 \
  --quiet --out small
expect_word "of start.pieces "
expect_word " lie outside the canvas, the first is number "
