#!/usr/bin/env bash
# first_collage_test.sh TESSERA MPIRUN NEW_FOLDER: tessera collage FOLDER, from drawings to a library, a job and a picture.
# It also checks the message for a path that is no job.
set -uo pipefail
tessera=$1
# shellcheck disable=SC2034 # support/ranks.sh
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"

new_folder
make_drawings drawings
quick=(--set quality=draft --set stop.pieces=5 --set output.width_px=100)
run 0 collage drawings/ "${quick[@]}"
grep -q '^out/drawings.h5, .* of 5 files: 5 shapes' output || fail "does not say what the library holds"
grep -q '^drawings.toml: 1200 x 900 px, pieces of 34 to 170 px out of 5 shapes; .*: tessera collage drawings.toml$' output ||
  fail "does not say what the job is"
grep -qx 'written to out/drawings' output || fail "does not say where the picture is"
[[ -s out/drawings/collage.png && -s out/drawings.h5 && ! -s errors ]] || fail "no picture, or a warning"
cp drawings.toml first.toml
cp out/drawings/pieces.geojson first.geojson
echo "ok picture"

run 0 collage drawings "${quick[@]}"
cmp drawings.toml first.toml && cmp out/drawings/pieces.geojson first.geojson || fail "another collage"
run_on_ranks 3 0 collage drawings "${quick[@]}" --quiet
cmp out/drawings/pieces.geojson first.geojson || fail "another collage on three ranks"
[[ ! -s output ]] || fail "--quiet prints"
draw_svg drawings/house "M10 50 L50 10 L90 50 V90 H10Z"
run 0 collage drawings "${quick[@]}"
grep -q '^out/drawings.h5, .* of 6 files: 6 shapes' output || fail "does not see the new drawing"
# Another, older folder of the same name: the drawings decide, not the name.
mkdir -p other/drawings && cp -p drawings/star.svg drawings/leaf.svg other/drawings
touch -d '2001-01-01' other/drawings other/drawings/*
run 0 collage other/drawings "${quick[@]}"
grep -q '^out/drawings.h5, .* of 2 files: 2 shapes' output || fail "takes the drawings of another folder"
run 0 collage drawings "${quick[@]}" --quiet
run 0 collage out/drawings.h5 "${quick[@]}" --out of_library
grep -q '^drawings.toml: .* out of 6 shapes' output || fail "a library is no drawings"
echo "ok again"

cp drawings.toml six.toml
draw_svg disc "M50 5 A45 45 0 1 1 49.9 5Z"
run 0 collage drawings --canvas disc.svg --size 400,300 "${quick[@]}"
grep -q '^drawings_disc.toml: 400 x 300 px inside disc.svg, pieces of 8 to 40 px' output || fail "not the shape of the disc"
cmp drawings.toml six.toml && [[ -s out/drawings_disc/collage.png ]] || fail "the drawings in a disc replace those in a rectangle"
grep -qx 'file = "disc.svg"' drawings_disc.toml && grep -q '^size_px = \[400, 300\]' drawings_disc.toml || fail "no canvas in the job"
mkdir elsewhere
(cd elsewhere && run 0 collage ../drawings --canvas ../disc.svg "${quick[@]}" --quiet && grep -qx 'file = "../disc.svg"' drawings_disc.toml) ||
  fail "paths seen from the job"
run 0 collage drawings.toml --set output.width_px=100 --set quality=draft --set stop.pieces=2 --out by_job
echo "ok canvas"

(cd drawings && run 0 collage . "${quick[@]}" --quiet && run 0 collage . "${quick[@]}") || fail "in the folder itself"
grep -qx "       1  the folder of a collage: drawings" drawings/output || grep -q "the folder of a collage" drawings/out/drawings.left_out.txt ||
  fail "its own pictures are drawings"
echo "ok in the folder"

echo '# mine' >>drawings.toml
draw_svg drawings/roof "M10 60 L50 20 L90 60 V95 H10Z"
run 0 collage drawings "${quick[@]}"
grep -q '^out/drawings.h5, .* of 8 files: 7 shapes' output || fail "a changed job keeps new drawings out"
grep -qx 'drawings.toml: you have changed it, so it is kept; --job FILE.toml writes another one' output || fail "does not say that the job is kept"
run 2 collage drawings --size 400,300
expect_word 'drawings.toml: you have changed it, so --size cannot; allowed: canvas.size_px in the job, or --job FILE.toml, which writes another one'
echo 'seed = 1' >drawings_star.toml
cp drawings/star.svg star.svg
run 2 collage drawings --canvas star.svg
expect_word 'drawings_star.toml: exists, and is not the job of a first collage; tessera collage drawings_star.toml runs it; --job FILE.toml writes another one'
run 0 collage drawings --job more.toml "${quick[@]}" --quiet
[[ -s more.toml && -s out/more/collage.png ]] || fail "--job does not give the job another name"
[[ $(tail -n 1 drawings.toml) == '# mine' ]] || fail "an edited job was replaced"
rm drawings.toml
run 2 collage drawings --set pieces.scale=3
expect_word 'pieces.scale'
[[ ! -e drawings.toml ]] || fail "a slip of the pen leaves a job"
run 2 collage drawings --canvas none.svg
expect_word 'none.svg'
run 2 collage drawings --size 400
expect_word '--size: found 400, allowed: W,H'
mkdir empty
run 2 collage empty
expect_word 'no artwork in empty'
[[ ! -e empty.toml && ! -e out/empty.h5 && ! -e out/empty ]] || fail "an empty folder leaves files"
run 2 collage first.toml --size 400,300
expect_word "--size: allowed with a folder of drawings or a library; for a job use --set 'canvas.size_px=[W, H]'"
run 2 collage first.toml --job other.toml
expect_word '--job: allowed with a folder of drawings or a library'
run 2 collage first.toml --canvas disc.svg
expect_word '--canvas: allowed with a folder of drawings or a library; for a job use --set canvas.file=FILE'
echo "ok mistakes"

run 2 collage out/drawings
expect_word 'out/drawings: found the folder of a result, allowed: a job, or a folder of drawings; tessera draw out/drawings'
expect_word 'tessera collage out/drawings/job.toml makes it again'
run 2 collage disc.svg
expect_word 'tessera collage FOLDER --canvas disc.svg fills its shape'
expect_word 'tessera mosaic disc.svg LIB.h5 shows it'
run 2 collage none
expect_word 'none: no such file or folder; allowed: a job file, a folder of drawings, or a library; a name with spaces needs quotes'
run 2 collage none.toml
expect_word 'job file none.toml: not found'
echo "ok no jobs"
