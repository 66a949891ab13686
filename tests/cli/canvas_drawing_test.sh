#!/usr/bin/env bash
# canvas_drawing_test.sh TESSERA NEW_FOLDER: what cannot be drawn when the collage is finished is refused before it begins.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

enter_folder
write_job '120, 90' '14, 60' 120
# Filters whose results take little memory at twice the canvas' size, and too much at that of its edge.
floods=$(for i in {1..16}; do echo "<feFlood result='a$i' flood-color='black' flood-opacity='.2'/>"; done)
merged=$(for i in {1..16}; do echo "<feMergeNode in='a$i'/>"; done)
cat >heavy.svg <<END_OF_SVG
<svg xmlns="http://www.w3.org/2000/svg" width="100" height="75">
  <filter id="f" x="0" y="0" width="1" height="1">$floods<feMerge>$merged</feMerge></filter>
  <rect x="10" y="10" width="80" height="55" filter="url(#f)"/>
</svg>
END_OF_SVG
echo "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='75'><circle cx='50' cy='37' r='30'/></svg>" >disc.svg

refused() { # KEY=VALUE...: by collage and plan alike, with nothing computed
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
echo "ok what need not be drawn, and what can be"

TESSERA_DRAWER=$PWD/missing run 1 collage job.toml --out none --quiet
expect_word "missing"
[[ ! -e none/pieces.geojson ]] || fail "a run began without the program that draws"
echo "ok without the program that draws"
