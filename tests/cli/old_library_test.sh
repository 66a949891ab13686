#!/usr/bin/env bash
# old_library_test.sh TESSERA PICTURE_DIFFERENCE NEW_FOLDER: a library that commit a710f4d made of a photo with EXIF orientation 6.
# That commit ignored the orientation. If the pixels were turned as they are today, they would stick out of the outline.
# tests/cli/old_library has the photo and the output of `tessera library build turned.jpg -o leaf.h5 --pad-levels 2`.
set -uo pipefail
tessera=$1
difference=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

old=$(cd "$(dirname "${BASH_SOURCE[0]}")/old_library" && pwd)
enter_folder
cp "$old/turned.jpg" .
gzip -dc "$old/leaf.h5.gz" >leaf.h5
cat >job.toml <<END_OF_JOB
[library]
file = "leaf.h5"
[canvas]
size_px = [300, 200]
[pieces]
scale_px = [60, 90]
[stop]
pieces = 4
[improve]
trials = 0
END_OF_JOB

run 0 collage job.toml --out art --set colour.pieces=artwork
expect_word "4 pieces drawn from thumbnails: original is turned as its EXIF data say"
expect_word "build the library again"
run 0 draw art --to leaves --set colour.pieces=palette --set 'colour.palette=["#22bb77"]'
off=$("$difference" art/collage.png leaves/collage.png | awk '{print int($1)}')
((off < 6)) || fail "the pictures lie $off of 255 off their outlines"

run 0 library build turned.jpg -o leaf.h5
run 0 collage job.toml --out art --restart --set colour.pieces=artwork
! grep -q thumbnails errors || fail "a library that was built again is drawn from thumbnails"
h5dump -d /artwork/size leaf.h5 | grep -q '342, 512' || fail "the photo is not turned"
echo "ok a library of an older program"
