#!/usr/bin/env bash
# erase_test.sh TESSERA MPIRUN NEW_FOLDER: pieces of a finished result are removed by number, by rectangle or by scribble, or are swapped.
# All others stay byte for byte, and new pieces fill their places.
# The result is the same on one rank, on three, and after an interruption. Impossible requests are refused.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"

enter_folder
cat >job.toml <<'END'
[library]
file = 'own.h5'
[canvas]
size_px = [240, 180]
[pieces]
scale_px = [20, 80]
mirrored = 'also'
[[given]]
shape = 'star'
at_px = [100.12345, 90]
scale_px = 50.33333
rotation_deg = 20.12345
[improve]
trials = 40
[output]
width_px = 120
END
features() { grep '"type":"Feature",' "$1/pieces.geojson" | sed 's/,$//'; }
count() { features "$1" | wc -l; }
nameless() { sed 's/"index":[0-9]*,//; s/"locked":true,//'; } # without its number in the file and its lock
names_of() { sed -n 's/.*"shape":"\([^"]*\)".*/\1/p'; }
digest() { (cd "$1" && find . -type f -exec sha256sum {} + | sort); }

# expect_all_but BEFORE AFTER INDEX...: AFTER begins with the other pieces of BEFORE, unchanged.
expect_all_but() {
  local before=$1 after=$2 removed
  removed=$(printf '"index":%s,|' "${@:3}")
  features "$before" | grep -vE "\"properties\":\{(${removed%|})" | nameless >kept
  [[ $(wc -l <kept) == $(($(count "$before") - $# + 2)) ]] || fail "the test's own count: $*"
  features "$after" | sed -n "1,$(wc -l <kept)p" | nameless | cmp - kept || fail "$after: others have changed"
  features "$after" | tail -n +"$(($(wc -l <kept) + 1))" >new
  features "$before" | grep -E "\"properties\":\{(${removed%|})" | boxes | boxed >room
  boxes <new | while read -r low_x low_y high_x high_y; do
    read -r x0 y0 x1 y1 <room
    awk "BEGIN {exit !($low_x >= $x0 - 21 && $low_y >= $y0 - 21 && $high_x <= $x1 + 21 && $high_y <= $y1 + 21)}" ||
      fail "$after: a new piece at $low_x,$low_y,$high_x,$high_y outside of $(cat room)"
  done || exit 1
  expect_not_back "$before" "${@:3}"
}
# expect_not_back BEFORE INDEX...: no new piece is one of these shapes within half its size of its old place.
places() {
  sed -n 's/.*"shape":"\([^"]*\)".*"scale":\([0-9.]*\),.*"x_px":\([-0-9.]*\),"y_px":\([-0-9.]*\),.*/\1 \2 \3 \4/p'
}
expect_not_back() {
  local index shape scale x y
  for index in "${@:2}"; do
    read -r shape scale x y < <(features "$1" | grep "\"properties\":{\"index\":$index," | places)
    [[ -n $y ]] || fail "the test's own place of $index"
    places <new | awk -v shape="$shape" -v s="$scale" -v x="$x" -v y="$y" \
      '$1 == shape && ($3 - x) ^ 2 + ($4 - y) ^ 2 < (s / 2) ^ 2 {exit 1}' || fail "$1: $index, $shape, came back"
  done
}
# Prints a line for each piece's polygon: lowest and highest x and y.
boxes() {
  sed 's/.*"coordinates"://; s/\],\[/ /g; s/[][}]//g' |
    awk '{for (i = 1; i <= NF; ++i) {split($i, p, ","); if (i == 1 || p[1] < a) a = p[1]; if (i == 1 || p[2] < b) b = p[2]
      if (i == 1 || p[1] > c) c = p[1]; if (i == 1 || p[2] > d) d = p[2]} print a, b, c, d}'
}
# Prints the box around all boxes.
boxed() {
  awk '{if (NR == 1 || $1 < a) a = $1; if (NR == 1 || $2 < b) b = $2; if (NR == 1 || $3 > c) c = $3
    if (NR == 1 || $4 > d) d = $4} END {print a, b, c, d}'
}

run 0 collage job.toml --out first --quiet
digest first >before
[[ $(count first) -ge 10 ]] || fail "too few pieces for this test: $(count first)"

same_on_3_ranks erased refine first --pieces 3,5 --quiet
expect_silence "pieces go"
expect_all_but first erased 3 5
[[ -s new ]] || fail "nothing came in"
[[ $(features erased | grep -c '"locked":true') == 1 ]] || fail "others are locked than the given one"
run 0 refine first --pieces 5,3,5 --quiet
cmp erased/pieces.geojson first-erased/pieces.geojson || fail "the order of the numbers counts"
run 0 refine first --pieces 3,5 --set seed=99 --set improve.trials=600 --out another
expect_all_but first another 3 5
grep -qxF "2 of $(count first) pieces go" output || fail "does not say how many go: $(cat output)"
cmp -s erased/pieces.geojson another/pieces.geojson && fail "another seed fills as the first did"
planned() { sed -n 's/^  pieces  *about //p' output; }
run 0 plan first/job.toml
whole=$(planned)
run 0 plan erased/job.toml
[[ $(planned) -lt $((whole / 2)) ]] || fail "a plan of two pieces' room: $(planned) of $whole"
echo "ok numbers"

long=(refine first --pieces '3,5' --set improve.trials=400 --set checkpoint.every_s=0.01 --quiet)
run 0 "${long[@]}" --out whole
"$tessera" "${long[@]}" --out broken >output 2>errors &
started=$!
until [[ -s broken/checkpoint.h5 ]] || ! kill -0 "$started" 2>/dev/null; do sleep 0.01; done
kill -s INT "$started" 2>/dev/null
wait "$started"
code=$?
[[ $code == 75 ]] || fail "exit code $code of an interrupted refinement, not 75"
run 0 "${long[@]}" --out broken --resume
cmp whole/pieces.geojson broken/pieces.geojson || fail "other pieces after an interruption"
echo "ok interrupted"

# The job of a refinement makes the same result again, and the next refinement starts from it.
run 0 collage erased/job.toml --out again --quiet
cmp erased/pieces.geojson again/pieces.geojson || fail "job.toml makes something else"
run 0 refine erased --pieces 4 --lock 1,2 --out chain --quiet
expect_all_but erased chain 4
[[ $(features chain | grep -c '"locked":true') == 3 ]] || fail "not locked"
run 0 refine chain --relax --quiet
for shape in $(features chain | grep '"locked":true' | nameless | sha256sum | cut -c1-64); do
  [[ $shape == $(features chain-relaxed | grep '"locked":true' | nameless | sha256sum | cut -c1-64) ]] ||
    fail "locked pieces have moved"
done
echo "ok chain"

# index_near X Y: prints the index of the piece with the nearest centre.
index_near() {
  features first | sed -n 's/.*"index":\([0-9]*\),.*"x_px":\([-0-9.]*\),"y_px":\([-0-9.]*\),.*/\1 \2 \3/p' |
    awk -v x="$1" -v y="$2" '{d = ($2 - x) ^ 2 + ($3 - y) ^ 2; if (NR == 1 || d < least) {least = d; i = $1}}
      END {print i}'
}
in_box() { # X Y W H: prints all of them that are not locked
  features first | grep -v '"locked":true' |
    sed -n 's/.*"index":\([0-9]*\),.*"x_px":\([-0-9.]*\),"y_px":\([-0-9.]*\),.*/\1 \2 \3/p' |
    awk -v x="$1" -v y="$2" -v w="$3" -v h="$4" '$2 >= x && $2 <= x + w && $3 >= y && $3 <= y + h {print $1}'
}
mapfile -t inside < <(in_box 0 0 120 90)
[[ ${#inside[@]} -ge 2 ]] || fail "too few pieces in the rectangle: ${inside[*]}"
run 0 refine first --box 0,0,120,90 --out boxed --quiet
expect_all_but first boxed "${inside[@]}"
echo "ok box"

corner=$(index_near 230 170)
cat >scribble.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="480" height="360">
<path d="M470 350l6 6" stroke="#f00" stroke-width="8" fill="none"/></svg>
END
run 0 refine first --erase scribble.svg --out scribbled --quiet
expect_all_but first scribbled "$corner"
echo "ok scribble"

mapfile -t shapes < <(features first | names_of)
same_on_3_ranks swapped refine first --swap 3 --quiet
expect_all_but first swapped 3
[[ -s new ]] || fail "nothing came in"
names_of <new | grep -qxF "${shapes[3]}" && fail "${shapes[3]} came in again"
run 0 refine first --swap 3 --quiet
cmp swapped/pieces.geojson first-swapped/pieces.geojson || fail "another folder, other pieces"
run 0 collage swapped/job.toml --out swapped_again --quiet
cmp swapped/pieces.geojson swapped_again/pieces.geojson || fail "job.toml of a swap makes something else"
run 0 refine swapped --box 0,0,240,180 --out all_anew --quiet
features all_anew | names_of | grep -qxF "${shapes[3]}" || fail "${shapes[3]} never comes in again"
echo "ok swap"

# The erased shape would fit its hole best, but must not return: each piece alone, with two seeds.
for ((i = 1; i < 5; ++i)); do
  for seed in 1 2; do
    run 0 refine first --pieces "$i" --set "seed=$seed" --out one --restart --quiet
    expect_all_but first one "$i"
  done
done
# It may return if the library has no other shape.
mkdir alone
draw_svg alone/bean "M10 50 C10 10 90 10 90 50 C90 80 60 60 50 60 C40 60 10 90 10 50Z"
run 0 library build alone -o alone.h5
sed "s/own.h5/alone.h5/; /^\[\[given/,/^rotation_deg/d" job.toml >alone.toml
run 0 collage alone.toml --out beans --quiet
same_on_3_ranks beans_erased refine beans --pieces 0 --quiet
expect_word 'warning: 1 of 1 piece of start.remove came back to where they lay: the library, [[shapes]] and pieces.uses allow no other drawing there'
echo "ok not back"

# Each result names the digest of the pieces that it began from.
pieces_digest() { grep -o '"pieces":{"digest":"[0-9a-f]*"' "$1/manifest.json" | grep -o '[0-9a-f]\{16\}'; }
start_digest() { grep -o '"start":{[^}]*}' "$1/manifest.json" | grep -o '[0-9a-f]\{16\}'; }
[[ $(start_digest chain) == "$(pieces_digest erased)" && $(start_digest erased) == "$(pieces_digest first)" ]] ||
  fail "digests: $(start_digest chain), $(pieces_digest erased); $(start_digest erased), $(pieces_digest first)"
[[ -z $(start_digest first) ]] || fail "first began from nothing"

run 0 refine first --box 0,0,120,90 --variants 3
[[ -s first-variants/ranking.png && $(grep -c seed_ output) -ge 3 ]] || fail "no sheet of variants"
cmp boxed/pieces.geojson first-variants/seed_1/pieces.geojson || fail "the first variant is not that of the job's seed"
for seed in 2 3; do
  expect_all_but first "first-variants/seed_$seed" "${inside[@]}"
  cmp -s boxed/pieces.geojson "first-variants/seed_$seed/pieces.geojson" && fail "variants do not differ"
done
run_on_ranks 3 2 refine first --box 0,0,120,90 --variants 2 --out variants_on_3
expect_word '--variants: found 3 ranks, allowed: 1'
echo "ok variants"

# refused MESSAGE ARGUMENT...: the message is one line
refused() {
  run 2 refine first "${@:2}"
  expect_word "$1"
  [[ $(wc -l <errors) == 1 ]] || fail "not one line: $1"
}
last=$(($(count first) - 1))
refused "--pieces: found 400, allowed: 0 to $last, \"index\" of a piece in pieces.geojson" --pieces 400
refused "--lock: found 400, allowed: 0 to $last" --relax --lock 400
refused '--pieces: found 0, "star", which is locked' --pieces 2,0
refused '--swap: found 0, "star", which is locked' --swap 0
refused '--box 95.0,85.0,10.0,10.0: found locked pieces only, needed: one at least that is not locked' \
  --box 95,85,10,10
refused '--box 900.0,0.0,10.0,10.0: found no piece with its centre in it; the canvas is 240 x 180 px' --box 900,0,10,10
cat >photo.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="240" height="180"><linearGradient id="g"><stop stop-color="#fff"/>
<stop offset="1" stop-color="#a00"/></linearGradient><rect width="240" height="180" fill="url(#g)"/></svg>
END
refused " of $(count first) pieces; needed: marks over the pieces that are to go, on" --erase photo.svg
expect_word "--erase photo.svg: an opaque picture that covers "
sed 's/height="360"/height="480"/' scribble.svg >tall.svg
refused '--erase tall.svg: found another aspect: fitted into the canvas it has 180 x 180 px, needed: 240 x 180' \
  --erase tall.svg
refused 'none.svg' --erase none.svg
run 2 refine first --pieces 3 --relax
run 2 refine first --box 1,2,3
digest first | cmp - before || fail "the result has changed"
echo "ok errors"
