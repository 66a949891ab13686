#!/usr/bin/env bash
# results_test.sh TESSERA NEW_FOLDER: runs into folders that already hold a result, runs without a result, and their messages.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

enter_folder
[[ ! -e own.left_out.txt ]] || fail "a list of what was left out, and nothing was"

# A list beside the library names every file that was left out. The list goes when the library is replaced.
for i in 1 2 3 4 5; do echo "<svg/>" >"drawings/empty$i.svg"; done
cp drawings/bean.svg drawings/bean_again.svg
run 0 library build drawings -o own.h5
grep -qF 'all that was left out: own.left_out.txt' output || fail "does not say where the list is"
[[ $(wc -l <own.left_out.txt) == 6 && $(grep -c $'^skipped\t/.*/drawings/empty.\.svg\t.' own.left_out.txt) == 5 ]] ||
  fail "another list: $(cat own.left_out.txt)"
grep -q $'^merged\t/.*/drawings/bean_again.svg\tthe silhouette and colour of bean$' own.left_out.txt ||
  fail "no copy in the list"
rm drawings/empty?.svg drawings/bean_again.svg
run 0 library build drawings -o own.h5
[[ ! -e own.left_out.txt ]] || fail "the list of the library before is still there"
echo "ok what a library left out"

write_job '120, 90' '14, 60' 120

# The same job may run again. Another job causes a warning on stderr, even in a quiet run.
run 0 collage job.toml --out result --quiet
run 0 collage job.toml --out result --quiet --set devices.use=cpu --set checkpoint.every_s=9
expect_silence "a warning about the same job"
run 0 collage job.toml --out result --quiet --set seed=3 --set output.width_px=64
expect_word 'tessera: warning: result: the finished result of another job is replaced as soon as a piece is placed; '
expect_word 'piece is placed; seed: then 1, now 3; output.width_px: then 120, now 64; another --out keeps it'
[[ $(wc -l <errors) == 1 ]] || fail "not one line"
echo "ok another job's result"

run 3 collage job.toml --out empty --quiet --set 'pieces.scale_px=[200, 300]'
expect_word 'tessera: warning: empty: the collage is empty: nothing fits; try pieces of '
[[ -s empty/collage.png ]] || fail "no picture"
echo "ok nothing fits"

# One of two regions stays empty: the warning names it, and the key that decides there, which is not pieces.scale_px.
cat >halves.svg <<'EOF'
<svg xmlns="http://www.w3.org/2000/svg" width="120" height="90">
<rect width="60" height="90" fill="#ff0000"/><rect x="60" width="60" height="90" fill="#0000ff"/></svg>
EOF
{
  sed 's/^size_px/file = "halves.svg"\n&/' job.toml
  printf '[[regions]]\nname = "left"\ncolour = "#ff0000"\n'
  printf '[[regions]]\nname = "right"\ncolour = "#0000ff"\nscale_px = [1500, 2000]\n'
} >halves.toml
run 0 collage halves.toml --out halves --quiet --set stop.pieces=0
expect_word 'tessera: warning: nothing lies in the region "right"; try pieces of '
expect_word ' px or less, scale_px of [[regions]] "right" (now [1500, 2000]); a larger canvas.size_px (now [120, 90])'
[[ $(wc -l <errors) == 1 ]] || fail "not one line"
grep -qF 'nothing lies in the region "right"' halves/run.log || fail "run.log does not name the region"
run 0 collage halves.toml --out halves --quiet
expect_word 'nothing lies in the region "right": stop.pieces (now 2) ended the collage before it'
sed '/#ff0000/a scale_px = 1200' halves.toml >no_halves.toml
run 3 collage no_halves.toml --out no_halves --quiet --set stop.pieces=0
expect_word ' px or less, scale_px of [[regions]] "left" (now [1200, 1200]), "right" (now [1500, 2000]); a larger'
printf '[[shapes]]\nnames = "*"\nregions = "left"\n' >>halves.toml
run 0 collage halves.toml --out halves --quiet --set stop.pieces=0
expect_word 'nothing lies in the region "right": no shape may stand there by sizes, weights, regions and names of [[shapes]]'
echo "ok a region that stays empty"

# There is more work than time: even with --quiet the program says how to go on, with the options of the command.
forever=(--quiet --time-limit 4 --set stop.pieces=0 --set improve.seconds=1000)
run 75 collage job.toml --out long "${forever[@]}"
expect_word 'tessera: unfinished: go on with the same command and --resume'
run 75 collage job.toml --out long "${forever[@]}" --restart
expect_word 'tessera: unfinished: go on with the same command and --resume instead of --restart'
run 0 rank long result --out ranked
grep -q '^ *long (unfinished) ' output || fail "the ranking does not mark what is unfinished"
grep -q 'result (unfinished)' output && fail "the ranking marks what is finished"
by_area=$(sed -n 's/.*"effective_shapes": \([0-9.]*\),*/\1/p' result/card.json)
grep '^ *result ' output | grep -qF " $(printf %.1f "$by_area") " || fail "the ranking does not show the shapes by area, $by_area"
run 2 collage job.toml --out result --time-limit ""
expect_word 'tessera: --time-limit: found an empty text, allowed: seconds'
echo "ok unfinished"

# Private data stand in the card and the log, and both say how the result was made.
for word in "command: .* collage job.toml --out result --quiet --set seed=3" "rank 0 of 1 on $(hostname): " \
  "end: stopped by" "warning: result: the finished result of another job is replaced" "digest [0-9a-f]\{16\}$"; do
  grep -q -- "$word" result/run.log || fail "result/run.log lacks: $word"
done
[[ $(grep -c ' info: start: ' result/run.log) == 3 ]] || fail "not three runs in result/run.log"
grep -q "$(pwd)" result/card.txt result/collage.svg && fail "a path where none should be"
run 2 collage job.toml --out result --quiet --set pieces.uses=-1
run 0 collage job.toml --out result --quiet --resume=auto --set seed=3 --set output.width_px=64
[[ $(grep -c ' info: start: ' result/run.log) == 3 ]] || fail "a run that did nothing stands in result/run.log"
mkdir -p unlogged/run.log
run 0 collage job.toml --out unlogged --quiet
expect_word 'tessera: warning: no run log: cannot write unlogged/run.log: found a folder, allowed: a regular file'
grep -q 'no run log' unlogged/card.json || fail "the warning is not in the card"
echo "ok what made the result"

# A quality word is a number in the job of the result, which gives the same pieces again.
all_that_fits=(--quiet --set stop.pieces=0)
run 0 collage job.toml --out good "${all_that_fits[@]}" --set quality=good
[[ $(grep -c -e '^quality = ""$' -e '^trials = 17$' good/job.toml) == 2 ]] || fail "no number in good/job.toml"
grep -q '"trials_limit": 17,' good/card.json || fail "no number in good/card.json"
run 0 collage good/job.toml --out again "${all_that_fits[@]}"
cmp good/pieces.geojson again/pieces.geojson || fail "other pieces of the written job"
touch -d '1 hour ago' good/pieces.geojson
cp -p good/pieces.geojson before.geojson
run 0 collage job.toml --out good "${all_that_fits[@]}" --resume=auto --set improve.trials=17
[[ ! good/pieces.geojson -nt before.geojson ]] || fail "made again: the word's number is another job"
run 0 campaign job.toml --out words --set quality=draft,good --set stop.pieces=0
cmp good/pieces.geojson words/quality_good/pieces.geojson || fail "other pieces in a campaign"
grep -q '"trials_limit": 0,' words/quality_draft/card.json || fail "a draft was improved"
sed '/^quality/d' job.toml >no_word.toml
run 0 collage no_word.toml --out no_word "${all_that_fits[@]}"
cmp good/pieces.geojson no_word/pieces.geojson || fail "a job without a word is not good"
echo "ok qualities"

# A campaign keeps finished results, and does not lose results of another job.
run 0 campaign job.toml --seeds 1-2 --out campaign
touch -d '1 hour ago' campaign/seed_*/*
run 0 campaign job.toml --seeds 1-2 --out campaign --set devices.use=cpu
[[ $(grep -c 'finished before' output) == 2 ]] || fail "made again"
cp campaign/seed_1/job.toml before.toml
refused='campaign/seed_1: holds the finished result of another job; pieces.uses: then 0, now 1; give what it was then,'
for list in "" --list; do
  # shellcheck disable=SC2086
  run 2 campaign job.toml --seeds 1-2 --out campaign --set pieces.uses=1 $list
  expect_word "tessera: $refused another --out, or remove that folder"
done
cmp before.toml campaign/seed_1/job.toml || fail "overwritten"

# A second campaign in the folder extends the first, or is refused if the new ranking would leave results out.
cp campaign/ranking.csv before.csv
for other in '--seeds 2-3' '--seeds 2' '--set pieces.uses=1,2' '--seeds 1-2 --set pieces.uses=1,2'; do
  # shellcheck disable=SC2086
  run 2 campaign job.toml --out campaign $other
  expect_word 'tessera: campaign: holds results that this campaign does not make: seed_1'
  expect_word '; give --seeds and --set that make these, too, or another --out'
done
cmp before.csv campaign/ranking.csv || fail "another ranking"
[[ ! -e campaign/seed_3 ]] || fail "a part of the campaign that was refused"
cp -r campaign more
cp -r campaign/seed_1 more/seed_1-relaxed
sed -i '0,/{/s//{"start": {"pieces": "seed_1", "digest": "0000000000000000"},/' more/seed_1-relaxed/manifest.json
run 0 campaign job.toml --seeds 1-3 --out more
[[ $(grep -c 'finished before' output) == 2 ]] || fail "not two of three were there"
echo "ok campaigns"

# A lost card is no lost collage, and a file that cannot be read is no reason to replace a result.
touch -d '1 hour ago' campaign/seed_1/pieces.geojson
cp -p campaign/seed_1/pieces.geojson before.geojson
rm campaign/seed_1/card.json campaign/seed_1/card.txt
run 0 campaign job.toml --seeds 1-2 --out campaign
[[ $(grep -c 'finished before' output) == 2 ]] || fail "made again for a card"
expect_word 'not ranked: campaign/seed_1/card.json: not found'
run 2 rank campaign/seed_1
run 0 draw campaign/seed_1 --png --quiet
expect_word 'the card does not tell of this drawing: campaign/seed_1/card.json: not found'
mv campaign/seed_1/job.toml before.toml
mkdir campaign/seed_1/job.toml
run 1 campaign job.toml --seeds 1-2 --out campaign
for start in "" --resume=auto --restart; do
  # shellcheck disable=SC2086
  run 1 collage job.toml --out campaign/seed_1 --quiet $start
  expect_word 'campaign/seed_1/job.toml: not a readable file'
done
[[ ! campaign/seed_1/pieces.geojson -nt before.geojson ]] || fail "replaced what could not be read"
rmdir campaign/seed_1/job.toml
mv before.toml campaign/seed_1/job.toml
echo "ok lost cards and unreadable files"

# A campaign may have one seed, and a larger campaign takes its result over.
run 0 campaign job.toml --seeds 4 --out single
[[ -s single/seed_4/collage.png && -s single/ranking.csv ]] || fail "no campaign of one seed"
run 0 campaign job.toml --seeds 4-5 --out single
[[ $(grep -c 'finished before' output) == 1 ]] || fail "the single seed was made again"
echo "ok a single seed"

# A file of another origin, or one named by a typing error, is not replaced.
cp drawings/bean.svg before.svg
run 2 library build drawings -o drawings/bean.svg
expect_word 'drawings/bean.svg: is there and is no library; give another name, or remove it'
cmp before.svg drawings/bean.svg || fail "a drawing was replaced by a library"
run 2 library info own.h5 --sheet own.h5
expect_word '--sheet: found own.h5, allowed: a name that ends in .png'
mkdir -p beside_job
sed 's#own.h5#../own.h5#' job.toml >beside_job/job.toml
cp beside_job/job.toml before.toml
run 2 collage beside_job/job.toml --out beside_job --quiet
expect_word 'a result there would replace the job file'
cmp before.toml beside_job/job.toml || fail "a job file was replaced by a result"
mkdir -p strangers
echo mine >strangers/collage.png
run 2 collage job.toml --out strangers --quiet
expect_word 'strangers/collage.png: exists, and no run of tessera wrote it'
[[ $(cat strangers/collage.png) == mine ]] || fail "a stranger's picture was replaced"
echo "ok strangers' files"

# A folder with only a checkpoint is distinguished from one without any.
mkdir -p killed
touch killed/checkpoint.h5
run 2 draw killed
expect_word 'a checkpoint is there: tessera collage with --resume makes the result'
run 2 draw drawings
if grep -q checkpoint errors; then fail "a checkpoint in a folder of drawings"; fi
echo "ok folders without a result"
