#!/usr/bin/env bash
# planted_files_test.sh TESSERA NEW_FOLDER: in a shared folder others have planted links and pipes under all temporary names that the
# program uses.
# No file behind a link changes, nothing waits, and the outputs are right.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

# Writes every kind of output into the folder "made". Commands with existing outputs may run again.
write_all() {
  run 0 library build drawings spoiled.png -o made/own.h5
  run 0 library info made/own.h5 --sheet made/sheet.png
  run 0 library styles made/own.h5 --sheet made/styles.png
  run 0 library subset made/own.h5 --include 'b*' -o made/few.h5
  run 0 mosaic sun.png made/own.h5 --pieces 100 --job-only --job made/sun.toml
  run 0 campaign job.toml --seeds 1 --out made/campaign
  run 0 draw made/campaign/seed_1 --width 600 --pdf --tiff --quiet
  run 0 draw made/campaign/seed_1 --png --to made/elsewhere --quiet
  run 0 rank made/campaign --out made/ranking
  run 0 nest parts.json --effort draft --out made/layout --quiet
}

# The digests of all files without the time of day.
digests() {
  find made -type f ! -name 'card*' ! -name 'ranking*' ! -name manifest.json ! -name run.log -exec sha256sum {} + |
    sort -k 2
}

# plant COMMAND...: runs COMMAND, which makes a file, for each of several names. They are the temporary ones of all files in "made", and of
# files that come and go.
plant() {
  local file
  while read -r file; do "$@" "$file.tmp" || fail "not planted: $file.tmp"; done < <(
    find made -type f ! -name run.log
    printf 'made/%s\n' campaign/seed_1/checkpoint{,.previous}.h5
  )
  "$@" made/campaign/seed_1/collage.tiff.tmp.level
}

enter_folder
precious=$folder/precious
echo precious >"$precious"
printf 'no picture' >spoiled.png
echo "<svg xmlns='http://www.w3.org/2000/svg' width='300' height='200'><rect width='300' height='200' fill='#48c'/>
  <circle cx='90' cy='100' r='60' fill='#fc4'/></svg>" >sun.svg
rsvg-convert sun.svg -o sun.png
cat >parts.json <<'JSON'
{"name": "parts", "strip_height": 40, "items": [
  {"id": 0, "demand": 4, "allowed_orientations": [0, 180], "shape": {"type": "simple_polygon", "data": [[0,0],[20,0],[10,15],[0,0]]}}]}
JSON
write_job '120, 90' '14, 40' 120
sed -i "s/own.h5/made\/own.h5/" job.toml
printf '[checkpoint]\nevery_s = 0.001\n' >>job.toml
mkdir made
write_all
digests >digests.first
find made | sort >files.first

for kind in "ln -s $precious" "ln $precious" mkfifo; do
  # shellcheck disable=SC2086
  plant $kind
  rm made/sun* made/campaign/seed_1/manifest.json # these are made again
  write_all
  digests | diff digests.first - || fail "other files where others had planted: $kind"
  find made | sort | diff files.first - || fail "a file too many or too few: $kind"
  [[ -z $(find made -type l -o -type p) ]] || fail "something planted is left: $kind"
  [[ $(cat "$precious") == precious ]] || fail "a file of the user's was changed: $kind"
  echo "ok $kind"
done

# Names that stay: a file that is written anew is replaced; a file that is appended to or locked is refused.
for name in ranking.csv ranking.json ranking.png; do ln -sf "$precious" "made/ranking/$name"; done
run 0 rank made/campaign --out made/ranking
[[ -z $(find made -type l) ]] || fail "a link stands for the ranking"
for kind in "ln -s $precious" "ln $precious" mkfifo; do
  rm made/campaign/seed_1/run.log
  $kind made/campaign/seed_1/run.log
  run 0 draw made/campaign/seed_1 --png --quiet
  $kind made/own.h5.lock
  run 1 library build drawings -o made/own.h5
  expect_word 'made/own.h5.lock: found a '
  rm made/own.h5.lock
done
[[ $(cat "$precious") == precious ]] || fail "a file of the user's was changed"
echo "ok names that stay"
