#!/usr/bin/env bash
# agreement_test.sh TESSERA PICTURE_DIFFERENCE NEW_FOLDER RENDERER...: collage.svg of Debian's clip art looks like collage.png in each of
# the renderers rsvg, inkscape and chromium. The renderer "pdf" checks collage.pdf.
# The bounds are mean differences over the picture, of 255. Measured were 0.77 to 1.09, and 0.94 to 1.49 for the PDF, whose hair lines
# poppler draws one pixel wide.
# A collage with many gradients differs more in librsvg (2.54 in Debian 12).
# librsvg stretches gradients that follow their object's box if that box is rotated, as pieces are.
# The PNG has them right, because there drawings are rotated as pixels.
set -uo pipefail
tessera=$1
difference=$2
folder=$3
shift 3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

declare -A most=([rsvg]=1.5 [inkscape]=1.5 [chromium]=1.5 [pdf]=1.9)
declare -A program=([rsvg]=rsvg-convert [inkscape]=inkscape [chromium]=chromium [pdf]=pdftocairo)

clipart=$(dpkg -L openclipart-svg 2>/dev/null | grep -x '.*/svg/animals')
[[ -n $clipart ]] || fail "no openclipart-svg: scripts/install-packages.sh"
for renderer in "$@"; do
  command -v "${program[$renderer]}" >/dev/null ||
    fail "no ${program[$renderer]}: scripts/install-packages.sh tests long-tests"
done

new_folder
mkdir home
export HOME=$folder/home
mapfile -t drawings < <(find "$clipart" -maxdepth 1 -name '*.svg' | LC_ALL=C sort | head -n 60)
run 0 library build "${drawings[@]}" -o animals.h5
echo '<svg xmlns="http://www.w3.org/2000/svg" width="90" height="60"><ellipse cx="45" cy="30" rx="44" ry="29"/></svg>' \
  >ellipse.svg
cat >job.toml <<'END_OF_JOB'
seed = 3
quality = 'draft'
[library]
file = 'animals.h5'
[canvas]
file = 'ellipse.svg'
size_px = [600, 400]
[pieces]
scale_px = [20, 120]
[output]
width_px = 1200
END_OF_JOB
run 0 collage job.toml --out plain --quiet
decoration='--set output.outline_px=1 --set output.outline_colour=#402010 --set output.shadow_strength=0.6'
cp -r plain decorated
cp -r plain transparent
echo >plain/keys
echo "$decoration --set output.clip=none" >decorated/keys
echo '--background none' >transparent/keys
for result in decorated transparent; do
  # shellcheck disable=SC2046  # options, one a word
  run 0 draw "$result" --quiet $(cat "$result/keys")
done

rendered() { # RENDERER SVG PNG
  case $1 in
    rsvg) rsvg-convert --unlimited "$2" -o "$3" ;;
    pdf)
      # shellcheck disable=SC2046
      "$tessera" draw "${2%/*}" --pdf --quiet $(cat "${2%/*}/keys") &&
        pdftocairo -png -transp -singlefile -scale-to-x 1200 -scale-to-y 800 "${2%.svg}.pdf" "${3%.png}"
      ;;
    inkscape) timeout 300 inkscape "$2" --export-type=png --export-filename="$3" ;;
    chromium)
      timeout 300 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars \
        --user-data-dir="$folder/home/chromium" --default-background-color=00000000 --window-size=1200,800 \
        --screenshot="$PWD/$3" "file://$PWD/$2"
      ;;
  esac >output 2>errors
}

for renderer in "$@"; do
  for result in plain decorated transparent; do
    rendered "$renderer" "$result/collage.svg" "$result/$renderer.png" || fail "$renderer"
    "$difference" "$result/collage.png" "$result/$renderer.png" "$result" >found || fail "$renderer: cannot be compared"
    mean=$(head -n 1 found)
    awk -v mean="$mean" -v most="${most[$renderer]}" 'BEGIN { exit !(mean <= most) }' ||
      fail "$result: $renderer differs by $mean of 255 on average, allowed: ${most[$renderer]}; most in
$(tail -n +2 found)"
    echo "ok $result by $renderer: $mean"
  done
done
