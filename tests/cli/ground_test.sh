#!/usr/bin/env bash
# ground_test.sh TESSERA PICTURE_DIFFERENCE NEW_FOLDER: pictures with a ground below the pieces, and the map of the pieces' numbers.
set -uo pipefail
tessera=$1
difference=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

enter_folder
write_job '120, 90' '14, 60' 120
echo "<svg xmlns='http://www.w3.org/2000/svg' width='30' height='30'><rect width='30' height='30' fill='#804020'/>
  <circle cx='15' cy='15' r='9' fill='#a06040'/></svg>" >sand.svg
rsvg-convert sand.svg -o sand.png

for command in "collage job.toml --out none" "plan job.toml"; do
  # shellcheck disable=SC2086
  run 2 $command --set output.ground=lost.png
  expect_word "tessera: job.toml: output.ground: $PWD/lost.png: "
  # shellcheck disable=SC2086
  run 2 $command --set output.ground=job.toml
  expect_word "tessera: job.toml: output.ground: $PWD/job.toml: neither SVG nor a readable PNG"
done
[[ ! -e none ]] || fail "a run began without its ground"
echo "ok errors before the run"

run 0 collage job.toml --out plain --quiet
ground=(--set output.ground=sand.png --set output.ground_px=20 --set output.labels=true)
run 0 collage job.toml --out result --quiet "${ground[@]}"
expect_silence "a warning"
cmp plain/pieces.geojson result/pieces.geojson || fail "the ground changed the pieces"
grep -q '<pattern id="ground"' result/collage.svg || fail "no ground in collage.svg"
cmp -s plain/collage.png result/collage.png && fail "no ground in collage.png"
grep -q "\"ground\":\"$PWD/sand.png\",\"ground_px\":20.0" result/manifest.json || fail "no ground in the manifest"
grep -q '"file":"labels.png"' result/manifest.json || fail "no labels in the manifest"
[[ -s result/labels.png && ! -e plain/labels.png ]] || fail "labels.png does not follow output.labels"
cp result/labels.png labels.png
run 0 collage job.toml --out result --quiet --set seed=2
[[ ! -e result/labels.png ]] || fail "the labels of the run before are still there"
echo "ok collage"

run 0 draw plain --quiet "${ground[@]}"
cmp plain/labels.png labels.png || fail "tessera draw makes another labels.png"
run 0 draw plain --quiet --set output.ground=sand.svg --svg --pdf --tiff
grep -q '<pattern id="ground"' plain/collage.svg || fail "no drawing as a ground"
[[ -s plain/collage.pdf && -s plain/collage.tiff ]] || fail "no PDF or TIFF"
pdftocairo -png -singlefile -scale-to-x 120 -scale-to-y 90 plain/collage.pdf page
run 0 draw plain --quiet --png --set output.ground=sand.svg
awk "BEGIN {exit !($("$difference" page.png plain/collage.png) < 5)}" || fail "collage.pdf shows another picture"
run 0 draw plain --quiet --svg --set output.ground=
grep -q 'ground' plain/collage.svg && fail "a ground where there is none"
# On paper, too, a drawing is as fine as the picture.
paper=(--set 'canvas.size_mm=[120, 90]' --set output.dpi=600 --set output.ground=sand.svg)
run 0 collage job.toml --out paper --quiet "${paper[@]}"
cp paper/collage.png page.png
run 0 draw paper --quiet --png --width 2835
[[ $("$difference" page.png paper/collage.png) =~ ^0(\.0+)?$ ]] || fail "a coarser ground on paper"
run 2 draw plain --quiet --set output.ground=lost.png
expect_word "tessera: output.ground: $PWD/lost.png: "
echo "ok draw"

# The result keeps the picture that its pieces show. It may also lie between the pieces.
sed 's/^\[output\]/[colour]\nimage = "sand.png"\n[output]\nbackground = "image"/' job.toml >shown.toml
run 2 collage job.toml --out none --set output.background=image
expect_word 'output.background: found "image", needed with it: colour.image'
run 2 collage shown.toml --out none --set output.ground=sand.png
expect_word 'output.background: found "image" with output.ground, allowed: one of them'
run 2 draw plain --quiet --background image
expect_word 'output.background: found "image", needed with it: colour.image'
run 0 collage shown.toml --out shown --quiet
run 0 collage shown.toml --out grey --quiet --set output.background=#808080
cmp shown/pieces.geojson grey/pieces.geojson || fail "the background changed the pieces"
cmp shown/shown.png grey/shown.png || fail "the picture is not kept with every result"
grep -q '"background_light":0.8' shown/manifest.json || fail "no background_light in the manifest"
rsvg-convert -w 120 shown/collage.svg -o page.png
awk "BEGIN {exit !($("$difference" page.png shown/collage.png) < 5)}" || fail "collage.svg has another background"
run 0 draw shown --quiet --pdf
pdftocairo -png -singlefile -scale-to-x 120 -scale-to-y 90 shown/collage.pdf page
awk "BEGIN {exit !($("$difference" page.png shown/collage.png) < 5)}" || fail "collage.pdf has another background"
run 0 draw shown --quiet --png --svg --pdf --set colour.shift=12 --to toned
awk "BEGIN {exit !($("$difference" shown/collage.png toned/collage.png) > 3)}" || fail "no tones in collage.png"
rsvg-convert -w 120 toned/collage.svg -o page.png
awk "BEGIN {exit !($("$difference" page.png toned/collage.png) < 3)}" || fail "collage.svg has other tones"
pdftocairo -png -singlefile -scale-to-x 120 -scale-to-y 90 toned/collage.pdf page
awk "BEGIN {exit !($("$difference" page.png toned/collage.png) < 3)}" || fail "collage.pdf has other tones"
cp shown/collage.png before.png
mv sand.png moved.png
mv shown elsewhere && mkdir shown && mv elsewhere shown/moved
run 0 draw shown/moved --quiet --png
cmp shown/moved/collage.png before.png || fail "another picture of a folder that was moved"
mv shown/moved elsewhere && rmdir shown && mv elsewhere shown
run 0 draw shown --quiet --png
cmp shown/collage.png before.png || fail "another picture without the job's image"
run 0 draw shown --quiet --png --set output.background_light=1
cmp -s shown/collage.png before.png && fail "background_light changes nothing"
run 0 draw grey --quiet --png --background image
cmp grey/collage.png before.png || fail "another picture where it is asked for afterwards"

# The picture may also lie over the pieces.
run 2 collage job.toml --out none --set colour.overlay=0.25
expect_word 'job.toml: colour.overlay: found 0.25, allowed without colour.image: 0'
run 2 draw plain --quiet --set colour.overlay=0.25
expect_word 'colour.overlay: found 0.25, allowed without colour.image: 0'
for wrong in -0.1 0.6 nan; do
  run 2 draw shown --quiet --set colour.overlay=$wrong
  expect_word 'allowed: a number from 0 to 0.5'
done
for background in image none; do
  run 0 draw shown --quiet --png --svg --pdf --background "$background" --set colour.overlay=0.4 --to over
  rsvg-convert -w 120 over/collage.svg -o page.png
  awk "BEGIN {exit !($("$difference" page.png over/collage.png) < 5)}" ||
    fail "another overlay in the SVG on $background"
  pdftocairo -png -transp -singlefile -scale-to-x 120 -scale-to-y 90 over/collage.pdf page
  awk "BEGIN {exit !($("$difference" page.png over/collage.png) < 5)}" ||
    fail "another overlay in the PDF on $background"
  run 0 draw shown --quiet --png --pdf --background "$background" --to without
  cmp -s without/collage.png over/collage.png && fail "no overlay on $background"
  pdftocairo -png -transp -singlefile -scale-to-x 120 -scale-to-y 90 without/collage.pdf page
  awk "BEGIN {exit !($("$difference" page.png over/collage.png) > 5)}" ||
    fail "no overlay in the PDF on $background"
done
run 0 draw shown --quiet --svg --set colour.overlay=0.4
grep -q '"overlay":0.4' shown/manifest.json || fail "no overlay in the manifest"
grep -q '<g id="layer-overlay" .*opacity="0.4000"' shown/collage.svg || fail "the overlay is no layer of the SVG"
run 0 draw shown --quiet --svg --set colour.overlay=0
grep -q '"overlay"\|layer-overlay' shown/manifest.json shown/collage.svg && fail "an overlay where there is none"
echo "ok image as overlay"

rm shown/shown.png
run 2 draw shown --quiet --png --background '#ffffff' --set colour.overlay=0.25
expect_word 'colour.overlay: found 0.25, but '
run 2 draw shown --quiet --png
expect_word 'shown/shown.png is missing; needed: the result of a job with colour.image'
echo "ok image as background"
