#!/usr/bin/env bash
# bench_mosaic_test.sh TESSERA NEW_FOLDER: tessera bench mosaic with metapixel, which a script replaces, and without it.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

enter_folder
echo "<svg xmlns='http://www.w3.org/2000/svg' width='300' height='200'><rect width='300' height='200' fill='#48c'/>
  <circle cx='90' cy='100' r='60' fill='#fc4'/></svg>" >sun.svg
rsvg-convert sun.svg -o sun.png

# A replacement of metapixel that returns the image itself, a perfect mosaic. It keeps its arguments.
mkdir peer
cat >peer/metapixel-prepare <<'END'
#!/bin/sh
echo dots
echo "$@" >prepare_arguments
ls "$1" | wc -l >tiles
[ -d "$2" ] && cp "$1/0.png" tile.png
END
cat >peer/metapixel <<'END'
#!/bin/sh
echo "$@" >mosaic_arguments
cp "$2" "$3"
END
chmod +x peer/*

options=(--library own.h5 --image sun.png --quick --set output.width_px=300)
run_program 0 env PATH="$PWD/peer:$PATH" "$tessera" bench mosaic "${options[@]}" --grounds '#ff0000' --out b/m.json
grep -qE '^tessera +sun.png +[0-9]+ +[0-9.]+ +-?[0-9.]+ ' output || fail "no row of ours: $(cat output)"
grep -qE '^metapixel on #ff0000 +sun.png +[0-9]+ +0\.00 +1\.000 +0\.00 +1\.000 ' output || fail "no row of the peer's: $(cat output)"
grep -q dots output && fail "the peer's words among ours"
[[ $(cat tiles) == 5 ]] || fail "not all drawings of the library: $(cat tiles)"
grep -q -- '--width=64 --height=64' prepare_arguments || fail "no sizes of tiles: $(cat prepare_arguments)"
grep -q -- '--distance=0 --metric=subpixel' mosaic_arguments || fail "not as documented: $(cat mosaic_arguments)"
[[ -s b/m/1_sun/collage.png && -s b/m/1_sun_metapixel_ff0000.png ]] || fail "no pictures to look at: $(ls b/m)"
[[ $(wc -l <b/m.csv) == 3 ]] || fail "no CSV: $(cat b/m.csv)"
tr -d ' \n' <b/m.json | grep -q '"metapixel":true,"rows":\[{"image":"sun.png","mosaic":"tessera","picture":' ||
  fail "no JSON: $(cat b/m.json)"
# The figure of our mosaic is that of its card.
card_figure=$(grep -A4 '"at_100_px"' b/m/1_sun/card.json | sed -n 's/.*"ciede2000": \([0-9.]*\).*/\1/p')
grep -q "\"ciede2000\": $card_figure," b/m.json || fail "another figure than on the card: $card_figure"
[[ -z $(find "${TMPDIR:-/tmp}" -maxdepth 1 -name 'tessera-bench-*' -newer sun.png) ]] || fail "tiles are left behind"
echo "ok beside the peer"

printf '#!/bin/sh\nexit 3\n' >peer/metapixel
run_program 1 env PATH="$PWD/peer:$PATH" "$tessera" bench mosaic "${options[@]}" --out b/failed.json
expect_word 'ended with exit code 3: metapixel --metapixel '
rm peer/metapixel
cp sun.png second.png
run_program 0 env PATH="$PWD/peer" "$tessera" bench mosaic "${options[@]}" --image second.png --out b/alone.json
grep -q '^metapixel is not installed' output || fail "no word of the peer that is not there: $(cat output)"
[[ $(wc -l <b/alone.csv) == 3 ]] || fail "not ours of both images: $(cat b/alone.csv)"
echo "ok without the peer"

expect_refusal() { # WORD ARGUMENT...
  run 2 bench mosaic "${@:2}"
  expect_word "$1"
}
expect_refusal '--image: none.png: not a readable file' --library own.h5 --image none.png
expect_refusal '--grounds: found red; allowed: #rrggbb' --library own.h5 --image sun.png --grounds red
expect_refusal '--pieces: found 99; allowed: 100 to 40000' --library own.h5 --image sun.png --pieces 99
expect_refusal 'none.h5: ' --library none.h5 --image sun.png
[[ ! -e out/bench_mosaic ]] || fail "a mistake left a folder"
echo "ok refusals"
