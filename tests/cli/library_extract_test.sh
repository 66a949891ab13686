#!/usr/bin/env bash
# library_extract_test.sh TESSERA NEW_FOLDER: tessera library extract, from a photograph to a collage of its elements.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

new_folder

# stones: prints an SVG of twelve whole stones and one that the edge cuts. Each has its own shade, or its label as a grey.
stones() { # GROUND FIRST_GREY STEP
  local grey=$2 x y
  echo "<svg xmlns='http://www.w3.org/2000/svg' width='480' height='360'><rect width='480' height='360' fill='$1'/>"
  for y in 60 180 300; do
    for x in 60 180 300 420; do
      echo "<path transform='translate($x $y) rotate($((7 * grey)))' fill='rgb($grey,$grey,$grey)'" \
        "d='M-38 -20L0 -40L36 -24L40 16L10 38L-30 30Z'/>"
      grey=$((grey + $3))
    done
  done
  echo "<circle cx='0' cy='120' r='30' fill='rgb($grey,$grey,$grey)'/></svg>"
}
stones '#282420' 140 9 >wall.svg
rsvg-convert wall.svg -o wall.png
stones '#000' 10 20 | rsvg-convert -f pdf -o map.pdf
pdftocairo -png -gray -antialias none -singlefile -r 72 -scale-to-x 480 -scale-to-y 360 map.pdf map

run 0 library extract wall.png --element-px 75 -o wall.h5 --overview found
grep -q '^wall.png: 12 elements' output || fail "another count"
grep -qx '  overview: found/wall_found.png' output || fail "no overview"
[[ -s found/wall_found.png ]] || fail "an empty overview"
run 0 library info wall.h5
grep -qx 'shapes          12' output || fail "another number of shapes"
grep -qx 'artwork         embedded' output || fail "pixels that are not in the library"
cp wall.h5 first.h5
run 0 library extract wall.png --element-px 75 -o wall.h5
cmp wall.h5 first.h5 || fail "other bytes of the same photo"
echo "ok search"

# On a plain ground no size is needed. Elements that touch are reported, and separated if a size is given.
run 0 library extract wall.png -o apart.h5
grep -qx "wall.png: 12 elements, 1 at the photo's edge left out" output || fail "another count without a size"
[[ $(cat output) != *'like several'* ]] || fail "stones apart count as several"
coins() { # SECOND_X
  echo "<svg xmlns='http://www.w3.org/2000/svg' width='480' height='360'><rect width='480' height='360' fill='#1a2a50'/>
    <circle cx='120' cy='100' r='50' fill='#c9a227'/><circle cx='$1' cy='100' r='50' fill='#c9a227'/>
    <circle cx='330' cy='240' r='50' fill='#c9a227'/></svg>" | rsvg-convert -o coins.png
}
coins 217
run 0 library extract coins.png -o coins.h5
grep -qx 'coins.png: 2 elements' output || fail "another count of coins"
grep -qx '  1 looks like several that touch: --element-px PX, the short side of a typical one, takes them apart' output ||
  fail "coins that touch are not named"
run 0 library extract coins.png --element-px 100 -o coins.h5
grep -qx 'coins.png: 3 elements' output || fail "coins that touch are not taken apart"
coins 235
for size in 30 60 240; do  # wrong sizes
  run 0 library extract coins.png --element-px $size -o coins.h5
  grep -qx 'coins.png: 3 elements' output || fail "a wrong size makes other coins of those on a plain ground"
done
echo "ok plain ground"

# Side by side on a ground of two colours, the size is found.
sed "s|<rect width='480' height='360' fill='#282420'/>|&<rect width='240' height='360' fill='#b09868'/>|" wall.svg >sized.svg
rsvg-convert sized.svg -o sized.png
run 0 library extract sized.png -o sized.h5
grep -qE '^sized.png: 12 elements of about (5|6|7|8|9)[0-9](\.[0-9])? px' output || fail "no size, or another one"

# The library does not need the photo.
mv wall.png elsewhere.png
cat >job.toml <<'END_OF_JOB'
quality = 'draft'
[library]
file = "wall.h5"
[canvas]
size_px = [200, 150]
[pieces]
scale_px = [20, 60]
[stop]
pieces = 4
[output]
width_px = 200
END_OF_JOB
run 0 collage job.toml --out collage
expect_silence "a warning of pixels that the library holds"
[[ -s collage/collage.png ]] || fail "no picture"
mv elsewhere.png wall.png

# The likeness of photo and collage: all stones used once give the same sizes and elongations, half of them do not.
figures=$(dirname "${BASH_SOURCE[0]}")/../../scripts/texture-figures.sh
texture=(--set 'canvas.size_px=[700, 600]' --set pieces.sizes=drawn --set pieces.uses=1 --quiet)
run 0 collage job.toml --out texture "${texture[@]}" --set stop.pieces=12
bash "$figures" texture wall.h5 >output || fail "no figures"
grep -qx 'pieces            12 of 12 elements' output || fail "another number of pieces"
grep -qx 'KS of sizes       0.000' output || fail "other sizes"
grep -qx 'KS of elongations 0.000' output || fail "other elongations"
run 0 collage job.toml --out texture "${texture[@]}" --set stop.pieces=6
bash "$figures" texture wall.h5 >output || fail "no figures"
grep -qE '^KS of sizes       0\.[1-9]' output || fail "the sizes of half of the stones are those of all"
echo "ok collage"

run 0 library extract wall.png --labels map.png -o by_labels.h5
grep -qx "wall.png: 12 elements, 1 at the photo's edge left out" output || fail "another count of labels"
run 0 library extract wall.png --labels map.png --min 60 --max 200 -o large.h5
grep -q '12 elements' output || fail "--min that leaves out what is larger"
run 2 library extract wall.png --labels map.png --min 200 -o none.h5
grep -q 'wall.png: 0 elements.*12 smaller than --min' output || fail "what is too small is not counted"
expect_word 'none.h5 was not written: no element is left of wall.png'
run 2 library extract wall.png --labels map.png --max 20 -o none.h5
grep -q '12 larger than --max' output || fail "what is too large is not counted"
echo "ok labels, --min, --max"

# Stones of few pixels: the program warns at once, and finds them in the enlarged photo.
rsvg-convert -w 120 -h 90 wall.svg -o few.png
run 2 library extract few.png --element-px 18 -o none.h5
grep -qx "few.png: 0 elements, 1 at the photo's edge left out, 12 smaller than 24 px; --enlarge 2 or more has smaller ones" output ||
  fail "what is too small for a library is not told"
run 0 library extract few.png --element-px 18 --enlarge 4 -o few.h5 --overview found
grep -q '^few.png: 12 elements' output || fail "another count of the photo enlarged"
run 0 library info few.h5
grep -qx 'shapes          12' output || fail "another number of shapes enlarged"
run 0 library extract few.png --element-px 18 --enlarge 4 --min 10 --max 20 -o few.h5
grep -q '^few.png: 12 elements' output || fail "--min and --max are not in px of the photo as it is"
pdftocairo -png -gray -antialias none -singlefile -r 72 -scale-to-x 120 -scale-to-y 90 map.pdf few_map
run 0 library extract few.png --labels few_map.png --enlarge 2 -o few.h5
grep -q '^few.png: 12 elements' output || fail "another count by a map of the photo as it is"
echo "ok --enlarge"

# The ground between the stones, for a job's output.ground.
rsvg-convert <(echo "<svg xmlns='http://www.w3.org/2000/svg' width='240' height='240'><rect width='240' height='240'
  fill='#999'/></svg>") -o tiles.png
run 0 library extract wall.png --labels map.png -o ground.h5 --ground mortar.png --ground-px 96
grep -qx '  ground: mortar.png, 6[0-9] % of the photo' output || fail "no word of the ground"
[[ $(od -An -tx1 -j16 -N8 mortar.png) == ' 00 00 00 60 00 00 00 60' ]] || fail "not 96 px wide and high"
run 0 library extract wall.png --element-px 75 -o ground.h5 --ground first.png --ground-px 96
run 0 library extract wall.png tiles.png --element-px 75 -o ground.h5 --ground mortar.png --ground-px 96
cmp mortar.png first.png || fail "the ground of several photos is not that of the first"
echo "<svg xmlns='http://www.w3.org/2000/svg' width='240' height='240'><rect width='240' height='240' fill='#333'/>
  <rect x='60' y='60' width='58' height='120' fill='#666'/><rect x='118' y='60' width='62' height='120' fill='#ccc'/>
  </svg>" >gapless.svg
rsvg-convert -f pdf gapless.svg -o gapless.pdf
pdftocairo -png -gray -antialias none -singlefile -r 72 -scale-to-x 240 -scale-to-y 240 gapless.pdf gapless
run 3 library extract tiles.png --labels gapless.png -o gapless.h5 --ground none.png --overview gapless
[[ -s gapless.h5 && -s gapless/tiles_found.png ]] || fail "what was found is lost because the ground is missing"
expect_word 'tiles.png: --ground: found hardly any gaps between the elements, needed: some 12 places of 6 x 6 px;'
[[ ! -e none.png ]] || fail "a ground was written"
run 2 library extract wall.png --element-px 75 -o none.h5 --ground wall.png
expect_word '--ground: found the photo wall.png, allowed: another file'
# The map is an input, too, under any name; and all outputs must have different names.
mkdir maps
cp wall.png maps/w.png
cp map.png maps/w_found.png
cp map.png kept_map.png
for map in map.png maps/w_found.png; do
  run 2 library extract maps/w.png --labels "$map" -o none.h5 --ground "$map"
  expect_word "--ground: found the map of --labels, $map, allowed: another file"
  run 2 library extract maps/w.png --labels "$map" -o "./$map"
  expect_word "--output: found the map of --labels, ./$map, allowed: another file"
  cmp "$map" kept_map.png || fail "the map is another one"
done
run 2 library extract maps/w.png --labels maps/w_found.png -o none.h5 --overview maps
expect_word '--overview: found the map of --labels, maps/w_found.png, allowed: another file'
run 2 library extract maps/w.png maps/w_found.png --element-px 75 -o none.h5 --overview maps
expect_word '--overview: found the photo maps/w_found.png, allowed: another file'
cmp maps/w_found.png kept_map.png || fail "the map is another one"
run 2 library extract wall.png --element-px 75 -o none.png --ground ./none.png
expect_word '--ground: found ./none.png, which is --output, too; allowed: another file'
mkdir shown
run 2 library extract wall.png --element-px 75 -o none.h5 --ground shown/wall_found.png --overview shown
expect_word '--overview: wall.png would be shown in shown/wall_found.png, which is written as another output, too'
rmdir shown || fail "something was shown"
[[ ! -e none.h5 && ! -e none.png ]] || fail "something was written"
run 2 library extract wall.png --element-px 75 -o none.h5 --ground mortar.jpg
expect_word '--ground: found mortar.jpg, allowed: a name that ends in .png'
run 2 library extract wall.png --element-px 75 -o none.h5 --ground nowhere/mortar.png
expect_word '--ground: found nowhere/mortar.png, allowed: a file in a folder that is there'
run 2 library extract wall.png --element-px 75 -o none.h5 --ground-px 96
run 2 library extract wall.png --element-px 75 -o none.h5 --ground mortar.png --ground-px 63
run 2 library extract wall.png --element-px 75 -o none.h5 --ground mortar.png --ground-px 2049
echo "ok ground"

pdftocairo -png -gray -singlefile -r 20 map.pdf small
run 2 library extract wall.png --labels small.png -o none.h5
expect_word 'small.png: found a map of '
run 2 library extract wall.png wall.png --labels map.png -o none.h5
expect_word '--labels: found 2 photos, allowed: one'
mkdir -p other && cp wall.png other/
run 2 library extract wall.png other/wall.png --element-px 75 -o none.h5 --overview found
expect_word '--overview: wall.png and other/wall.png would both be shown in found/wall_found.png'
run 2 library extract wall.png --labels wall.png -o none.h5
expect_word 'wall.png: a map of labels has one channel (grey) of 8 or 16 bits'
run 2 library extract wall.png --labels map.png --min 50 --max 40 -o none.h5
expect_word '--min: found more than --max'
run 2 library extract wall.png --element-px nan -o none.h5
expect_word '--element-px'
run 2 library extract wall.png --element-px 2 -o none.h5
run 2 library extract tiles.png -o none.h5
expect_word 'tiles.png: found no elements, neither apart on a plain ground nor side by side at any size; allowed: --element-px,'
run 2 library extract wall.png --element-px 75 --labels map.png -o none.h5
expect_word 'found both --element-px and --labels, allowed: one of them'
run 2 library extract job.toml --element-px 75 -o none.h5
expect_word 'job.toml: '
run 2 library extract missing.jpg --element-px 75 -o none.h5
expect_word 'missing.jpg: '
run 2 library extract wall.png --element-px 75 -o job.toml
expect_word 'job.toml'
[[ ! -e none.h5 ]] || fail "a library of nothing"
echo "ok errors"

# Ctrl-C during the search leaves the library unchanged.
rsvg-convert -w 4800 -h 3600 wall.svg -o large.png
run 2 library extract large.png --element-px 150 --enlarge 2 -o none.h5
expect_word 'large.png: --enlarge: found 2, allowed with its 4800 x 3600 px: 1 or less'
cp wall.h5 before.h5
gravel=$(dirname "${BASH_SOURCE[0]}")/../../jobs/photos/gravel.png
timeout -s INT 1 "$tessera" library extract "$gravel" --element-px 16 --enlarge 8 -o wall.h5 >output 2>errors
code=$?
[[ $code -eq 124 ]] || fail "it ended by itself, with $code: no time to interrupt it"
expect_word 'tessera: interrupted'
cmp wall.h5 before.h5 || fail "an interrupted search changed the library"
echo "ok interrupted"

run 2 library build wall.png -o none.h5
grep -q 'tessera library extract' output errors || fail "library build does not point to library extract"
echo "ok library build"
