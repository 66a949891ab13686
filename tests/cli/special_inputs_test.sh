#!/usr/bin/env bash
# special_inputs_test.sh TESSERA NEW_FOLDER: pipes, devices, folders and kernel files as the input of every command and as the file of every
# key. The program refuses each at once, by name, with exit code 2.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

# refused NAME COMMAND...: the message contains NAME.
refused() {
  run 2 "${@:2}"
  rm -rf none ./none.*
  [[ $(wc -l <errors) == 1 ]] || fail "not refused in one line: ${*:2}"
  expect_word "$1"
}

# Each of them would wait or read for ever.
as_input_of_every_command() { # FILE
  refused "$1" plan "$1"
  refused "$1" collage "$1" --out none
  refused "$1" campaign "$1" --seeds 1 --out none
  refused "$1" card "$1" --size 100,100
  refused "$1" card result/pieces.geojson --canvas "$1"
  refused "$1" rank "$1" --out none
  refused "$1" draw "$1"
  refused "$1" draw result --library "$1" --to none
  refused "$1" draw result --palette "$1" --to none
  refused "$1" refine "$1" --relax --out none
  refused "$1" refine result --erase "$1" --out none
  refused "$1" library build "$1" -o none.h5
  refused "$1" library extract "$1" --element-px 75 -o none.h5
  refused "$1" library extract sun.png --labels "$1" -o none.h5
  refused "$1" library info "$1"
  refused "$1" library styles "$1"
  refused "$1" library merge own.h5 "$1" -o none.h5
  refused "$1" library subset "$1" --include 'b*' -o none.h5
  refused "$1" mosaic "$1" own.h5 --job-only --job none.toml
  refused "$1" mosaic sun.png "$1" --job-only --job none.toml
  refused "$1" mosaic sun.png own.h5 --salient "$1" --job-only --job none.toml
  refused "$1" puzzle make "$1" --out none
  refused "$1" puzzle solve "$1" --size 100,100 --job none.toml
  refused "$1" puzzle solve own.h5 --frame "$1" --job none.toml
  refused "$1" nest "$1" --strip 50 --out none
  refused "$1" bench pairs --library "$1" --out none.json
}

as_file_of_every_key() { # FILE
  local key
  for key in library.file library.wishes canvas.file canvas.keep_out pieces.size_map colour.palette colour.image \
    start.pieces output.ground; do
    refused "$key" collage job.toml --out none --set "$key='$1'" --set "colour.pieces=artwork"
    expect_word "$1"
  done
  refused library.files plan files.toml --set "library.files=['own.h5', '$1']"
  expect_word "$1"
}

enter_folder
rsvg-convert drawings/leaf.svg -o sun.png
mkdir folder
mkfifo pipe
write_job '64, 48' '14, 40' 64
sed 's/^file = .*/files = ["own.h5"]/' job.toml >files.toml
run 0 collage job.toml --out result --quiet

for file in pipe folder /dev/zero /proc/kmsg; do
  as_input_of_every_command "$file"
  as_file_of_every_key "$file"
  echo "ok $file"
done

# A result's folder may hold such files, also in place of its own files. No command waits for them, and they stay unchanged.
for name in manifest.json pieces.geojson job.toml card.json checkpoint.h5; do
  cp -r result special
  rm -f "special/$name"
  mkfifo "special/$name"
  for command in "draw special" "refine special --relax --out none" "rank special" \
    "collage job.toml --out special --resume" "card special"; do
    # shellcheck disable=SC2086
    run "0 1 2" $command
    [[ $code == 0 ]] || expect_word special
  done
  [[ -p special/$name ]] || fail "special/$name is none any more"
  rm -r special
done
echo "ok results"
