#!/usr/bin/env bash
# fit_test.sh TESSERA MPIRUN NEW_FOLDER: collages in which every shape must find a place.
# The messages, files and exit codes if some shapes find none, or if there is no piece at all.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/restart_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../restart_fixture.sh"

enter_folder

# job NAME LIBRARY PIECES_LINES: writes a draft job on 400 x 300 px
job() {
  printf 'quality = "draft"\n[library]\nfile = "%s"\n[canvas]\nsize_px = [400, 300]\n[output]\nwidth_px = 200\n[pieces]\n%s\n' \
    "$2" "$3" >"$1.toml"
}
pieces_in() { grep -c '"type":"Feature",' "$1/pieces.geojson"; }
expect_pieces() { # OUT COUNT
  local found
  found=$(pieces_in "$1")
  [[ $found == "$2" ]] || fail "$1: $found pieces, not $2"
}
in_card() { grep -qF -- "$2" "$1/card.json" || fail "$1/card.json lacks $2"; }

# Three bars of about 17:1: the first sizes, chosen by area, make them longer than the canvas.
mkdir bars phrases
for i in 1 2 3; do
  echo "<svg xmlns='http://www.w3.org/2000/svg' width='720' height='80'><path d='M20 20 H700 V60 H$((18 + i)) Z'/></svg>" \
    >"bars/bar$i.svg"
done
run 0 library build bars -o bars.h5 --keep-rectangles
job bars bars.h5 $'fit = "all"\nsizes = "drawn"\nuses = 1'
same_on_3_ranks bars collage bars.toml --quiet
expect_silence "a warning where nothing is missing"
expect_pieces bars 3
if grep -q '"missing"' bars/card.json bars/manifest.json; then fail "a complete collage lacks something"; fi
echo "ok bars"

# A quality word sets the trials by the sizes that were found; a campaign recognises such a result.
run 0 campaign bars.toml --seeds 1 --set quality=good --out good
grep -q '^trials = [1-9]' good/seed_1/job.toml || fail "the trials: $(grep trials good/seed_1/job.toml)"
run 0 campaign bars.toml --seeds 1 --set quality=good --out good
grep -q 'finished before$' output || fail "made again, though it is the same job: $(cat output)"
mv bars.h5 moved.h5
run 0 campaign bars.toml --seeds 1 --set quality=good --out good --list
grep -q '^finished' output || fail "a finished result is not known where its library was moved"
mv moved.h5 bars.h5
echo "ok quality"

# Lines of letters with a halo, 24 times as long as high, in their drawn sizes, with padding: at first none fits.
for i in 1 2; do
  comb=""
  for ((x = 20; x < 20 + 40 * (43 + i); x += 40)); do comb+="V20 H$((x + 24)) V60 H$((x + 40)) "; done
  echo "<svg xmlns='http://www.w3.org/2000/svg' width='$((1800 + 40 * i))' height='120'><path d='M20 60 ${comb}V90 H20 Z'" \
    "fill='#343' stroke='#fff' stroke-width='8'/></svg>" >"phrases/phrase$i.svg"
done
run 0 library build phrases -o phrases.h5 --edge-opacity 0.05
job phrases phrases.h5 $'fit = "all"\nsizes = "drawn"\nuses = 1\npadding_px = 4'
run 0 collage phrases.toml --out phrases_out --quiet
expect_pieces phrases_out 2
echo "ok phrases with a halo"

# Each drawing four times, upright. If the run is interrupted at any moment and continued on other ranks, the result is the same.
job often own.h5 $'fit = "all"\nuses = [4, 4]\nrotation_deg = 0\nscale_px = 40'
run 0 collage often.toml --out often --quiet
expect_pieces often 20
for ranks in 1 3; do
  for after_s in 0.7 1.1; do
    command=("$tessera" collage often.toml --quiet --out "often_$ranks" --set checkpoint.every_s=0.05)
    timeout -s USR2 "$after_s" "${command[@]}" --restart >output 2>errors
    run_on_ranks "$ranks" 0 "${command[@]:1}" --resume=auto
    cmp often/pieces.geojson "often_$ranks/pieces.geojson" || fail "other pieces after an interruption"
  done
done
echo "ok each four times"

# Two pieces of a shape must be farther apart than the canvas is wide, which is impossible.
cannot=$'fit = "all"\nuses = [2, 2]\napart_px = 900'
job cannot own.h5 "$cannot"
run 3 collage cannot.toml --out cannot --quiet
expect_word 'tessera: warning: 5 pieces are missing: bean (1 of 2), corner (1 of 2), drop (1 of 2), leaf (1 of 2), star (1 of 2);'
expect_word 'no sizes down to 2 px gave all a place; try less pieces.apart_px (now 900); fewer pieces.uses (now [2, 2])'
expect_pieces cannot 5
[[ -s cannot/collage.png && -s cannot/collage.svg ]] || fail "an incomplete collage is not drawn"
in_card cannot '"standing": 1'
in_card cannot '5 pieces are missing: bean'
grep -q 'bean (1 of 2)' cannot/card.txt || fail "card.txt does not name what is missing"
grep -q '"missing":5' cannot/manifest.json || fail "the manifest does not count what is missing"
[[ $(find cannot -name 'checkpoint*') == "" ]] || fail "a finished run leaves checkpoints"
run 3 collage cannot.toml --out cannot --quiet --resume=auto
expect_word 'tessera: warning: cannot: 5 pieces are missing; card.txt names them'
run 0 draw cannot --png --quiet
run 3 refine cannot --relax --quiet --out relaxed
run 3 refine cannot --deform --quiet --out deformed
expect_word ' are missing: '
expect_word '; cannot lacks them, too, and refining it like this adds no pieces'
! grep -q 'stop.pieces' errors || fail "a limit that nobody gave"
run 2 refine cannot --pieces 0 --quiet --out none
expect_word 'allowed: --relax, --deform'
run 3 campaign cannot.toml --seeds 1-2 --set pieces.apart_px=0,900 --out campaign
[[ $(grep -c 'pieces are missing$' output) == 2 ]] || fail "the campaign does not say which lack pieces"
[[ $(wc -l <campaign/ranking.csv) == 5 ]] || fail "the campaign is not ranked"
run 3 campaign cannot.toml --seeds 1-2 --set pieces.apart_px=0,900 --out campaign
[[ $(grep -c 'finished before' output) == 4 ]] || fail "made again for what is missing"
run 0 campaign cannot.toml --seeds 1-2 --set pieces.apart_px=0 --out near
echo "ok what cannot be met"

# The job's least size, a limit of [stop], and least uses without fit = "all".
run 3 collage bars.toml --out least --quiet --set pieces.least_scale_px=200
expect_word 'least: the collage is empty: nothing fits; try smaller pieces, pieces.least_scale_px (now 200); a larger canvas'
run 3 collage cannot.toml --out stopped --quiet --set pieces.apart_px=0 --set stop.pieces=7
expect_word '3 pieces are missing: '
expect_word 'stop.pieces (now 7) ended the collage before they found a place'
job uses own.h5 $'uses = [30, 30]\nscale_px = 60'
run 3 collage uses.toml --out uses --quiet
expect_word 'pieces are missing: bean ('
expect_word 'they found no place; try smaller pieces, pieces.scale_px (now [60, 60]); pieces.fit = "all", which finds their sizes;'
echo "ok least sizes, limits and least uses"

# A shape without a required count fits nowhere: the program warns all the same, and its advice helps.
job disc own.h5 'scale_px = [15, 40]'
printf '[[shapes]]\nnames = "bean"\nscale_px = [900, 1000]\nweight = 50\n' >>disc.toml
run 0 collage disc.toml --out disc --quiet
expect_word 'warning: "bean" fits nowhere on the canvas; try pieces of '

# Without any piece the exit code is 3, and the message names the key that keeps the pieces out.
empty() { # WORDS OPTION...
  run 3 collage empty.toml --out empty --quiet "${@:2}"
  expect_word 'tessera: warning: empty: the collage is empty: '
  expect_word "$1"
  [[ -s empty/collage.png ]] || fail "no picture of an empty collage"
}
# advised_size_helps JOB: the size that the last warning advises works.
advised_size_helps() {
  local px
  px=$(sed -n 's/.* pieces of \([0-9.]*\) px or less.*/\1/p' errors)
  run 0 collage "$1.toml" --out helped --quiet --set "pieces.scale_px=[$px, $px]"
}
job empty own.h5 'scale_px = [1000, 1200]'
empty 'nothing fits; try pieces of ' --set 'canvas.size_px=[300, 200]'
sed -i 's/400, 300/300, 200/' empty.toml
advised_size_helps empty
job empty bars.h5 $'scale_px = [150, 200]'
empty 'nothing fits; try pieces of '
expect_word ' px or less, pieces.scale_px (now [150, 200]); a larger canvas.size_px (now [400, 300])'
advised_size_helps empty
empty 'other rotations, pieces.rotation_deg (now [90, 90])' --set 'pieces.scale_px=90' --set pieces.rotation_deg=90
empty 'less pieces.padding_px (now 140)' --set 'pieces.scale_px=60' --set pieces.padding_px=140
empty 'drawings 64 % as large, pieces.sizes (now "drawn"); pieces.fit = "all", which finds such sizes' --set pieces.sizes=drawn
run 3 collage empty.toml --out empty --quiet --resume=auto --set pieces.sizes=drawn
expect_word 'empty: the collage is empty; run.log says why'
empty 'mm or less, pieces.scale_mm (now [75, 100]); a larger canvas.size_mm (now [200, 150])' --set 'canvas.size_mm=[200, 150]'
cp empty.toml plain.toml
printf '[[shapes]]\nnames = "bar*"\nscale_px = 180\n' >>empty.toml
empty ' px or less, scale_px of [[shapes]] "bar*" (now [180, 180]); a larger ' --set 'pieces.scale_px=[20, 160]'
cp plain.toml empty.toml
printf '[[shapes]]\nnames = "*"\nweight = 0\n' >>empty.toml
empty 'no shape may stand: weights, regions and names of [[shapes]]'
cp plain.toml empty.toml
printf '[[keep_out]]\nat_px = [200, 150]\nsize_px = [390, 290]\n' >>empty.toml
empty 'smaller zones that pieces keep out of (canvas.keep_out, [[keep_out]])' --set pieces.scale_px=80
echo "ok empty collages"

# The plan uses the sizes that the run will find. The job's sizes only compare shapes.
job plan own.h5 $'fit = "all"\nuses = 1\nscale_px = [2, 4]'
run 0 plan plan.toml --ranks 2
grep -qE '^  pieces +about [1-9]$' output || fail "the plan goes by other sizes: $(cat output)"
cp output small
run 0 plan plan.toml --ranks 2 --set 'pieces.scale_px=[400, 800]'
cmp small output || fail "the plan of pieces that are larger than the canvas is another one: $(diff small output)"
echo "ok plan"
