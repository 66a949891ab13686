#!/usr/bin/env bash
# nest_test.sh TESSERA MPIRUN NEW_FOLDER: tessera nest, from drawings of all kinds to a layout.
set -uo pipefail
tessera=$1
# shellcheck disable=SC2034 # support/ranks.sh
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"

new_folder
cat >parts.json <<'JSON'
{"name": "parts", "strip_height": 40, "items": [
  {"id": 0, "demand": 4, "allowed_orientations": [0, 180], "shape": {"type": "simple_polygon", "data": [[0,0],[20,0],[10,15],[0,0]]}},
  {"id": 1, "demand": 3, "allowed_orientations": [0, 90], "shape": {"type": "simple_polygon", "data": [[0,0],[12,0],[12,4],[4,4],[4,12],[0,12]]}}]}
JSON
run 0 nest parts.json --effort draft --out out/parts --quiet
expect_silence "something is said in spite of --quiet"
for file in layout.json layout.svg layout.dxf layout.png card.txt; do [[ -s out/parts/$file ]] || fail "no $file"; done
python3 - <<'PYTHON' || fail "the layout is not as it was asked for"
import json, math
problem, found = json.load(open("parts.json")), json.load(open("out/parts/layout.json"))
items = found["solution"]["layout"]["placed_items"]
assert sorted(i["item_id"] for i in items) == [0, 0, 0, 0, 1, 1, 1]
reach = 0
for item in items:
    angle = item["transformation"]["rotation"]
    assert angle in problem["items"][item["item_id"]]["allowed_orientations"]
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    tx, ty = item["transformation"]["translation"]
    for x, y in problem["items"][item["item_id"]]["shape"]["data"]:
        X, Y = c * x - s * y + tx, s * x + c * y + ty
        assert -1e-4 < Y < 40 + 1e-4 and X > -1e-4
        reach = max(reach, X)
length = found["solution"]["strip_width"]
assert abs(reach - length) < 1e-6
area = 4 * 150 + 3 * 80
assert abs(found["solution"]["density"] - area / 40 / length) < 1e-9
assert found["solution"]["density"] > 0.6
PYTHON
mkdir first && cp out/parts/layout* first
run_on_ranks 3 0 nest parts.json --effort draft --out out/parts --quiet
for file in first/*; do cmp "$file" "out/parts/${file#first/}" || fail "another ${file#first/} on three ranks"; done
run 0 nest parts.json --effort draft --seed 2 --out out/other --quiet
! cmp -s first/layout.json out/other/layout.json || fail "the same layout of another seed"
run 0 nest parts.json --demand 0=0 --effort draft --out out/second --quiet
[[ $(grep -o '"item_id": [0-9]*' out/second/layout.json | sort -u) == '"item_id": 1' ]] || fail "another number than the instance's"
# A bin of jagua-rs gives the sheet and its number in stock; the command line may give another material.
cat >bins.json <<'JSON'
{"bins": [{"id": 0, "cost": 1, "stock": 1, "shape": {"type": "rectangle", "data": {"x_min": 0, "y_min": 0, "width": 30, "height": 12}}}],
 "items": [{"id": 0, "demand": 4, "shape": {"type": "rectangle", "data": {"x_min": 0, "y_min": 0, "width": 20, "height": 5}}}]}
JSON
run 3 nest bins.json --effort draft
expect_word "warning: the layout takes 2 sheets, and the instance's stock is 1"
grep -q '^  sheets          2 of 30.000 x 12.000 mm$' output || fail "the bin is not the sheet"
run 0 nest bins.json --sheet 30,12 --effort draft --quiet
run 0 nest bins.json --demand 0=2 --effort draft --quiet
expect_silence "what is in stock is enough"
run 0 nest bins.json --strip 12 --effort draft
grep -q '^  length ' output || fail "--strip does not count"
sed 's/"stock": 1,/"zones": [{"quality": 0}],/' bins.json >zones.json
for material in '' '--strip 12'; do
  # shellcheck disable=SC2086 # two words
  run 2 nest zones.json $material
  expect_word 'zones.json: bins: zones: found 1 zone: parts of the material with another quality, which are not read'
done
echo "ok instance"

cat >plates.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 200 200">
  <defs><rect id="hidden" width="9" height="9"/></defs>
  <g transform="translate(5 5) scale(2)">
    <rect id="plate" x="1" y="1" width="20" height="10"/>
    <circle id="disc" cx="60" cy="20" r="8"/>
    <path id="ring" d="M50 50h20v20h-20zM55 55v10h10v-10z"/>
  </g>
  <path id="line" d="M0 0L50 50" stroke="#000"/>
</svg>
SVG
run 0 nest plates.svg --sheet 60,40 --demand plate=3 --demand 'r*=2' --spacing 1 --effort draft
expect_word 'plates.svg: left out 1 chain of lines that does not close'
! grep -q 'says no unit' errors || fail "a unit that is said is missed"
grep -q '^  unit            mm$' output || fail "the card does not name the unit"
grep -q '^  pieces          6 of 6$' output || fail "not six pieces"
grep -q '^  sheets          1 of 60.000 x 40.000 mm$' output || fail "not one sheet"
[[ $(grep -o '<path' out/plates/layout.svg | wc -l) -eq 6 ]] || fail "not six paths"
grep -q 'width="60.000000mm"' out/plates/layout.svg || fail "not in mm"
python3 - <<'PYTHON' || fail "sizes are not kept"
import re
svg = open("out/plates/layout.svg").read()
def size(name, contour):
    data = re.search(r'id="piece-\d+-%s" d="([^"]*)"' % name, svg).group(1)
    points = [tuple(map(float, p.split(","))) for p in re.findall(r"[ MLC]([-\d.]+,[-\d.]+)", data.split("Z")[contour])]
    xs, ys = zip(*points)
    return sorted([max(xs) - min(xs), max(ys) - min(ys)])
for name, contour, want in ("plate", 0, [10, 20]), ("disc", 0, [16, 16]), ("ring", 0, [20, 20]), ("ring", 1, [10, 10]):
    assert all(abs(a - b) < 0.02 for a, b in zip(size(name, contour), want)), (name, size(name, contour))
PYTHON
rsvg-convert out/plates/layout.svg -o plates.png || fail "an SVG that cannot be drawn"
# The written layout is read again: the same pieces, in mm.
run 0 nest out/plates/layout.dxf --strip 40 --spacing 1 --effort draft --out out/again
grep -q '^  pieces          6 of 6$' output || fail "the DXF does not hold the six pieces"
run 0 nest plates.svg --sheet 30,22 --angles 0,90 --effort draft --out out/many
grep -q '^  sheets          2 of 30.000 x 22.000 mm$' output || fail "not two sheets"
[[ -s out/many/layout_1.svg && -s out/many/layout_2.dxf && ! -e out/many/layout.svg ]] || fail "not a file for each sheet"
run 0 nest plates.svg --sheet 60,40 --angles 0 --effort draft --out out/many
[[ ! -e out/many/layout_1.svg && -s out/many/layout.svg ]] || fail "sheets of an earlier run are left"
run 3 nest plates.svg --sheet 21,12 --effort draft --out out/small
expect_word 'warning: 2 of 3 pieces found no place: disc, ring'
[[ $(grep -m 1 'warning: plates.svg: 2' errors) == *'plates.svg: 2 shapes of 3 do not fit onto the sheet of 21 x 12 mm at the angles allowed: disc (16 x 16 mm), ring (20 x 20 mm)' ]] ||
  fail "pieces that are too large are not named before the search"
mkdir both && cp plates.svg out/plates/layout.dxf both
run 0 nest both --strip 60 --effort draft
grep -q '^  pieces          9 of 9$' output || fail "not all of a folder"
mkfifo both/a.svg both/b.DXF
ln -s c.svg both/c.svg # a link to itself
mkdir both/d.svg
touch both/notes.txt
run 0 nest both --strip 60 --effort draft
expect_word 'warning: both: left out 4 names that are no regular files: a.svg, b.DXF, c.svg, d.svg'
grep -q '^  pieces          9 of 9$' output || fail "not all of a folder beside pipes"
cat >spike.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="300mm" viewBox="0 0 300 300">
  <polygon id="p" points="0,0 100,0 100,50 150,50 100,50 100,100 0,100"/></svg>
SVG
run 0 nest spike.svg --strip 100 --demand p=2 --effort draft
expect_word 'spike.svg: p: left out sides that go out and straight back: they enclose nothing'
grep -q '^  length          200.000 mm$' output || fail "a spike takes room"
# Inkscape up to 0.91 used 90 px per inch. A bed is not a part, and curves stay curves.
cat >bed.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" inkscape:version="0.91 r13725"
  width="900" height="900"><rect id="bed" width="900" height="900" fill="none" stroke="#000"/>
  <circle id="disc" cx="90" cy="90" r="90"/><rect id="plate" x="200" width="180" height="90"/></svg>
SVG
run 0 nest bed.svg --strip 300 --effort draft --out out/bed
expect_word 'warning: bed.svg: written by Inkscape 0.91, which had 90 px an inch: its shapes take 254.0 x 254.0 mm then'
expect_word 'bed is a rectangle of 238.1 x 238.1 mm round everything else'
run 0 nest bed.svg --strip 50.8 --leave-out bed --dpi 90 --effort draft --out out/bed
expect_silence "what was said already is said again"
grep -q '^  pieces          2 of 2$' output || fail "not the parts on the bed"
[[ $(grep -o 'C[-0-9.,]* [-0-9.,]* [-0-9.,]*' out/bed/layout.svg | wc -l) -eq 4 ]] || fail "a disc is not four curves"
run 2 nest bed.svg --strip 300 --leave-out table --effort draft
expect_word '--leave-out table: fits no outline of an SVG; allowed: the id of an element that draws one, as bed'
mkdir here && cp plates.svg here && (cd here && "$tessera" nest . --strip 50 --effort draft --quiet) || fail "not the folder itself"
[[ -s here/out/here/layout.json ]] || fail "another name than the folder's"
echo "ok drawings"

for name in a b; do
  echo "<svg xmlns='http://www.w3.org/2000/svg' width='40mm' height='30mm' viewBox='0 0 40 30'>
    <path d='M2 2h36l-9 26z' fill='#$([[ $name == a ]] && echo c63 || echo 36c)'/></svg>" >$name.svg
done
sed -i 's/M2 2h36l-9 26z/M2 2h36v9h-20v17h-16z/' b.svg
run 0 library build a.svg b.svg -o two.h5
run 0 nest two.h5 --strip 60 --demand '*=2' --effort draft
grep -q '^  pieces          4 of 4$' output || fail "not the pieces of the library"
grep -q '^next: tessera collage out/two/layout.toml$' output || fail "does not say what is next"
run 0 collage out/two/layout.toml --quiet
grep -q '"pieces": 4' out/layout/card.json || fail "the collage has not all pieces"
python3 - <<'PYTHON' || fail "the collage is not as large as the sheet"
import json, re
length = json.load(open("out/two/layout.json"))["solution"]["strip_width"]
assert 36 < length < 90
width, height = map(float, re.search(r'width="([\d.]+)mm" height="([\d.]+)mm"', open("out/layout/collage.svg").read()).groups())
assert abs(width - length) < 0.001 and height == 60, (width, length, height)
PYTHON
run 0 nest two.h5 --sheet 420,297 --effort draft --quiet --out out/a3
[[ $(grep -A2 '^\[canvas\]' out/a3/layout.toml | tr '\n' ' ') == '[canvas] size_mm = [420.000, 297.000] size_px = [1960, 1386] ' ]] ||
  fail "the job has not the size of the sheet"
echo "ok library"

# For an input without a unit the program reports the assumed unit and the resulting size.
echo '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300"><path d="M0 0h80v40z"/></svg>' >moon.svg
run 0 nest moon.svg --strip 40 --effort draft --quiet
[[ $(cat errors) == 'tessera: warning: moon.svg says no unit: 1 unit is taken as 1/96 inch, its page is 105.8 x 79.4 mm; width and height in mm in the SVG set it, --dpi says how many px an inch has' ]] ||
  fail "not what the unit is taken for"
grep -q '^  unit            mm; 1 unit of the input is taken as 1/96 inch$' out/moon/card.txt || fail "the card does not name the unit"
sed 's/viewBox/width="400" height="200" viewBox/' moon.svg >numbers.svg
run 0 nest numbers.svg --strip 40 --effort draft --quiet
expect_word 'numbers.svg says no unit: 1 unit is taken as 1/96 inch, its page is 105.8 x 52.9 mm'
sed 's/viewBox="[^"]*"/width="100%"/' moon.svg >bare.svg
run 0 nest bare.svg --strip 40 --effort draft --quiet
expect_word 'bare.svg says no unit: 1 unit is taken as 1/96 inch, its shapes take 21.2 x 10.6 mm'
for unit in mm cm in pt pc px; do
  sed "s/viewBox/width='4$unit' viewBox/" moon.svg >said.svg
  run 0 nest said.svg --strip 400 --effort draft --quiet
  expect_silence "a unit that is said is missed: $unit"
done
sed -z 's/9\n[$]INSUNITS\n *70\n *4\n//' out/plates/layout.dxf >plain.dxf
run 0 nest plain.dxf --strip 40 --effort draft --quiet
expect_word 'plain.dxf says no unit: 1 unit is taken as 1 mm, its shapes take '
expect_word "; \$INSUNITS in the DXF sets it"
mkdir unitless && cp moon.svg bare.svg plain.dxf plates.svg unitless
run 0 nest unitless --strip 40 --effort draft --quiet
expect_word 'unitless: 2 files say no unit, as unitless/bare.svg: 1 unit is taken as 1/96 inch'
expect_word 'unitless/plain.dxf says no unit: 1 unit is taken as 1 mm'
run 0 nest parts.json --effort draft --out out/parts
grep -q '^  unit            mm; 1 unit of the input is taken as 1 mm$' output || fail "the card does not name an instance's unit"
echo "ok units"

# A file with a single piece: the piece is found by the file's name and by its own, in a folder or alone.
sed 's/<path/<path id="crescent"/' moon.svg >named.svg
mkdir alone && cp moon.svg named.svg alone
for demand in 'moon.svg moon' 'moon.svg path1' 'moon.svg mo*' 'named.svg named' 'named.svg crescent' 'alone named' 'alone crescent'; do
  run 0 nest "${demand% *}" --strip 40 --demand "${demand#* }=5" --effort draft
  grep -qE '^  pieces          (5 of 5|6 of 6)$' output || fail "another demand: $demand"
done
run 2 nest moon.svg --strip 40 --demand sun=5
expect_word '--demand sun: fits no name of a shape; allowed: patterns of path1 or moon'
run 2 nest alone --strip 40 --demand sun=5
expect_word 'allowed: patterns of moon or path1, named or crescent'
echo "ok names"

run 2 nest plates.svg
expect_word 'plates.svg: found no size of the material, allowed: --strip H, or --sheet W,H, in mm'
run 2 nest plates.svg --strip 20 --sheet 20,20
expect_word '--strip and --sheet: allowed: one of them'
run 2 nest plates.svg --strip nan
expect_word '--strip: found nan, allowed: a number from 0.001 to 1e+06 mm'
run 2 nest plates.svg --strip 5 --out out/plates_5
expect_word 'plates.svg: none of its pieces fits onto the strip of 5 mm at the angles allowed: plate (20 x 10 mm), disc (16 x 16 mm), ring (20 x 20 mm)'
[[ ! -e out/plates_5 ]] || fail "a folder without a layout"
cat >dot.json <<'JSON'
{"strip_height": 1e6, "items": [{"id": "dot", "shape": {"type": "simple_polygon", "data": [[0,0],[0.5,0],[0,0.5]]}}]}
JSON
run 2 nest dot.json
expect_word 'dot.json: dot: found a size of 0.5 mm, allowed: 1 or more, a millionth of the height'
run 2 nest plates.svg --strip 50 --demand wheel=2
expect_word '--demand wheel: fits no name of a shape; allowed: patterns of plate, disc, ring'
run 2 nest plates.svg --strip 50 --demand plate
expect_word '--demand plate: allowed: NAME=COUNT, a whole number from 0 to 2000'
run 2 nest plates.svg --strip 50 --demand '*=1500'
expect_word 'found 4500 pieces in all, allowed: 1 to 2000'
run 2 nest plates.svg --strip 50 --spacing -1
expect_word '--spacing: found -1'
run 2 nest none.svg --strip 50
expect_word 'none.svg'
run 2 nest plates.png --strip 50
expect_word 'plates.png: allowed: an instance (.json), .svg, .svgz, .dxf, a library (.h5), or a folder'
mkdir mine && touch mine/precious
run 2 nest plates.svg --strip 50 --out mine
expect_word '--out mine: exists, and its precious was not made by tessera nest; give another name'
echo '{"name": "another program"}' >mine/layout.json
run 2 nest plates.svg --strip 50 --out mine
expect_word '--out mine: exists, and its layout.json was not made by tessera nest; give another name'
[[ $(ls mine) == $'layout.json\nprecious' ]] || fail "a foreign folder is not as it was"
cp -r out/plates ours
touch ours/layout_notes.txt ours/layout.db ours/layout_x.svg ours/layout_2.svg ours/layout_12_pieces.geojson
rm ours/layout.json # as an unfinished run leaves the folder
run 0 nest plates.svg --strip 50 --effort draft --out ours
[[ $(ls ours | tr '\n' ' ') == 'card.txt layout.db layout.dxf layout.json layout.png layout.svg layout_notes.txt layout_x.svg ' ]] ||
  fail "another file is there, or a foreign one is gone"
echo '<svg xmlns="http://www.w3.org/2000/svg"><path id="bow" d="M0 0L40 40V0L0 40z"/></svg>' >bow.svg
run 2 nest bow.svg --strip 50
expect_word 'bow.svg: bow: found a contour that crosses itself'
sed 's|</svg>|<rect id="good" x="90" width="9" height="9"/></svg>|' bow.svg >beside.svg
run 0 nest beside.svg --strip 50 --effort draft
expect_word 'warning: beside.svg: left out bow: found a contour that crosses itself'
grep -q '^  pieces          1 of 1$' output || fail "a good outline beside a bad one is not nested"
printf 'AutoCAD Binary DXF\r\n\x1a\0' >binary.dxf
run 2 nest binary.dxf --strip 50
expect_word 'binary.dxf: a binary DXF; save it as ASCII DXF'
python3 - <<'PYTHON'
import math
rings = ["".join("%s%.4f %.4f" % ("ML"[k > 0], math.cos(k * math.tau / 900) * 9 + 20 * i, math.sin(k * math.tau / 900) * 9) for k in range(900))
         for i in range(200)]
open("many.svg", "w").write("<svg xmlns='http://www.w3.org/2000/svg'>" + "".join("<path d='%sZ'/>" % r for r in rings) + "</svg>")
fine = "".join("%s%.4f %.4f" % ("ML"[k > 0], math.cos(k * math.tau / 1800) * 90, math.sin(k * math.tau / 1800) * 90) for k in range(1800))
open("fine.svg", "w").write("<svg xmlns='http://www.w3.org/2000/svg'><path d='%sZ'/></svg>" % fine)
PYTHON
run 2 nest many.svg --strip 50 --angles "$(seq -s, 0 359)"
expect_word 'many.svg: found 64800000 points of all shapes at all angles, allowed: 10000000 (--angles)'
run 2 nest fine.svg --strip 50 --demand '*=2000'
expect_word 'fine.svg: found 3600000 points of all pieces, allowed: 3000000 (--demand)'
head -c 300 parts.json >cut.json
run 2 nest cut.json
expect_word 'cut.json: not a readable JSON file'
run_on_ranks 3 2 nest cut.json
expect_word 'cut.json: not a readable JSON file'
[[ ! -e out/bow && ! -e out/cut ]] || fail "left something behind"
echo "ok errors"
