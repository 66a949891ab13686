#!/usr/bin/env bash
# mosaic_test.sh TESSERA MPIRUN NEW_FOLDER: tessera mosaic, from an image to the job, and from the job to the picture.
set -uo pipefail
tessera=$1
# shellcheck disable=SC2034 # support/ranks.sh
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"

enter_folder
echo "<svg xmlns='http://www.w3.org/2000/svg' width='300' height='200'><rect width='300' height='200' fill='#48c'/>
  <circle cx='90' cy='100' r='60' fill='#fc4'/><path d='M60 120q30 30 60 0' stroke='#000' stroke-width='9'/></svg>" >sun.svg
rsvg-convert sun.svg -o sun.png

run 0 mosaic sun.png own.h5 --pieces 100 --job-only
expect_silence "a warning of a good job"
grep -q '^sun.toml: 287 x 191 px, about 100 pieces of 16 to 80 px out of 5 shapes; sizes: sun_sizes.png' output &&
  grep -q '; 2 regions: sun_regions.png$' output || fail "does not say what it wrote"
grep -qx 'next: tessera collage sun.toml' output || fail "does not say what to type next"
[[ -s sun_sizes.png && ! -e out ]] || fail "no map, or a result"
grep -q '^quality = "draft"' sun.toml || fail "the job does not say how much is improved"
grep -qx 'apart_px = 0' sun.toml && grep -qx 'repetition_exponent = 0' sun.toml || fail "few drawings may not lie again"
grep -qx 'shift = 6' sun.toml || fail "no shift by default"
cp sun.toml first.toml
run 0 mosaic sun.png own.h5 --pieces 100 --job-only --quiet
[[ ! -s output ]] || fail "--quiet prints"
run_on_ranks 3 0 mosaic sun.png own.h5 --pieces 100 --job-only
cmp sun.toml first.toml || fail "another job on three ranks"
echo "ok job"

run 2 mosaic sun.png own.h5 --pieces 200 --job-only
expect_word 'exists with other content; tessera collage sun.toml runs the job as it is, --replace'
cmp sun.toml first.toml || fail "replaced unasked"
run 0 mosaic sun.png own.h5 --pieces 200 --job-only --replace
grep -q 'about 200 pieces' output sun.toml || fail "not replaced"
run 0 mosaic sun.png own.h5 --pieces 100 --job-only --job small.toml --shift 7 --regions 1
grep -qx 'shift = 7' small.toml || fail "--shift is not in the job"
grep -qx 'size_map = "small_sizes.png"' small.toml || fail "the map has not the job's name"
echo "ok files"

portrait=$(dirname "${BASH_SOURCE[0]}")/../../../jobs/photos/astronaut.jpg
run 0 mosaic "$portrait" own.h5 --pieces 100 --job-only --job portrait.toml
expect_silence "a warning of a face"
grep -qx '1 face, with the smallest pieces on eyes and mouth' output || fail "does not say that it has found a face"
TESSERA_CASCADES=$PWD run 0 mosaic "$portrait" own.h5 --pieces 100 --job-only --job unseen.toml
expect_silence "a warning of what is no fault"
grep -q "^faces were not looked for: $PWD/haarcascade_.*\.xml is missing; Debian's package opencv-data" output ||
  fail "does not say that faces were not looked for"
cmp -s portrait_sizes.png unseen_sizes.png && fail "a face changes no sizes"
echo "<svg xmlns='http://www.w3.org/2000/svg' width='30' height='20'><rect width='30' height='20'/>
  <circle cx='24' cy='4' r='3' fill='#fff'/></svg>" >spot.svg
rsvg-convert spot.svg -o spot.png
run 0 mosaic sun.png own.h5 --pieces 100 --job-only --job spot.toml --salient spot.png
grep -q '[0-9] face\|were not looked for' output && fail "speaks of faces where a picture says what is salient"
grep -qx 'small pieces where spot.png is white; faces are not looked for' output || fail "does not say what is salient"
cmp -s sun_sizes.png spot_sizes.png && fail "--salient changes no sizes"
rsvg-convert -w 30 -h 30 spot.svg -o square.png
run 2 mosaic sun.png own.h5 --pieces 100 --job-only --job none.toml --salient square.png
expect_word 'square.png: found 30 x 30 px, allowed: the aspect of the image, 300 x 200 px'
run 0 mosaic sun.png own.h5 --pieces 100 --job-only --job set.toml --set colour.weight=8 --set 'output.background=#ffff00'
grep -qxF "next: tessera collage set.toml --set colour.weight=8 --set 'output.background=#ffff00'" output ||
  fail "the next command forgets --set: $(cat output)"
run 2 mosaic sun.png own.h5 --pieces 100 --job-only --job none.toml --salient sun.png
expect_word 'sun.png: found the colour #4488cc at (0, 0) px, allowed: a grey picture'
run 2 mosaic sun.png own.h5 --pieces 100 --job-only --job none.toml --salient spot.svg
expect_word 'spot.svg: '
mkdir cascades && echo '<opencv_storage>' >cascades/haarcascade_frontalface_alt2.xml
TESSERA_CASCADES=cascades run 1 mosaic sun.png own.h5 --pieces 100 --job-only --job none.toml
expect_word 'cascades/haarcascade_frontalface_alt2.xml: is no cascade of upright Haar-like features'
echo "ok faces"

run 2 mosaic drawings/leaf.svg own.h5 --job-only
expect_word 'found an SVG, needed: a picture of pixels; rsvg-convert -w 2000 FILE.svg -o FILE.png draws one'
run 2 mosaic none.png own.h5 --job-only
expect_word 'none.png: '
run 2 mosaic sun.png drawings --job-only --job none.toml
expect_word 'drawings: found a folder, allowed: a library; tessera library build drawings -o LIB.h5 makes one of its drawings'
run 2 mosaic sun.png none.h5 --job-only --job none.toml
expect_word 'none.h5: '
run 2 mosaic sun.svg own.h5 --job-only --job none.toml
expect_word 'sun.svg: '
run 2 mosaic sun.png own.h5 --job-only --pieces 5 --job none.toml
expect_word '--pieces: found 5, allowed: from 100 to 40000'
run 2 mosaic sun.png own.h5 --job-only --shift 101 --job none.toml
expect_word '--shift'
run 2 mosaic sun.png own.h5 --job-only --shift nan --job none.toml
expect_word '--shift: found nan'
run 2 mosaic sun.png own.h5 --job-only --regions 9 --job none.toml
expect_word '--regions: found 9, allowed: from 1 to 8'
run 2 mosaic sun.png
expect_word 'see tessera mosaic --help'
[[ ! -e none.toml && ! -e none_sizes.png && ! -e none_regions.png ]] || fail "files of a mistake"
echo "ok errors"

same_on_3_ranks out/small mosaic sun.png own.h5 --pieces 100 --job small.toml --shift 7 --regions 1 --set output.width_px=400
grep -q '^written to out/small$' output || fail "no result"
[[ -s out/small/collage.png ]] || fail "no picture"
run 0 collage small.toml --out again --set output.width_px=400
cmp out/small/pieces.geojson again/pieces.geojson || fail "tessera collage makes other pieces of the job"
echo "ok mosaic"

same_on_3_ranks out/parted mosaic sun.png own.h5 --pieces 100 --job parted.toml --set output.width_px=400
[[ -s parted_regions.png ]] || fail "no picture of the regions"
[[ $(grep -c '^\[\[regions\]\]$' parted.toml) == 2 ]] || fail "not a region for the sky and one for the sun"
# Without regions the sky is a whole rectangle; with regions, pieces stay off the sun's edge.
cmp -s out/small/pieces.geojson out/parted/pieces.geojson && fail "regions change nothing"
echo "ok regions"

run 2 mosaic sun.png own.h5 --pieces 100 --job slip.toml --set output.widht_px=400
expect_word 'output.width_px'
[[ ! -e slip.toml && ! -e slip_sizes.png && ! -e slip_regions.png ]] || fail "a mistake left files behind"
run 2 mosaic sun.png own.h5 --pieces 100 --job parted.toml --set output.widht_px=400
[[ -s parted.toml && -s parted_regions.png ]] || fail "a mistake removed the job that was there"
echo "ok mistakes"
