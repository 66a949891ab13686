#!/usr/bin/env bash
# card_test.sh TESSERA NEW_FOLDER: tessera card gives the same figures for a result as its own card. For foreign polygons it gives the right
# figures, too.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

enter_folder
write_job '120, 90' '14, 60' 120

# value FILE KEY: prints the value in one line of indented JSON, without the comma.
value() { sed -n "s/^ *\"$2\": \([^,]*\),\?$/\1/p" "$1" | head -1; }

# The result's own card, within the three decimals of the polygons.
run 0 collage job.toml --out result --quiet --set stop.pieces=12
run 0 card result/pieces.geojson --canvas result/job.toml --json
expect_silence "a word about a good result"
for key in coverage_fraction overlap_fraction outside_fraction pieces distinct_shapes effective_shapes shared_boundary_fraction \
  largest_gap_radius_px size_balance dwarfs_fraction nearest_copy_px between_pieces_px alone_fraction; do
  awk -v own="$(value result/card.json "$key")" -v found="$(value output "$key")" -v key="$key" 'BEGIN {
    if (own == "" || (own == "null") != (found == "null")) exit 1
    differs = own - found; if (differs < 0) differs = -differs
    exit !(differs <= (key ~ /px$/ ? 0.1 : 0.003)) }' ||
    fail "$key: $(value output "$key") instead of $(value result/card.json "$key")"
done
# The job's range applies to all pieces, unless pieces have sizes of their own.
sed '/^scale_px/a sizes = "drawn"' job.toml >drawn.toml
{ cat job.toml && printf '[[shapes]]\nnames = ["*"]\nscale_px = [30, 50]\n'; } >tables.toml
run 0 card result/pieces.geojson --canvas job.toml
grep -q 'over 14.0 to 60.0 px' output || fail "another range than the job's: $(cat output)"
for job in drawn.toml tables.toml; do
  run 0 card result/pieces.geojson --canvas $job
  grep -q 'balance of sizes .*over [0-9.]* to [0-9.]* px' output || fail "no range with $job: $(cat output)"
  ! grep -q 'over 14.0 to 60.0 px' output || fail "the range of pieces.scale_px with $job"
done
# The range on the result's own card is the same as that of tessera card.
run 0 collage tables.toml --out tables --quiet --set stop.pieces=12
range() { sed -n 's/^  balance of sizes .*\(over [0-9.]* to [0-9.]* px\)).*/\1/p' "$1"; }
run 0 card tables/pieces.geojson --canvas tables/job.toml
[[ -n $(range output) && $(range output) == "$(range tables/card.txt)" ]] ||
  fail "another range than its own card's: $(range output) instead of $(range tables/card.txt)"
grep -q 'last_tenth_percent": null' result/card.json || fail "a curve of few rounds"
# Without exchanges the gain of the last tenth of the time is unknown.
run 0 collage job.toml --out improved --quiet --set stop.pieces=0 --set improve.trials=60 --set improve.relax=false
grep -q 'last_tenth_percent": -\?[0-9]' improved/card.json || fail "no word of the last tenth of the time"
grep -q '^    its last tenth  *[+-][0-9.]* % of the canvas$' improved/card.txt || fail "nor in the text"
echo "ok its own card"

# Foreign polygons on a rectangle and in the silhouettes of an SVG and of a PNG, with and without names.
square() { # FROM_X TO_X
  local ring="[[$1,10],[$2,10],[$2,30],[$1,30],[$1,10]]"
  echo "{\"properties\":{},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[$ring]}}"
}
echo "{\"features\":[$(square 10 30),$(square 33 53)]}" >theirs.geojson
run 0 card theirs.geojson --size 100,80
for line in 'coverage  *10.00 %$' 'pieces  *2, of shapes without a name$' \
  'balance of sizes  *none, all sizes are alike$' \
  'between pieces  *3.000 px ' 'alone  *100.0 % ' 'nearest copy  *not known, '; do
  grep -q "^  $line" output || fail "lacks: $line: $(cat output)"
done
run 0 card theirs.geojson --size 100,80 --sizes 10,40
grep -q '^  balance of sizes  *0.00  (1 = even; over 10.0 to 40.0 px)' output || fail "another balance"
echo '<svg xmlns="http://www.w3.org/2000/svg" width="100" height="80"><rect width="50" height="80"/></svg>' >half.svg
run 0 card theirs.geojson --canvas half.svg
grep -q '^  coverage  *18.50 %$' output || fail "half of the canvas: $(cat output)"
run 0 card theirs.geojson --canvas half.svg --size 200,160
grep -q '^  coverage  *5.00 %$' output || fail "a quarter of that: $(cat output)"
run 0 draw result --background none --png --to mask
run 0 card result/pieces.geojson --canvas mask/collage.png
grep -q '^  coverage  *\(9[5-9]\..*\|100.00\) %$' output || fail "not all of its own silhouette: $(cat output)"
run 0 card result/pieces.geojson --canvas result/job.toml
mv output by_files
run 0 card result/
cmp output by_files || fail "another card of the folder"
echo "ok anybody's card"

# Each error is one line with exit code 2.
expect_refusal() { # WORD ARGUMENT...
  run 2 card "${@:2}"
  expect_word "$1"
  [[ $(wc -l <errors) == 1 && ! -s output ]] || fail "not one line: ${*:2}"
}
mkfifo pipe
echo '{"features":[{"geometry":{"type":"Polygon","coordinates":[[[NaN,1]]]}}]}' >nan.geojson
expect_refusal 'pipe: not a readable file: found a pipe' pipe --size 100,80
expect_refusal 'pipe: not a readable file: found a pipe' theirs.geojson --canvas pipe
mkdir empty
expect_refusal 'empty/job.toml' empty
expect_refusal 'tessera: nan.geojson: feature 0: no JSON' nan.geojson --size 100,80
expect_refusal 'feature 1: geometry.coordinates: found a piece from [33.000, 10.000] to [53.000, 30.000], far from' \
  theirs.geojson --size 20,20
expect_refusal 'job.toml, allowed: nothing, as the job says it' theirs.geojson --canvas result/job.toml --size 100,80
expect_refusal 'job file none.toml: not found' theirs.geojson --canvas none.toml
expect_refusal 'theirs.geojson' theirs.geojson --canvas theirs.geojson
echo "ok refusals"

# A mosaic of any origin: a picture and its photo, in any size and pixel format.
scene() { # WIDTH HEIGHT FILE: a picture, at this size
  echo "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 300 200'><rect width='300' height='200' fill='#48c'/>
    <circle cx='90' cy='100' r='60' fill='#fc4'/><path d='M150 200L300 90V200Z' fill='#264'/></svg>" >scene.svg
  rsvg-convert -w "$1" -h "$2" scene.svg -o "$3"
}
scene 300 200 photo.png
scene 640 432 theirs.png # whole tiles make it a little higher than the photo
run 0 card theirs.png --image photo.png --pieces 600
grep -qE '^  100 px wide  +colour 0\.[0-9]+ \(CIEDE2000\), structure (1\.000|0\.9[0-9]+) \(SSIM\)$' output ||
  fail "not the picture itself: $(cat output)"
grep -q '^  30 px wide  *colour ' output || fail "not a px for each piece: $(cat output)"
run 0 card theirs.png --image scene.svg
[[ $(grep -c 'px wide' output) == 1 ]] || fail "a number of pieces that nobody said"
run 0 card theirs.png --image photo.png --pieces 600 --json
tr -d ' \n' <output | grep -q '"at_piece_size":{"width_px":30,"height_px":20,"ciede2000":0\.' || fail "no JSON: $(cat output)"
rsvg-convert -w 300 -h 200 half.svg -o black.png # transparent, with white below
run 0 card black.png --image photo.png
! grep -qE 'colour [0-9]\.' output || fail "another picture is like it: $(cat output)"
echo '<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200"><rect width="150" height="200"/></svg>' >left.svg
run 0 card theirs.png --image photo.png --canvas left.svg
grep -q '^  100 px wide' output || fail "not on a canvas: $(cat output)"

# A result that shows a picture: the figures equal those of its own card.
run 0 collage job.toml --out shows --quiet --set stop.pieces=12 --set colour.image=photo.png
run 0 card shows
grep -A3 '^Seen from afar$' output >by_folder
grep -A3 '^Seen from afar$' shows/card.txt | cmp - by_folder || fail "other figures than on its card: $(cat output)"
mv photo.png moved.png
run 0 card shows
grep -q '^  not measured  *colour.image: .*photo.png: not a readable file' output || fail "no word of the lost picture"
run 0 card shows --image moved.png
grep -A3 '^Seen from afar$' output | cmp - by_folder || fail "other figures of the picture that was moved"
rm shows/collage.png
run 0 card shows
grep -q '^  not measured ' output || fail "figures without a picture"
echo "ok mosaics"

scene 90 60 small.png
scene 200 300 turned.png
expect_refusal 'found a picture, allowed: polygons; with --image FILE' theirs.png --size 100,80
expect_refusal 'small.png: found 90 x 60 px, allowed: 100 px wide or more' small.png --image moved.png
expect_refusal 'turned.png: found 200 x 300 px, allowed: the aspect of moved.png, 300 x 200, to 5 %' turned.png \
  --image moved.png
expect_refusal '--image: none.png: not a readable file' theirs.png --image none.png
expect_refusal 'pipe: not a readable file: found a pipe' pipe --image moved.png
expect_refusal '--image: theirs.geojson: neither SVG nor a readable PNG' theirs.png --image theirs.geojson
expect_refusal 'scene.svg: found an SVG, needed: a picture of pixels' scene.svg --image moved.png
expect_refusal '--pieces: found without --image' theirs.geojson --size 100,80 --pieces 3
expect_refusal '--size: found beside --image' theirs.png --image moved.png --size 100,80
expect_refusal '--sizes: found beside --image' theirs.png --image moved.png --sizes 20,160
expect_refusal '--image: found beside --canvas' result --image moved.png --canvas half.svg
expect_refusal 'the aspect of the canvas, 120 x 90' theirs.png --image moved.png --canvas result/job.toml
echo "ok refusals of mosaics"
