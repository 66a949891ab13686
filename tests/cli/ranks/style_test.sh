#!/usr/bin/env bash
# style_test.sh TESSERA MPIRUN NEW_FOLDER: drawings sorted and chosen by style, and a collage in one style.
# The pieces are the same on one rank, on three, and after an interruption. A wish of weight 0 changes nothing.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/restart_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../restart_fixture.sh"

most_s=600
enter_folder
# Three flat drawings, and two of lines on white.
make_drawings many
for drawing in many/star many/bean; do
  sed -i "s/fill='teal'/fill='white' stroke='black' stroke-width='2'/" "$drawing.svg"
done
run 0 library build many -o many.h5

run 0 library styles many.h5 --groups 2 --sheet styles.png
grep -qE '^    1         3 +0\.[0-9] +[0-9] +1\.0' output || fail "no group of three flat drawings"
grep -qE '^    2         2 +[0-9.]+ +(9[89]|100) +1\.0' output || fail "no group of two that are outlined"
grep -qx 'styles.png: 5 shapes' output || fail "another sheet"
[[ $(head -c 4 styles.png | tail -c 3) == PNG ]] || fail "no sheet"
run 0 library styles many.h5 --groups 2 --names
[[ $(cut -f1,3 output | sort | tr '\n\t' ',:') == '1:corner,1:drop,1:leaf,2:bean,2:star,' ]] || fail "other groups"
run 2 library styles many.h5 --sheet many.svg
expect_word '--sheet: found many.svg, allowed: a name that ends in .png'
run 2 library styles many.h5 --groups 0
echo "ok styles"

run 0 library subset many.h5 --style-like star --closest 2 -o lined.h5
run 0 library info lined.h5 --names
[[ $(tr '\n' , <output) == 'bean,star,' ]] || fail "others than the two with lines"
run 0 library subset many.h5 --style-like 'l*f' --style-within 0.5 -o flat.h5
run 0 library info flat.h5 --names
[[ $(tr '\n' , <output) == 'corner,drop,leaf,' ]] || fail "others than the three flat ones"
run 0 library styles flat.h5 # this library knows styles, too
run 2 library subset many.h5 --style-like startle --closest 2 -o none.h5
expect_word 'style-like: no shape of the library has a name like "startle"; near it are: star'
run 2 library subset many.h5 --style-like star -o none.h5
expect_word '--style-like: found alone; needed: --closest or --style-within'
run 2 library subset many.h5 --style-like stra --closest 2 -o none.h5
expect_word 'no shape of the library has a name like "stra"'
[[ ! -e none.h5 ]] || fail "a library of nothing"
echo "ok subset"

cat >job.toml <<'END_OF_JOB'
[library]
file = 'many.h5'
[canvas]
size_px = [240, 180]
[pieces]
scale_px = [14, 50]
[style]
like = 'leaf'
weight = 2
[improve]
trials = 12
[output]
width_px = 240
[checkpoint]
every_s = 0.2
END_OF_JOB
same_on_3_ranks expected collage job.toml
cp expected/pieces.geojson expected.geojson
expect_result expected_on_3
echo "ok three ranks"

share() { # RESULT: prints the percentage of the pieces' area that is drawn with lines
  sed -n 's/.*"shape":"\([a-z]*\)".*"scale":\([0-9.]*\).*/\1 \2/p' "$1/pieces.geojson" |
    awk '{ area = $2 * $2; all += area; if ($1 == "star" || $1 == "bean") lined += area }
      END { print int(100 * lined / all) }'
}
run 0 collage job.toml --out any --set style.like='[]' --quiet
run 0 collage job.toml --out unweighted --set style.weight=0 --quiet
cmp any/pieces.geojson unweighted/pieces.geojson || fail "a weight of nothing has an effect"
(($(share any) > 15 && $(share expected) < 5)) ||
  fail "$(share any) % with lines without a wish, $(share expected) % with it"
apart() { sed -n 's/.*"style_distance": \([0-9.]*\).*/\1/p' "$1/card.json"; }
awk -v any="$(apart any)" -v wished="$(apart expected)" 'BEGIN { exit !(wished < 0.5 * any) }' ||
  fail "pieces are $(apart any) apart without a wish, $(apart expected) with it"
grep -qE '^  styles +[0-9.]+ apart ' expected/card.txt || fail "the card does not say how far styles are apart"
echo "ok weight"

interrupt USR2 1 parts --set checkpoint.every_s=0.01
expect_code 75 "an interruption"
start 3 parts --resume
expect_end 0 "the rest"
expect_result parts
echo "ok interruption"

run 2 collage job.toml --out none --set style.like=leef
expect_word 'style.like: no shape of the library has a name like "leef"; near it are: leaf'
run 2 collage job.toml --out none --set style.weight=-1
echo "ok errors"
