#!/usr/bin/env bash
# first_round_test.sh TESSERA NEW_FOLDER: runs that are ended before their first piece in a folder with an older result, and incomplete
# results.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/restart_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/restart_fixture.sh"

make_job 0
"$tessera" collage job.toml --out kept --quiet || fail "the older result"
cp -r kept before

# end_in_first_round OUT OPTION...: the canvas is so large that the first round takes seconds.
end_in_first_round() {
  local out=$1
  shift
  rm -f "$out/run.log"
  start 1 "$out" --quiet --set 'canvas.size_px=[6000, 6000]' --set 'pieces.scale_px=[14, 20]' "$@"
  until grep -q 'rank 0 of 1' "$out/run.log" 2>/dev/null || ! kill -0 "$started" 2>/dev/null; do sleep 0.01; done
  sleep 0.3
  kill -s TERM "$started"
  expect_end 75 "a signal in the first round"
  grep -q ' 0 pieces$' "$out/run.log" || fail "not in the first round: $(cat "$out/run.log")"
}

end_in_first_round kept
for name in manifest.json pieces.geojson job.toml card.json card.txt collage.svg collage.png; do
  cmp "before/$name" "kept/$name" || fail "replaced by nothing: $name"
done
grep -q 'nothing is placed yet, the finished result in kept is still that of the run before' errors ||
  fail "does not say so"
grep -q 'unfinished: go on with the same command and --resume;' errors || fail "does not say how to go on"
[[ -s kept/checkpoint.h5 ]] || fail "no checkpoint"
"$tessera" draw kept --quiet || fail "the older result cannot be drawn"
end_in_first_round kept --resume=auto
grep -q 'unfinished: the same command goes on with it; nothing is placed yet' errors || fail "does not say how to go on"
cmp before/pieces.geojson kept/pieces.geojson || fail "replaced by nothing when it went on"
end_in_first_round new
[[ -s new/manifest.json && -s new/checkpoint.h5 ]] || fail "an empty result where there was none"
echo "ok the first round"

# An incomplete result with a manifest is made again, and every command names the damaged file.
for name in job.toml pieces.geojson; do
  rm -rf broken
  mkdir broken
  cp -r before broken/one
  cp -r before broken/two
  rm "broken/two/$name"
  "$tessera" rank broken >output 2>errors || fail "rank"
  grep -q "warning: not ranked: broken/two/$name: not found" errors || fail "rank does not say what it leaves out"
  "$tessera" draw broken/two >output 2>errors && fail "drawn without $name"
  grep -q "broken/two/$name: not found" errors || fail "draw does not say what is missing"
  "$tessera" collage job.toml --out broken/two --quiet --resume >output 2>errors &&
    fail "goes on with what is not whole"
  grep -q "the result in its folder is not whole: broken/two/$name: not found" errors ||
    fail "--resume does not say why"
  "$tessera" collage job.toml --out broken/two --quiet --resume=auto >output 2>errors || fail "made anew"
  grep -q "warning: broken/two: this run replaces a result that is not whole: broken/two/$name: not found" errors ||
    fail "does not say why it is made anew"
  cmp before/pieces.geojson broken/two/pieces.geojson || fail "other pieces"
done
echo "ok results that are not whole"
