#!/usr/bin/env bash
# colours_test.sh TESSERA MPIRUN NEW_FOLDER: a job whose pieces show a picture. The pieces are the same on one rank, on three, and after
# interruptions.
# Another picture makes another job. A result is drawn again without the picture.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/restart_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../restart_fixture.sh"

enter_folder
# Red drawings, and blue drawings of other shapes.
make_drawings many
for drawing in many/star many/leaf; do sed -i 's/teal/red/' "$drawing.svg"; done
for drawing in many/bean many/drop many/corner; do sed -i 's/teal/blue/' "$drawing.svg"; done
run 0 library build many -o coloured.h5
picture() { # LEFT RIGHT
  echo "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 4 3'><path fill='$1' d='M0 0H2V3H0Z'/>" \
    "<path fill='$2' d='M2 0H4V3H2Z'/></svg>" >picture.svg
}
picture red blue
cat >job.toml <<'END'
[library]
file = 'coloured.h5'
[canvas]
size_px = [240, 180]
[pieces]
scale_px = [14, 50]
[colour]
image = 'picture.svg'
[improve]
trials = 40
[output]
width_px = 240
[checkpoint]
every_s = 0.2
END
same_on_3_ranks expected collage job.toml
cp expected/pieces.geojson expected.geojson
expect_result expected_on_3
echo "ok three ranks"

# The percentages of the red and of the blue pieces in the half of their own colour.
in_place=$(sed -n 's/.*"shape":"\([a-z]*\)".*"x_px":\([0-9.-]*\).*/\1 \2/p' expected.geojson |
  awk '{ red = $1 == "star" || $1 == "leaf"; right += red == ($2 < 120) } END { print int(100 * right / NR) }')
((in_place > 80)) || fail "of the pieces $in_place % stand where their colour is wanted"
echo "ok the picture is shown"

interrupt USR2 1 parts --set checkpoint.every_s=0.01
expect_code 75 "an interruption"
interrupt USR2 3 parts --resume
expect_code 75 "an interruption on three ranks"
cp -r parts other
start 1 parts --resume
expect_end 0 "the rest"
expect_result parts
echo "ok interruptions"

picture blue red
start 1 other --resume
expect_end 2 "another picture"
grep -qE 'colour.image: another content: ".*picture.svg" has changed since' errors || fail "another picture: $(cat errors)"
picture red blue
start 1 other --resume
expect_end 0 "the same picture again"
expect_result other
echo "ok another picture"

# The figures from afar are the same on three ranks. An SVG does not change them, another background does.
afar() { tr -d ' \n' <"$1/card.json" | grep -o '"from_afar":{.*}}' | sed 's/"drawing".*//'; }
[[ $(afar expected) == *'"at_100_px":{"width_px":100,"height_px":75,"ciede2000":'*'"at_piece_size":{'* ]] ||
  fail "no figures from afar: $(afar expected)"
[[ $(afar expected) == "$(afar expected_on_3)" ]] || fail "other figures on three ranks"
grep -qE '^  100 px wide +colour [0-9.]+ \(CIEDE2000\), structure [0-9.]+ \(SSIM\)$' expected/card.txt ||
  fail "no figures in the text: $(tail expected/card.txt)"
cp -r expected drawn
run 0 draw drawn --svg
[[ $(afar drawn) == "$(afar expected)" ]] || fail "an SVG changes the figures"
run 0 draw drawn --png --background '#000000'
grep -q '^Seen from afar$' output || fail "nothing is said of it: $(cat output)"
[[ $(afar drawn) != "$(afar expected)" ]] || fail "what lies between the pieces does not count"
run 0 rank expected drawn --weight colour_from_afar=-1 --out ranks
grep -q '^score = .* - colour_from_afar, in percent$' output || fail "not weighed: $(cat output)"
echo "ok seen from afar"

# A collage also has these figures if the job gives no sizes: the picture is read as finely as the run read it.
found_sizes() { # OPTION...
  run 0 collage job.toml --out sized --quiet --set improve.trials=0 "$@"
  [[ $(afar sized) == *'"at_100_px":'* ]] || fail "$*: no figures from afar: $(afar sized)"
}
found_sizes --set pieces.fit=all --set pieces.uses=1
found_sizes --set pieces.sizes=drawn
echo "ok seen from afar at sizes that are found"

# The picture laid over the pieces: the same on three ranks and after interruptions, seen from afar, and without a search.
for result in expected expected_on_3 parts; do
  cp -r "$result" "laid_over_$result"
  run 0 draw "laid_over_$result" --png --svg --quiet --set colour.overlay=0.25
  for file in shown.png collage.png collage.svg; do
    cmp "laid_over_expected/$file" "laid_over_$result/$file" || fail "another overlay of $result"
  done
done
difference_from_afar() { afar "$1" | grep -o '"ciede2000":[0-9.]*' | head -n 1 | cut -d: -f2; }
awk "BEGIN {exit !($(difference_from_afar laid_over_expected) < 0.9 * $(difference_from_afar expected))}" ||
  fail "an overlay does not count from afar: $(afar expected) $(afar laid_over_expected)"
run 0 collage job.toml --out laid_over --quiet --set colour.overlay=0.25
cmp expected/pieces.geojson laid_over/pieces.geojson || fail "the overlay changes the pieces"
cmp laid_over_expected/collage.png laid_over/collage.png || fail "drawn afterwards the overlay is another"
start 1 other --resume --set colour.overlay=0.25
expect_end 0 "a finished run with an overlay"
echo "ok overlay"

rm picture.svg
run 2 plan job.toml
grep -q 'colour.image' errors || fail "a plan without the picture: $(cat errors)"
echo "ok plan"

cp expected/collage.png before.png
run 0 draw expected --png --quiet
cmp -s before.png expected/collage.png || fail "drawn again, the picture differs"
expect_silence "a warning, though drawing needs no picture"
grep -q '"not_measured": "colour.image cannot be read any more"' expected/card.json || fail "figures without the picture"
echo "ok drawn again without the picture"

# Tones: red drawings on a slightly lighter red.
grep -q '"covered":\["#' expected/manifest.json || fail "the manifest does not say what pieces cover"
run 0 draw expected --png --svg --quiet --set colour.shift=20 --to shifted
! cmp -s before.png shifted/collage.png || fail "no tone is shifted"
grep -q '<use xlink:href="#tone_[0-9]*" clip-path=' shifted/collage.svg || fail "no tone is shifted in the SVG"
run 0 draw expected --png --quiet --set colour.shift=0
cmp -s before.png expected/collage.png || fail "no shift, another picture"
run 0 draw expected --png --quiet --set colour.shift=20
grep -q '"shift":20' expected/manifest.json || fail "the manifest does not say how far tones are shifted"
cmp -s shifted/collage.png expected/collage.png || fail "the same shift, another picture"
run 0 draw expected --pdf --quiet --set colour.shift=20 --to shifted
cp -r expected older && rm older/shown.png
run 0 draw older --png --quiet --set colour.shift=20 --to by_means
cmp -s by_means/collage.png before.png && fail "no tones in a result of an older version"
cmp -s by_means/collage.png shifted/collage.png && fail "tones go by the means of pieces, not by the picture"
run 0 draw expected --pdf --quiet --set colour.shift=0 --to plain
run 2 draw expected --png --quiet --set colour.weight=2
grep -q 'colour.weight=2: this key decides where pieces lie' errors || fail "a key that decides: $(cat errors)"
echo "ok tones"

# Harmony: red drawings and blue drawings are turned to one hue.
run 0 draw expected --png --quiet --set colour.harmony=none --to plain
cmp -s before.png plain/collage.png || fail "no harmony, another picture"
run 0 draw expected --png --svg --quiet --set colour.harmony=i --to one_hue
! cmp -s before.png one_hue/collage.png || fail "no hue is turned"
grep -q 'type="hueRotate"' one_hue/collage.svg || fail "no hue is turned in the SVG"
run 0 draw expected --png --svg --quiet --set colour.harmony=i
cmp -s one_hue/collage.png expected/collage.png || fail "the same harmony, another PNG"
cmp -s one_hue/collage.svg expected/collage.svg || fail "the same harmony, another SVG"
grep -q '"harmony":{"template":"i","angle_deg":[0-9]*}' expected/manifest.json || fail "the manifest does not say which"
! grep -q '"shift"' expected/manifest.json || fail "the manifest has a shift that was not asked for"
run 0 draw expected --png --quiet --set colour.harmony=i --set colour.shift=20 --to both
! cmp -s one_hue/collage.png both/collage.png || fail "harmony without the shift of tones"
run 2 draw expected --pdf --quiet --set colour.harmony=i --to nowhere
grep -q 'colour.harmony: found "i" with a PDF' errors || fail "harmony in a PDF: $(cat errors)"
run 2 draw expected --png --quiet --set colour.harmony=N
grep -q 'colour.harmony: found "N", allowed: "none" or "auto" or "i"' errors || fail "no template: $(cat errors)"
run 0 collage job.toml --set colour.harmony=i --set colour.image="" --out harmonic --quiet
run 0 collage job.toml --set colour.image="" --out disharmonic --quiet
cmp -s harmonic/pieces.geojson disharmonic/pieces.geojson || fail "harmony decides where pieces lie"
! cmp -s harmonic/collage.png disharmonic/collage.png || fail "no hue is turned without colour.image"
echo "ok harmony"

# A wish for neighbours of other colours gives the same pieces on three ranks and after an interruption.
neighbours=(--set colour.image= --set colour.neighbours=-2)
same_on_3_ranks unlike collage job.toml "${neighbours[@]}"
! cmp -s unlike/pieces.geojson disharmonic/pieces.geojson || fail "colours of neighbours do not matter"
cp unlike/pieces.geojson expected.geojson
interrupt USR2 1 in_parts "${neighbours[@]}" --set checkpoint.every_s=0.01
expect_code 75 "an interruption"
start 1 in_parts --resume "${neighbours[@]}"
expect_end 0 "the rest"
expect_result in_parts
echo "ok neighbours"

# A palette keeps only red drawings, on three ranks and when drawn without its file.
printf '#ff0000\n' >reds.txt
same_on_3_ranks red collage job.toml --set colour.image= --set library.colours=reds.txt
! grep -qE '"shape":"(bean|drop|corner)"' red/pieces.geojson || fail "a blue drawing in a palette of reds"
grep -q '"shape":"star"' red/pieces.geojson || fail "no red drawing in a palette of reds"
rm reds.txt
run 0 draw red --png --quiet
run 2 collage job.toml --set colour.image= --set 'library.colours="#00ff00"' --out green
grep -q 'library.colours: no drawing that is chosen is within 15.0 CIEDE2000' errors || fail "no such colours: $(cat errors)"
echo "ok palette"
