#!/usr/bin/env bash
# puzzle_test.sh TESSERA MPIRUN NEW_FOLDER: tessera puzzle, from a picture to its pieces and from them to the picture.
set -uo pipefail
tessera=$1
# shellcheck disable=SC2034 # support/ranks.sh
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

enter_folder
echo "<svg xmlns='http://www.w3.org/2000/svg' width='640' height='480'><rect width='640' height='480' fill='#48c'/>
  <circle cx='290' cy='200' r='160' fill='#fc4'/><path d='M160 220q130 130 260 0' stroke='#000' stroke-width='9'/>
  <rect x='20' y='400' width='600' height='60' fill='#3a4'/></svg>" >sun.svg
rsvg-convert sun.svg -o sun.png

run 0 puzzle make sun.png --pieces 12 --out jigsaw
expect_silence "a warning of a good picture"
grep -qx 'jigsaw: 12 pieces of a picture of 640 x 480 px' output || fail "does not say what it made"
grep -qx 'next: tessera library build jigsaw/pieces -o jigsaw.h5 --keep-rectangles' output || fail "does not say what is next"
[[ $(find jigsaw/pieces -name 'piece_*.png' | wc -l) -eq 12 ]] || fail "not 12 pieces"
run 0 puzzle make sun.png --pieces 12 --out again
diff -r jigsaw again || fail "another cut of the same seed"
run 0 puzzle make sun.png --pieces 12 --seed 2 --out other
! cmp -s jigsaw/truth/pieces.geojson other/truth/pieces.geojson || fail "the same cut of another seed"
run 2 puzzle make sun.png --pieces 12 --out jigsaw
expect_word 'jigsaw: is there already, and holds something; allowed: a new folder'
run 2 puzzle make sun.png --pieces 1 --out one
expect_word '--pieces: found 1, allowed: from 2 to 2000'
run 2 puzzle make sun.png --pieces 400 --out dust
expect_word 'sun.png: found 640 x 480 px, which gives pieces of 27 px; allowed: 40 px or more'
run 2 puzzle make none.png
expect_word 'none.png: '
[[ ! -e one && ! -e dust && ! -e none_puzzle ]] || fail "left something behind"
echo "ok make"

run 0 library build jigsaw/pieces -o jigsaw.h5 --keep-rectangles
# Larger than the pieces are: their scale is not known.
run 0 puzzle solve jigsaw.h5 --size 960,720 --truth jigsaw/truth
expect_silence "a warning of a puzzle that was solved"
grep -q '^jigsaw.toml: 12 of 12 pieces on 960 x 720 px, ' output || fail "does not say what it laid"
grep -q '^by jigsaw/truth: 12 of 12 right' output || fail "not as it was cut"
grep -q '12 pieces' output || fail "no collage of all pieces"
[[ -s out/jigsaw/collage.png && -s out/jigsaw/manifest.json ]] || fail "no picture"
python3 - <<'PYTHON' || fail "the pieces do not lie where they were laid"
import json, struct
pieces = json.load(open("out/jigsaw/pieces.geojson"))["features"]
start = json.load(open("jigsaw_pieces.geojson"))["features"]
assert len(pieces) == 12
def poses(features):
    return [struct.pack("4f", *feature["properties"]["canvas_from_shape"]) for feature in features]
assert poses(pieces) == poses(start)
PYTHON
mkdir first && cp jigsaw.toml jigsaw_pieces.geojson out/jigsaw/pieces.geojson first
rm -r jigsaw.toml jigsaw_pieces.geojson out/jigsaw
run_on_ranks 3 0 puzzle solve jigsaw.h5 --size 960,720 --quiet
for file in jigsaw.toml jigsaw_pieces.geojson; do cmp $file first/$file || fail "another $file on three ranks"; done
cmp out/jigsaw/pieces.geojson first/pieces.geojson || fail "another result on three ranks"
echo "ok solve"

run 0 puzzle solve jigsaw.h5 --truth jigsaw/truth --job loose.toml --job-only
grep -q '^by jigsaw/truth: 12 of 12 right' output || fail "not as it was cut, without a frame"
grep -q '^next: tessera collage loose.toml$' output || fail "does not say what to type next"
[[ ! -e out/loose ]] || fail "--job-only runs"
run 2 puzzle solve jigsaw.h5 --size 640,480 --job loose.toml --job-only
expect_word 'is there already, with another content; --replace'
run 0 puzzle solve jigsaw.h5 --size 640,480 --scale 1 --job loose.toml --job-only --replace
grep -q '^size_px = \[640, 480\]' loose.toml || fail "not replaced"
echo 'seed = 1' >mine.toml
run 2 puzzle solve jigsaw.h5 --job mine.toml --job-only --replace
expect_word 'mine.toml: is there and is not of tessera puzzle solve; give another name with --job'
[[ $(cat mine.toml) == 'seed = 1' && ! -e mine_pieces.geojson ]] || fail "a foreign file was replaced"
run 2 puzzle solve jigsaw.h5 --job jigsaw.h5 --job-only --replace
expect_word 'jigsaw.h5: is there and is not of tessera puzzle solve'
run 2 puzzle solve jigsaw.h5 --size 20000,20000 --scale 0.01 --job huge.toml --job-only
expect_word 'times the area of all pieces, allowed: 100 times or less'
run 2 puzzle solve jigsaw.h5 --scale 100 --job huge.toml --job-only
expect_word 'allowed: from 16 to 20000 px (--scale K)'
run 2 puzzle solve jigsaw.h5 --truth nowhere --job huge.toml --job-only
expect_word 'nowhere'
[[ ! -e huge.toml && ! -e huge_pieces.geojson ]] || fail "left something behind"
echo "ok without a frame"

rm jigsaw/pieces/piece_005.png
run 0 library build jigsaw/pieces -o gap.h5 --keep-rectangles
run 0 puzzle solve gap.h5 --size 640,480 --scale 1 --truth jigsaw/truth --job-only
expect_word 'the frame is not full: pieces are missing'
grep -q '^by jigsaw/truth: 11 of 11 right' output || fail "the others are not where they belong"
run 0 puzzle solve gap.h5 --size 640,480 --truth jigsaw/truth --job unknown.toml --job-only
expect_word 'does not lie in the frame, the canvas is as large as it; where pieces are missing or foreign, --scale'
grep -q '^by jigsaw/truth: 11 of 11 right' output || fail "a frame of another size spoils what fits"
cp other/pieces/piece_001.png jigsaw/pieces/stranger.png
run 0 library build jigsaw/pieces -o stranger.h5 --keep-rectangles
run 0 puzzle solve stranger.h5 --size 640,480 --scale 1 --truth jigsaw/truth --job-only
expect_word '1 of 12 pieces found no place: stranger'
echo "ok pieces missing or foreign"

run 2 puzzle solve none.h5
expect_word 'none.h5'
run 2 puzzle
expect_word 'tessera puzzle --help'
[[ ! -e none.toml ]] || fail "left a job behind"

echo "<svg xmlns='http://www.w3.org/2000/svg' width='99' height='99'><rect x='20' y='30' width='60' height='40'/></svg>" >brick.svg
run 2 library build brick.svg -o brick.h5
expect_word 'a plain rectangle; take the background away, if that is what it is, or keep it (--keep-rectangles)'
run 0 library build brick.svg -o brick.h5 --keep-rectangles
run 2 puzzle solve brick.h5
expect_word 'brick.h5: found no two pieces that fit beside each other'
run 2 puzzle solve brick.h5 --scale nan
expect_word '--scale: found nan, allowed: a number'
echo "ok errors"
