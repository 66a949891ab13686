#!/usr/bin/env bash
# unwritable_outputs_test.sh TESSERA NEW_FOLDER: an output that cannot be written is found before any work is done. The program prints that
# error and nothing else.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

# before_work MESSAGE COMMAND...: the command fails at once with MESSAGE
before_work() {
  run "${ends_by:-1}" "${@:2}"
  [[ ! -s output ]] || fail "work was done before: ${*:2}"
  [[ $(wc -l <errors) == 1 ]] || fail "more than one line: ${*:2}"
  expect_word "$1"
  [[ -z $(find . -name '*.tmp' ! -type d -o -name '*.lock') ]] || fail "something half-written: ${*:2}"
}

enter_folder
rsvg-convert drawings/leaf.svg -o sun.png
printf 'no picture' >spoiled.png
write_job '64, 48' '14, 40' 64
run 0 collage job.toml --out result --quiet
cp own.h5 another.h5

# A folder has the name of the output file or of its temporary file.
for taken in taken.png taken.json free.png.tmp free.left_out.txt free.json.tmp free.toml.tmp found/sun_found.png; do
  mkdir -p "$taken/inside"
done
echo "a file" >file
is_folder=': Is a directory'
in_the_way='is in the way and cannot be removed: Is a directory'
before_work "cannot write free.left_out.txt$is_folder" library build drawings spoiled.png -o free.h5
before_work "cannot write free.left_out.txt$is_folder" library merge own.h5 another.h5 -o free.h5
before_work "cannot write taken.png$is_folder" library info own.h5 --sheet taken.png
before_work "cannot write free.png: free.png.tmp $in_the_way" library styles own.h5 --sheet free.png
before_work "cannot write taken.png$is_folder" library extract sun.png --element-px 75 -o new.h5 --ground taken.png
before_work "cannot write found/sun_found.png$is_folder" library extract sun.png --element-px 75 -o new.h5 --overview found
ends_by=2 before_work 'cannot write into the folder file: file is a file; give another output' library extract sun.png --element-px 75 -o new.h5 --overview file
before_work "cannot write free.toml: free.toml.tmp $in_the_way" mosaic sun.png own.h5 --job free.toml
before_work "cannot write taken.json$is_folder" bench pairs --out taken.json
before_work "cannot write free.json: free.json.tmp $in_the_way" bench pairs --out free.json
ends_by=2 before_work 'cannot write into the folder file: file is a file; give another output' rank result --out file
before_work 'cannot write nowhere/new.h5: the folder nowhere: No such file or directory; give another output' \
  library build drawings -o nowhere/new.h5
for command in "draw result --to" "collage job.toml --out" "refine result --relax --out" "campaign job.toml --seeds 1 --out" \
  "nest own.h5 --strip 100 --out"; do
  # shellcheck disable=SC2086
  ends_by=2 before_work 'cannot write into the folder file/a: file is a file; give another output' $command file/a
done
for command in "library build drawings -o" "library subset own.h5 --include * -o" "puzzle solve own.h5 --job-only --job"; do
  set -f
  # shellcheck disable=SC2086
  ends_by=2 before_work 'cannot write file/new: file is a file; give another output' $command file/new
  set +f
done
ends_by=2 before_work 'cannot write into the folder own.h5: own.h5 is a file; give another output' collage job.toml --out own.h5
# /proc, where no user can make a folder.
for command in "draw result --to" "collage job.toml --out" "campaign job.toml --seeds 1 --out" "nest own.h5 --strip 100 --out"; do
  # shellcheck disable=SC2086
  before_work '; give another output' $command /proc/folder
done
for name in collage.svg collage.png collage.pdf collage.tiff; do
  mkdir -p "elsewhere/$name"
  before_work "cannot write elsewhere/$name$is_folder" draw result --to elsewhere --png --svg --pdf --tiff --quiet
  [[ -z $(find elsewhere -name 'collage*' -type f) ]] || fail "a picture before the one that cannot be written"
  rm -r elsewhere
done
for command in "collage job.toml --restart" "refine result --relax"; do
  for name in pieces.geojson card.json card.txt job.toml manifest.json collage.png collage.svg checkpoint.h5; do
    mkdir -p "out/$name.tmp/inside"
    # shellcheck disable=SC2086
    before_work "cannot write out/$name: $name.tmp $in_the_way" $command --out out
    rm -r out
  done
done
for name in layout.json.tmp card.txt.tmp layout.svg layout.svg.tmp layout_12.dxf layout_12.dxf.tmp; do
  mkdir -p "nested/$name/inside"
  echo 'tessera nest: own' >nested/card.txt
  before_work "cannot write nested/$name: is a folder; remove it" nest own.h5 --strip 100 --effort best --out nested
  rm -r nested
done
# The pieces do not fit: a run that solves first says so, and ends with another exit code.
for name in jigsaw.toml jigsaw_pieces.geojson; do
  mkdir -p "$name.tmp/inside"
  before_work "cannot write $name: $name.tmp $in_the_way" puzzle solve own.h5 --job jigsaw.toml --job-only
  rm -r "$name.tmp"
done
for command in "puzzle solve own.h5 --job jigsaw.toml" "mosaic sun.png own.h5 --job free_mosaic.toml"; do
  mkdir -p out/card.json.tmp/inside
  # shellcheck disable=SC2086
  before_work "cannot write out/card.json: card.json.tmp $in_the_way" $command --out out
  rm -r out
done
for name in ranking.csv ranking.json ranking.png; do
  mkdir -p "ranked/$name.tmp/inside"
  before_work "cannot write ranked/$name: $name.tmp $in_the_way" rank result --out ranked
  before_work "cannot write ranked/$name: $name.tmp $in_the_way" campaign job.toml --seeds 1-2 --out ranked
  [[ $(ls ranked) == "$name.tmp" ]] || fail "work before a ranking that cannot be written"
  rm -r ranked
done
mkdir -p campaign/seed_2/card.txt.tmp/inside
before_work "cannot write campaign/seed_2/card.txt: card.txt.tmp $in_the_way" campaign job.toml --seeds 1-2 --out campaign
rm -r campaign/seed_2
echo "a file" >campaign/seed_2
ends_by=2 before_work 'campaign/seed_2' campaign job.toml --seeds 1-2 --out campaign
[[ ! -e campaign/seed_1 ]] || fail "a collage of a campaign that cannot be finished"
mkdir -p report.svg.tmp/inside
before_work "cannot write report.svg: report.svg.tmp $in_the_way" bench quality --library own.h5 --quick --out report.json
echo "ok"
