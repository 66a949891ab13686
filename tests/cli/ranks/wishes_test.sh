#!/usr/bin/env bash
# wishes_test.sh TESSERA MPIRUN NEW_FOLDER: a job with mirror images, distances, groups and a table of wishes.
# The pieces are the same on one rank, on three, and after interruptions. The result no longer needs the table. Another table makes another
# job.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/restart_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../restart_fixture.sh"

enter_folder
run 0 library info own.h5 --names
mapfile -t names <output
[[ ${#names[@]} -ge 5 ]] || fail "names: ${names[*]}"
printf '%s\r\n' 'names,weight,scale_px,mirrored,apart_px,group' "${names[0]},2,\"[20, 50]\",only,30,first" \
  "${names[1]},,,never,,\"second, and last\"" >wishes.csv
cat >job.toml <<'END'
[library]
file = 'own.h5'
wishes = 'wishes.csv'
[canvas]
size_px = [240, 180]
[pieces]
scale_px = [14, 60]
mirrored = 'also'
apart_px = 8
[improve]
trials = 60
[output]
width_px = 240
[checkpoint]
every_s = 0.2
END
same_on_3_ranks expected collage job.toml
cp expected/pieces.geojson expected.geojson
grep -q '"mirrored":true' expected.geojson || fail "nothing is mirrored"
grep -q '"mirrored":false' expected.geojson || fail "all is mirrored"
! grep -q "\"shape\":\"${names[0]}\".*\"mirrored\":false" expected.geojson || fail "not only mirrored: ${names[0]}"
! grep -q "\"shape\":\"${names[1]}\".*\"mirrored\":true" expected.geojson || fail "mirrored: ${names[1]}"
grep -q '"group":"second, and last"' expected.geojson || fail "no group"
grep -q 'inkscape:label="second, and last"' expected/collage.svg || fail "no layer"
echo "ok what was wished for"

expect_result expected_on_3
echo "ok three ranks"

interrupt USR2 1 parts --set checkpoint.every_s=0.01
expect_code 75 "an interruption"
interrupt USR2 3 parts --resume
expect_code 75 "an interruption on three ranks"
start 1 parts --resume
expect_end 0 "the rest"
expect_result parts
echo "ok interruptions"

# The result holds the content of the table.
mv wishes.csv elsewhere.csv
cp expected/collage.png before.png
run 0 draw expected --png --quiet
cmp before.png expected/collage.png || fail "another picture without the table"
cp expected/job.toml again.toml
run 0 collage again.toml --out again --quiet
cmp expected.geojson again/pieces.geojson || fail "job.toml gives other pieces"
run 2 collage job.toml --out lost --quiet
expect_word "library.wishes: "
expect_word "wishes.csv: not a readable file"
echo "ok without the table"

sed 's/,2,/,3,/' elsewhere.csv >wishes.csv
interrupt USR2 1 changed --set checkpoint.every_s=0.01
expect_code 75 "an interruption of what then changes"
cp elsewhere.csv wishes.csv
run 2 collage job.toml --out changed --resume --quiet
expect_word "[[shapes]]: others than then"
echo "ok another table"
