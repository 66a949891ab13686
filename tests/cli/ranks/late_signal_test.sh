#!/usr/bin/env bash
# late_signal_test.sh TESSERA MPIRUN NEW_FOLDER: signals and limits that hit a run while it draws its result.
# The result stays, no half-written or worse picture is left, and drawing goes on to the same bytes.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/restart_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../restart_fixture.sh"
# shellcheck source=tests/cli/drawing_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../drawing_fixture.sh"

make_drawn_job 10 3000

# end_while_drawing SIGNAL RANKS OUT
end_while_drawing() {
  start "$2" "$3"
  wait_for_manifest "$3"
  kill -s "$1" "$started" 2>/dev/null
  wait "$started"
  code=$?
  [[ ! -e $3/collage.png ]] || fail "$1: drawn before the signal came; the picture is too small for this machine"
  [[ -z $(find "$3" -name '*.tmp') ]] || fail "$1: a half-written file"
}

for signal in INT TERM USR2; do
  end_while_drawing "$signal" 1 "$signal"
  [[ $code == 75 ]] || fail "$signal: exit code $code"
  [[ ! -e $signal/checkpoint.h5 ]] || fail "$signal: a checkpoint of a finished run"
  grep -qF "collage finished, drawing interrupted: tessera draw $signal goes on" errors ||
    fail "$signal: does not say how"
done
"$tessera" draw INT >output 2>errors || fail "tessera draw"
expect_drawn INT
start 3 TERM --resume
expect_end 0 "--resume of a finished collage"
grep -q 'nothing is left to compute' output || fail "--resume computes"
expect_drawn TERM
start 1 TERM --resume
expect_end 0 "--resume of a drawn collage"
expect_drawn TERM
echo "ok signals"

# mpirun sends its ranks SIGKILL two seconds after TERM.
end_while_drawing TERM 3 by_mpirun
"$tessera" draw by_mpirun >output 2>errors || fail "tessera draw after mpirun's end"
expect_drawn by_mpirun
echo "ok mpirun"

# tessera draw itself is stopped: the first picture may be there, the second is not.
rm -f USR2/collage.*
"$tessera" draw USR2 --width 20000 --png >output 2>errors &
started=$!
until [[ -e USR2/collage.png.tmp ]] || ! kill -0 "$started" 2>/dev/null; do sleep 0.005; done
kill -s USR2 "$started"
wait "$started"
code=$?
[[ $code == 75 ]] || fail "draw: exit code $code"
grep -q 'drawing interrupted: the same command goes on' errors || fail "draw: does not say how to go on"
[[ -z $(find USR2 -name 'collage*') ]] || fail "draw: a half-written picture"
"$tessera" draw USR2 >output 2>errors || fail "draw after draw"
expect_drawn USR2
echo "ok draw"

# Other sizes and formats, a library that moved, and refused options.
"$tessera" draw USR2 --width 500 --background '#102030' --pdf --png >output 2>errors || fail "another size"
[[ $(od -An -tu1 -j16 -N8 USR2/collage.png | xargs) == "0 0 1 244 0 0 1 119" ]] || fail "not 500 x 375"
[[ $(head -c 5 USR2/collage.pdf) == %PDF- ]] || fail "no PDF"
cmp expected/collage.svg USR2/collage.svg || fail "the SVG was not asked for"
grep -qF '{"file":"collage.png","width_px":500,"width_mm":0.0,"dpi":300.0,"background":"#102030"' USR2/manifest.json ||
  fail "manifest"
mv own.h5 moved.h5
expect_refused() { # TEXT ARGUMENT...
  local text=$1
  shift
  "$tessera" draw "$@" >output 2>errors
  [[ $? == 2 ]] || fail "not refused: $*"
  grep -qF -- "$text" errors || fail "another error than: $text"
}
expect_refused 'own.h5: no such file' USR2
"$tessera" draw USR2 --library moved.h5 >output 2>errors || fail "the library that moved"
expect_drawn USR2
cp -r drawings fewer
rm fewer/star.svg
"$tessera" library build fewer -o own.h5 >output 2>errors || fail "the other library"
expect_refused 'own.h5: not the library that the collage was made from' USR2
grep -qE 'content has the digest [0-9a-f]{16}, that of the collage.s library was [0-9a-f]{16}, built or changed since; the collage was made by tessera [0-9.]+, commit [0-9a-z-]+; --library FILE says where' errors ||
  fail "another message for a library that was built anew"
then=$(grep -o '"library":{[^}]*}' USR2/manifest.json | grep -o '"digest":"[0-9a-f]*"' | cut -d'"' -f4)
grep -qF "library was $then" errors || fail "another digest than in the manifest, $then"
mv USR2/card.json card.json
expect_refused 'built or changed since; --library FILE' USR2
mv card.json USR2/card.json
mv moved.h5 own.h5
echo >>USR2/pieces.geojson
expect_refused 'USR2/pieces.geojson: not the file that manifest.json was written with' USR2
expect_refused 'nowhere/manifest.json: not found' nowhere
expect_refused '--width' expected --width 5
expect_refused '--background' expected --background red
echo "ok draw's options"

# timeout(1) signals the program and then its group: two signals at once.
for ((i = 0; i < 25; ++i)); do
  rm -rf twice
  start 1 twice --quiet --set improve.seconds=100 --set improve.trials=0
  until grep -q 'rank 0 ' twice/run.log 2>/dev/null || ! kill -0 "$started"; do sleep 0.01; done
  sleep 0.1
  for _ in 1 2 3 4; do kill -s TERM "$started"; done
  expect_end 75 "several signals at once"
done
echo "ok several signals at once"

# If the originals are gone, thumbnails are drawn, and counted on stderr and in the card.
mv drawings gone
start 1 gone_artwork
expect_end 0 "without originals"
grep -qE 'warning: gone_artwork: [0-9]+ pieces? drawn from thumbnails: ' errors ||
  fail "does not say that they are thumbnails"
grep -q 'drawn from thumbnail  *[0-9]* piece' gone_artwork/card.txt || fail "card without thumbnails"
echo "ok lost originals"
