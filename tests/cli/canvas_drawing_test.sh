#!/usr/bin/env bash
# canvas_drawing_test.sh TESSERA NEW_FOLDER: a canvas that could not be drawn at the end is refused before the collage begins.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

enter_folder
write_job '120, 90' '14, 60' 120
# These filters need little memory at twice the canvas' size, but too much at the size of its edge.
floods=$(for i in {1..16}; do echo "<feFlood result='a$i' flood-color='black' flood-opacity='.2'/>"; done)
merged=$(for i in {1..16}; do echo "<feMergeNode in='a$i'/>"; done)
cat >heavy.svg <<END_OF_SVG
<svg xmlns="http://www.w3.org/2000/svg" width="100" height="75">
  <filter id="f" x="0" y="0" width="1" height="1">$floods<feMerge>$merged</feMerge></filter>
  <rect x="10" y="10" width="80" height="55" filter="url(#f)"/>
</svg>
END_OF_SVG
echo "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='75'><circle cx='50' cy='37' r='30'/></svg>" >disc.svg

refused() { # KEY=VALUE...: by collage and plan alike, before any computation
  local command setting sets=()
  for setting in "$@"; do sets+=(--set "$setting"); done
  for command in "collage job.toml --out none" "plan job.toml"; do
    # shellcheck disable=SC2086
    run 2 $command "${sets[@]}"
    expect_word "tessera: job.toml: ${1%%=*}: $PWD/heavy.svg: "
    expect_word "make the drawing simpler"
  done
  [[ ! -e none ]] || fail "a run began"
}

refused canvas.file=heavy.svg
refused canvas.keep_out=heavy.svg output.keep_out=artwork
echo "ok what can never be drawn"

run 0 collage job.toml --out kept_out --quiet --set canvas.keep_out=heavy.svg --set output.keep_out=none
run 0 collage job.toml --out disc --quiet --set canvas.file=disc.svg
[[ -s disc/collage.png && -s disc/collage.svg ]] || fail "no pictures on a plain canvas"

# A canvas drawn as an outline is filled along its line only. A warning says so before.
heart='M50 88 12 45C0 25 20 5 35 10c8 3 12 8 15 14 3-6 7-11 15-14 15-5 35 15 23 35z'
page="<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>"
echo "$page<path d='$heart' fill='none' stroke='black' stroke-width='2'/></svg>" >line.svg
echo "$page<path d='$heart'/></svg>" >heart.svg
echo "$page<circle cx='50' cy='50' r='40' fill='none' stroke='black' stroke-width='8'/></svg>" >ring.svg
outline="line.svg: the drawing covers [0-9]+ % of what it encloses, so that only its lines are"
few=(--quiet --set 'canvas.size_px=[150, 150]')
run "0 3" collage job.toml --out line "${few[@]}" --set canvas.file=line.svg
grep -qE "warning: canvas.file: $PWD/$outline filled; fill its path" errors || fail "no warning of an outline"
grep -qE "$outline filled" line/run.log || fail "the warning is not in run.log"
run 0 plan job.toml --set canvas.file=line.svg
grep -qE "$outline filled" errors || fail "tessera plan does not warn of an outline"
run "0 3" collage job.toml --out frame "${few[@]}" --set canvas.keep_out=line.svg
grep -qE "warning: canvas.keep_out: $PWD/$outline kept free" errors || fail "no warning of an outline as a zone"
for canvas in heart ring; do
  run "0 3" collage job.toml --out plain "${few[@]}" --restart --set canvas.file=$canvas.svg --set canvas.keep_out=disc.svg
  ! grep -q encloses errors || fail "a warning of an outline for $canvas.svg"
done
echo "ok outlines"
echo "ok what need not be drawn, and what can be"

TESSERA_DRAWER=$PWD/missing run 1 collage job.toml --out none --quiet
expect_word "missing"
[[ ! -e none/pieces.geojson ]] || fail "a run began without the program that draws"
echo "ok without the program that draws"

# Only the first picture of an animation is used. A warning says so once per file, even if several keys name it.
rsvg-convert disc.svg -o disc.png
"$(dirname "${BASH_SOURCE[0]}")/animated_png.py" disc.png moving.png
told='moving.png: an animation, or several pages; only the first picture is used'
run 0 collage job.toml --out moving --set canvas.file=moving.png --set colour.image=moving.png
[[ $(grep -c "$told" errors) == 1 ]] || fail "no word of the other pictures of a canvas, or two"
run 0 collage job.toml --out moving --set canvas.file=disc.png
! grep -q 'only the first picture' errors || fail "a picture that is the only one is called one of several"
cp moving.png photo.png
run 0 puzzle make photo.png --pieces 4 --out pieces
grep -q 'photo.png: an animation' errors || fail "no word of the other pictures of a photo"
run 0 match moving.png disc.svg
grep -q "$told" errors || fail "no word of the other pictures of a drawing"
echo "ok animations"
