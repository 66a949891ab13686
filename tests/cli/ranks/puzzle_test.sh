#!/usr/bin/env bash
# puzzle_test.sh TESSERA MPIRUN NEW_FOLDER SAWN_PIECES: tessera puzzle, from a picture to its pieces, and from them back to the picture.
set -uo pipefail
tessera=$1
# shellcheck disable=SC2034 # support/ranks.sh
mpirun=$2
folder=$3
sawn_pieces=$4
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"
photo=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../../jobs/photos" && pwd)/chelsea.png

# A slow run also prints progress, so only warnings count.
expect_no_warning() { ! grep -q warning errors || fail "$1"; }

enter_folder
echo "<svg xmlns='http://www.w3.org/2000/svg' width='640' height='480'><rect width='640' height='480' fill='#48c'/>
  <circle cx='290' cy='200' r='160' fill='#fc4'/><path d='M160 220q130 130 260 0' stroke='#000' stroke-width='9'/>
  <rect x='20' y='400' width='600' height='60' fill='#3a4'/></svg>" >sun.svg
rsvg-convert sun.svg -o sun.png

run 0 puzzle make sun.png --pieces 12 --out jigsaw
expect_silence "a warning of a good picture"
grep -qx 'jigsaw: 12 pieces of a picture of 640 x 480 px' output || fail "does not say what it made"
grep -qx 'next: tessera library build jigsaw/pieces -o jigsaw.h5 --puzzle' output || fail "does not say what is next"
[[ $(find jigsaw/pieces -name 'piece_*.png' | wc -l) -eq 12 ]] || fail "not 12 pieces"
run 0 puzzle make sun.png --pieces 12 --out again
diff -r jigsaw again || fail "another cut of the same seed"
run 0 puzzle make sun.png --pieces 12 --seed 2 --out other
! cmp -s jigsaw/truth/pieces.geojson other/truth/pieces.geojson || fail "the same cut of another seed"
run 2 puzzle make sun.png --pieces 12 --out jigsaw
expect_word 'jigsaw: exists already and is not empty; allowed: a new or an empty folder'
run 2 puzzle make sun.png --pieces 1 --out one
expect_word '--pieces: found 1, allowed: from 2 to 2000'
run 2 puzzle make sun.png --pieces 400 --out dust
expect_word 'sun.png: found 640 x 480 px, which gives pieces of 27 px; allowed: 40 px or more'
run 2 puzzle make none.png
expect_word 'none.png: '
[[ ! -e one && ! -e dust && ! -e none_puzzle ]] || fail "left something behind"
# An output that cannot be written is found before the picture is read.
run 2 puzzle make none.png --out sun.png/jigsaw
expect_word 'cannot write into the folder sun.png/jigsaw: sun.png is a file; give another output'
echo "ok make"

# end_of SIGNAL SECONDS COMMAND...: sends SIGNAL after SECONDS. tessera ends within 2 s, by that signal, and leaves nothing behind.
end_of() {
  timeout -s "$1" -k 2 "$2" "$tessera" "${@:3}" >output 2>errors
  code=$?
  [[ $code -eq 124 ]] || fail "$1 after $2 s: exit code $code: it had ended, or did not end within 2 s: ${*:3}"
  grep -q 'tessera: interrupted' errors || fail "does not say that it was interrupted"
}
rsvg-convert -w 6400 -h 4800 sun.svg -o large.png
for seconds in 0.7 1.5; do
  end_of TERM $seconds puzzle make large.png --pieces 200 --out made/large
  [[ ! -e made ]] || fail "puzzle make: left something behind after $seconds s"
done
# Two runs write into one folder: one is refused.
"$tessera" puzzle make large.png --pieces 200 --out made >/dev/null 2>&1 &
making=$!
until [[ -e made/run.lock ]] || ! kill -0 $making 2>/dev/null; do sleep 0.02; done
run 2 puzzle make sun.png --pieces 12 --out made
expect_word 'made: another run is at work here'
kill $making && wait $making
[[ ! -e made ]] || fail "left something behind"
echo "ok make alone"

run 0 library build jigsaw/pieces -o jigsaw.h5 --puzzle
# The frame is larger than the cut picture: the scale of the pieces is unknown.
run 0 puzzle solve jigsaw.h5 --size 960,720 --truth jigsaw/truth
expect_no_warning "a warning of a puzzle that was solved"
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
expect_word 'exists with other content; --replace'
run 0 puzzle solve jigsaw.h5 --size 640,480 --scale 1 --job loose.toml --job-only --replace
grep -q '^size_px = \[640, 480\]' loose.toml || fail "not replaced"
echo 'seed = 1' >mine.toml
run 2 puzzle solve jigsaw.h5 --job mine.toml --job-only --replace
expect_word 'mine.toml: exists and was not made by tessera puzzle solve; give another name with --job'
[[ $(cat mine.toml) == 'seed = 1' && ! -e mine_pieces.geojson ]] || fail "a foreign file was replaced"
run 2 puzzle solve jigsaw.h5 --job jigsaw.h5 --job-only --replace
expect_word 'jigsaw.h5: exists and was not made by tessera puzzle solve'
run 2 puzzle solve jigsaw.h5 --size 20000,20000 --scale 0.01 --job huge.toml --job-only
expect_word 'times the area of all pieces, allowed: 100 times or less'
run 2 puzzle solve jigsaw.h5 --scale 100 --job huge.toml --job-only
expect_word 'allowed: from 16 to 20000 px (--scale K)'
run 0 puzzle solve jigsaw.h5 --truth jigsaw/truth --job loose.toml --job-only --replace --quiet
[[ $(cat output) == 'by jigsaw/truth: 12 of 12 right'* ]] || fail "--quiet leaves out what --truth asks for, or says more"
run 2 puzzle solve jigsaw.h5 --truth nowhere --job huge.toml --job-only
expect_word 'nowhere'
[[ ! -e huge.toml && ! -e huge_pieces.geojson ]] || fail "left something behind"
run 2 puzzle solve jigsaw.h5 --out sun.png/result --job huge.toml
expect_word 'cannot write into the folder sun.png/result: sun.png is a file; give another output'
[[ ! -e huge.toml ]] || fail "it was solved before the result's folder was tried"
run 1 puzzle solve jigsaw.h5 --job nowhere/huge.toml --job-only
expect_word 'cannot write nowhere/huge.toml: the folder nowhere: No such file or directory'
echo "ok without a frame"

# within_frame JOB WIDTH HEIGHT PX PIECES: PIECES pieces are laid, and none reaches more than PX beyond the frame.
within_frame() {
  python3 - "$@" <<'PYTHON'
import json, sys
job, width, height, most, pieces = sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), float(sys.argv[4]), int(sys.argv[5])
features = json.load(open(job + "_pieces.geojson"))["features"]
rings = [p for feature in features for p in feature["geometry"]["coordinates"][0]]
beyond = max(max(-x, x - width, -y, y - height) for x, y in rings)
assert len(features) == pieces, "%d pieces" % len(features)
assert beyond <= most, "%.2f px beyond the frame" % beyond
PYTHON
}

# Sawn and scanned pieces: a px smaller all round, at three quarters of the size. The program grows them, and all fit.
"$sawn_pieces" jigsaw/pieces sawn 1 0.75 || fail "no sawn pieces"
run 0 library build sawn -o sawn.h5 --puzzle
for scale in '--scale 1.33333' ''; do
  # shellcheck disable=SC2086
  run 0 puzzle solve sawn.h5 --size 640,480 $scale --job-only --replace
  expect_no_warning "a warning of sawn pieces that fit $scale"
  grep -qE '^sawn.toml: 12 of 12 pieces .* scale 1.3[234].*; they are [01].[0-9]* px smaller all round than they were cut' output ||
    fail "sawn pieces are not all laid $scale"
  within_frame sawn 640 480 0.5 12 || fail "sawn pieces leave the frame $scale"
done
echo "ok sawn pieces"

# The straight sides of polygons do not show by how much they must grow. The pieces are eroded, or traced at three quarters of the size.
run 0 puzzle make sun.png --pieces 12 --cut polygons --seed 3 --out shards
"$sawn_pieces" shards/pieces eroded 1 1 || fail "no eroded pieces"
"$sawn_pieces" shards/pieces smaller 0 0.75 || fail "no smaller pieces"
run 0 library build eroded -o eroded.h5 --puzzle
run 0 library build smaller -o smaller.h5 --puzzle
for solving in 'eroded --scale 1' eroded 'smaller --scale 1.33333' smaller; do
  read -r -a words <<<"$solving"
  run 0 puzzle solve "${words[0]}.h5" --size 640,480 "${words[@]:1}" --truth shards/truth --job-only --replace
  expect_no_warning "a warning of polygons that fit: $solving"
  grep -q '^by shards/truth: 12 of 12 right' output || fail "polygons are not as they were cut: $solving"
  within_frame "${words[0]}" 640 480 1 12 || fail "polygons leave the frame: $solving"
done
cp other/pieces/piece_001.png eroded/stranger.png
run 0 library build eroded -o mixed.h5 --puzzle
run 3 puzzle solve mixed.h5 --size 640,480 --truth shards/truth --job-only
expect_word '1 of 13 pieces found no place in the frame: stranger'
grep -q '^by shards/truth: 12 of 13 right' output || fail "a stranger spoils polygons that were eroded"
within_frame mixed 640 480 1 12 || fail "polygons beside a stranger leave the frame"
echo "ok eroded polygons"

rm jigsaw/pieces/piece_005.png
run 0 library build jigsaw/pieces -o gap.h5 --puzzle
run 0 puzzle solve gap.h5 --size 640,480 --scale 1 --truth jigsaw/truth --job-only
expect_word 'the frame is not full: pieces are missing, they are smaller than they were cut, or the frame has another shape'
grep -q '^by jigsaw/truth: 11 of 11 right' output || fail "the others are not where they belong"
run 0 puzzle solve gap.h5 --size 640,480 --truth jigsaw/truth --job unknown.toml --job-only
expect_word 'the frame is not full: pieces are missing, they are smaller than they were cut, or the frame has another shape'
grep -q '^by jigsaw/truth: 11 of 11 right' output || fail "a missing piece hides how large the others are"
within_frame unknown 640 480 1 11 || fail "they leave the frame"
cp other/pieces/piece_001.png jigsaw/pieces/stranger.png
run 0 library build jigsaw/pieces -o stranger.h5 --puzzle
# A piece without a place is named, and the advice suits the given options. The collage is made, and the exit code is 3.
run 3 puzzle solve stranger.h5 --size 640,480 --scale 1 --truth jigsaw/truth
expect_word '1 of 12 pieces found no place in the frame: stranger; the frame may have another shape than the puzzle: without --size and --frame all that fits together is laid'
! grep -q -- '--scale' errors || fail "advises --scale, which was given"
grep -q '^by jigsaw/truth: 11 of 12 right' output || fail "a stranger spoils what fits"
[[ -s out/stranger/collage.png ]] || fail "no picture"
run 3 puzzle solve stranger.h5 --size 640,480 --job unscaled.toml --job-only
expect_word '1 of 12 pieces found no place in the frame: stranger; the frame may have another shape than the puzzle: '
expect_word '; if pieces are missing or foreign, give the size of the others with --scale'
within_frame unscaled 640 480 1 11 || fail "they leave the frame"
run_on_ranks 2 3 puzzle solve stranger.h5 --job ranks.toml --quiet
expect_word '1 of 12 pieces found no place: stranger'
! grep -q 'in the frame' errors || fail "speaks of a frame that was not given"
# A frame that is too small for pieces of known scale.
run 3 puzzle solve jigsaw.h5 --size 420,480 --scale 1 --job small.toml --job-only
expect_word ' pieces found no place in the frame: piece_'
# All pieces fit each other: the frame has another shape.
expect_word '; without a frame all of them fit each other: the frame of 420 x 480 px has another shape or size than the puzzle, which takes '
grep -qE 'takes (639|640|641) x (479|480|481) px|takes (479|480|481) x (639|640|641) px' errors || fail "not the puzzle's size"
placed=$(sed -n 's/^small.toml: \([0-9]*\) of 12 pieces on 420 x 480 px.*/\1/p' output)
((placed >= 6)) || fail "$placed pieces in a frame that has room for eight"
within_frame small 420 480 2 "$placed" || fail "pieces leave a frame that is too small"
run 3 puzzle solve jigsaw.h5 --size 640,640 --job square.toml --job-only
expect_word 'the frame of 640 x 640 px has another shape or size than the puzzle'
! grep -q -- '--scale' errors || fail "advises --scale where the frame has another shape"
echo "ok pieces missing or foreign"

# A shape is cut along its outline, in its colours. It is also the frame, at any size.
echo "<svg xmlns='http://www.w3.org/2000/svg' width='400' height='300'><path fill='#3a4'
  d='M200 10C 290 10 390 80 390 170C 390 250 300 290 200 290C 100 290 10 250 10 190C 10 90 90 10 200 10Z'/>
  <circle cx='150' cy='120' r='70' fill='#fc4'/></svg>" >island.svg
run 0 puzzle make island.svg --pieces 10 --out 'an island'
grep -q '^an island: [0-9]* pieces of a picture of 1600 x 1200 px$' output || fail "another size than is documented"
grep -q "^next: tessera library build 'an island/pieces' -o 'an island.h5' --puzzle$" output ||
  fail "the next command does not run as it is printed"
grep -q "^      tessera puzzle solve 'an island.h5' --frame 'an island/frame.svg' --size 1600,1200$" output ||
  fail "does not say what fills the frame"
(PATH=$(dirname "$tessera"):$PATH && eval "$(sed -n 's/^next: //p' output)") >/dev/null || fail "its next command does not run"
pieces=$(find 'an island/pieces' -name '*.png' | wc -l)
run 0 puzzle solve 'an island.h5' --frame island.svg --size 400,500 --truth 'an island/truth' --job island.toml
expect_no_warning "a warning of a shape that was solved"
grep -q "^island.toml: $pieces of $pieces pieces on 400 x 300 px, \(99.9\|100.0\)" output || fail "the frame is not full"
grep -q "^by an island/truth: $pieces of $pieces right" output || fail "the shape is not as it was cut"
grep -q '^file = "island.svg"$' island.toml || fail "the job's canvas is not the frame"
[[ -s out/island/collage.png ]] || fail "no picture of the shape"
run 0 puzzle solve 'an island.h5' --frame island.svg --job large.toml --job-only
grep -q "^large.toml: $pieces of $pieces pieces on 160[0-9] x 120[0-9] px" output || fail "a frame without a size is another"
echo "<svg xmlns='http://www.w3.org/2000/svg' width='99' height='99'><rect x='9' y='9' width='30' height='40'/>
  <rect x='59' y='9' width='30' height='40'/></svg>" >two.svg
run 2 puzzle make two.svg
expect_word 'two.svg: found 2 outlines, of parts or holes; allowed: one silhouette without holes'
run 2 puzzle solve 'an island.h5' --frame two.svg --job two.toml --job-only
expect_word 'two.svg: found 2 outlines'
[[ ! -e two_puzzle && ! -e two.toml ]] || fail "left something behind"
echo "ok shapes"

# Pieces that look alike: a tangram, whose seven pieces fill many frames, each in several ways.
mkdir tangram
python3 - <<'PYTHON'
import math
pieces = [[(0, 0), (4, 0), (2, 2)], [(0, 0), (2, 2), (0, 4)], [(4, 2), (4, 4), (2, 4)], [(4, 0), (4, 2), (3, 1)],
          [(2, 2), (3, 3), (1, 3)], [(2, 2), (3, 1), (4, 2), (3, 3)], [(0, 4), (1, 3), (3, 3), (2, 4)]]
def drawing(points):
    x, y = min(p[0] for p in points), min(p[1] for p in points)
    points = [(p[0] - x + 9, p[1] - y + 9) for p in points]
    size = "width='%g' height='%g'" % (max(p[0] for p in points) + 9, max(p[1] for p in points) + 9)
    return "<svg xmlns='http://www.w3.org/2000/svg' %s><path d='M%sZ'/></svg>" % (size, " ".join("%.4f,%.4f" % p for p in points))
for k, piece in enumerate(pieces):
    c, s = 100 * math.cos(0.7 * k), 100 * math.sin(0.7 * k)
    open("tangram/piece_%d.svg" % k, "w").write(drawing([(c * x - s * y, s * x + c * y) for x, y in piece]))
r = math.sqrt(2)
house = [(-r, 0), (r, 0), (r, 2 * r), (2 * r, 2 * r), (0, 4 * r), (-2 * r, 2 * r), (-r, 2 * r)]
open("house.svg", "w").write(drawing([(100 * x, 100 * y) for x, y in house]))
PYTHON
cp tangram/piece_0.svg tangram/piece_1.svg
cp tangram/piece_3.svg tangram/piece_4.svg
run 0 library build tangram -o tangram.h5 --puzzle
grep -q '7 shapes$' output || fail "pieces that are alike are left out"
run 0 puzzle solve tangram.h5 --size 400,400
expect_no_warning "a warning of a tangram's square"
grep -q '^tangram.toml: 7 of 7 pieces on 400 x 400 px, \(99.[5-9]\|100.[0-4]\)' output || fail "the square is not full"
run 0 puzzle solve tangram.h5 --frame house.svg --job house.toml
expect_no_warning "a warning of a tangram's house"
grep -q '^house.toml: 7 of 7 pieces on [0-9]* x [0-9]* px, \(99.[5-9]\|100.[0-4]\)' output || fail "the house is not full"
grep -q '^  coverage  *\(99.[0-9]*\|100.00\) %' output || fail "the collage does not cover the house"
run 0 library build tangram -o fewer.h5
grep -q '5 shapes, 2 merged' output || fail "without --puzzle the pieces that are alike are not left out"
run 0 puzzle solve fewer.h5 --size 400,400 --scale 1 --job-only
expect_word 'tessera: warning: the frame is not full: pieces are missing'
echo "ok pieces that are alike"

# Rectangles of one size: only their pictures show their places.
run 0 puzzle make "$photo" --pieces 20 --cut rectangles --out grid
run 0 library build grid/pieces -o grid.h5 --puzzle
run 0 puzzle solve grid.h5 --size 902,600 --truth grid/truth --job-only
expect_no_warning "a warning of a picture that was solved"
grep -q '^by grid/truth: 20 of 20 right' output || fail "not as their pictures say"
# The cloth around the coins shows little: pieces change places until all agree.
run 0 puzzle make "$(dirname "$photo")/coins.png" --pieces 12 --cut rectangles --out coins
run 0 library build coins/pieces -o coins.h5 --puzzle
run 0 puzzle solve coins.h5 --size 768,606 --truth coins/truth --job-only
grep -q '^by coins/truth: 12 of 12 right' output || fail "coins are not as their pictures say"
# Half of this picture is one grey: nothing shows the places of these pieces, and the program says so.
python3 - <<'PYTHON'
import math, struct, zlib
def chunk(kind, data): return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
rows = b""
for y in range(240):
    rows += b"\0" + b"".join(bytes([90] * 3) if x < 200 else bytes(int(127 + 120 * math.sin(x / a + y / b)) for a, b in ((9, 31), (23, 7), (-13, 17)))
                             for x in range(400))
open("grey.png", "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 400, 240, 8, 2, 0, 0, 0)) +
                             chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
PYTHON
run 0 puzzle make grey.png --pieces 15 --cut rectangles --out grey
run 0 library build grey/pieces -o grey.h5 --puzzle
run 0 puzzle solve grey.h5 --size 400,240 --job-only
grep -qE 'warning: [0-9]+ of 15 pieces have the same outline as others, and their pictures do not decide' errors ||
  fail "no doubt of pieces without a picture"
echo "ok pictures on the pieces"

# Without pictures, in a frame that they do not fill, the search takes long. Signals and the limit end it, and nothing is written.
for ranks in 1 2; do
  launch=()
  [[ $ranks -eq 1 ]] || launch=("$mpirun" --oversubscribe -n "$ranks")
  "${launch[@]}" "$tessera" puzzle solve grid.h5 --outlines-only --size 902,650 --job many.toml >output 2>errors &
  solving=$!
  sleep 2
  kill -0 $solving 2>/dev/null || fail "it ended before it was interrupted"
  before=$(date +%s%N)
  kill -TERM $solving
  wait $solving
  code=$?
  took_ms=$((($(date +%s%N) - before) / 1000000))
  [[ $ranks -gt 1 || $code -eq 75 ]] || fail "exit code $code after SIGTERM"
  ((took_ms < 4000)) || fail "it took $took_ms ms to end on $ranks ranks"
  expect_word 'unfinished, nothing was written: the same command starts again'
  [[ ! -e many.toml && ! -e many_pieces.geojson && ! -e out/many ]] || fail "left something behind"
done
run 75 puzzle solve grid.h5 --outlines-only --size 902,650 --job many.toml --time-limit 4
expect_word 'unfinished, nothing was written'
[[ ! -e many.toml ]] || fail "left a job behind"
echo "ok interruption"

run 2 puzzle solve none.h5
expect_word 'none.h5'
run 2 puzzle
expect_word 'tessera puzzle --help'
[[ ! -e none.toml ]] || fail "left a job behind"

echo "<svg xmlns='http://www.w3.org/2000/svg' width='99' height='99'><rect x='20' y='30' width='60' height='40'/></svg>" >brick.svg
run 2 library build brick.svg -o brick.h5
expect_word 'a plain rectangle; remove it if it is a background, or keep it as a shape (--keep-rectangles)'
run 0 library build brick.svg -o brick.h5 --keep-rectangles
run 2 puzzle solve brick.h5
expect_word 'brick.h5: found no two pieces that fit beside each other'
run 2 puzzle solve brick.h5 --scale nan
expect_word '--scale: found nan, allowed: a number'
echo "ok errors"
