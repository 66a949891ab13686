#!/usr/bin/env bash
# restart_test.sh TESSERA MPIRUN NEW_FOLDER: runs that are interrupted and go on, and all faults that a checkpoint can have.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/restart_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../restart_fixture.sh"

# expect_error TEXT OUT OPTION...: the input is refused in one line that contains TEXT
expect_error() {
  local text=$1 out=$2
  shift 2
  start 1 "$out" "$@"
  expect_end 2 "$text"
  [[ $(wc -l <errors) == 1 ]] || fail "not one line: $text"
  grep -qF -- "$text" errors || fail "another error than: $text"
}

# Copies a folder with unfinished work.
unfinished() { # NEW_OUT
  rm -rf "$1"
  cp -r kept "$1"
}

make_job 40

# A run interrupted again and again, on other numbers of ranks, gives the same pieces.
sessions=0
greedy=0
options=(--set checkpoint.every_s=0.01)
while :; do
  interrupt USR2 $((sessions % 3 == 1 ? 3 : 1)) often "${options[@]}"
  [[ $code == 0 ]] && break
  expect_code 75 "often"
  if grep -qF '"state":"finished"' often/manifest.json; then # the signal came while the result was drawn
    start 1 often --resume
    expect_end 0 "often: drawing"
    break
  fi
  [[ -s often/checkpoint.h5 ]] || fail "often: no checkpoint"
  [[ ! -e often/collage.png ]] || fail "often: an unfinished run has drawn"
  grep -q 'go on with the same command and --resume' errors || fail "often: no hint"
  grep -qF '"state":"unfinished"' often/manifest.json || fail "often: another state"
  grep -q 'stopped by *signal' often/card.txt || fail "often: another end"
  grep -q 'of it improving' often/card.txt || greedy=$((greedy + 1))
  sessions=$((sessions + 1))
  options=(--resume)
  ((sessions < 3)) && options+=(--set checkpoint.every_s=0.01)
done
((greedy >= 1 && sessions > greedy)) || fail "often: $sessions interruptions, $greedy of them before improving"
expect_result often
[[ -s often/collage.png && -s often/collage.svg ]] || fail "often: not drawn at the end"
echo "ok often ($sessions interruptions, $greedy of them before improving)"

for signal in INT TERM; do
  interrupt "$signal" 1 "signal_$signal"
  expect_code 75 "$signal"
done
start 3 signal_INT --resume
expect_end 0 "after SIGINT"
expect_result signal_INT
"$tessera" draw signal_TERM >output 2>errors || fail "an unfinished collage is not drawn"
[[ -s signal_TERM/collage.png && -s signal_TERM/checkpoint.h5 ]] || fail "drawing an unfinished collage"
mv signal_TERM kept
cp -r kept kept_once
[[ -f kept/checkpoint.previous.h5 ]] || fail "no previous checkpoint"

interrupt TERM 3 by_mpirun # mpirun then ends with exit code 1, whatever the ranks return
start 1 by_mpirun --resume
expect_end 0 "after SIGTERM to mpirun"
expect_result by_mpirun
echo "ok signals"

start 1 limit --set improve.trials=0 --set improve.seconds=1000 --time-limit 0:00:04
SECONDS=0
expect_end 75 "time limit"
((SECONDS <= 4)) || fail "time limit: $SECONDS s"
grep -q 'stopped by *time_limit' limit/card.txt || fail "time limit: another end"
SLURM_JOB_END_TIME=$(($(date +%s) + 4)) start 1 limit --set improve.trials=0 --set improve.seconds=1000 --resume
expect_end 75 "Slurm's time limit"
grep -q 'going on from limit/checkpoint.h5' output || fail "does not say where it goes on from"
grep -q 'stopped by *time_limit' limit/card.txt || fail "Slurm's time limit: another end"
expect_error 'time-limit: found 0.001, allowed: more than' limit --resume --time-limit 0.001
expect_error 'time-limit: found soon, allowed: seconds, ' limit --resume --time-limit soon
echo "ok time limits"

unfinished start
expect_error 'start/checkpoint.h5: unfinished work; --resume goes on with it, --restart removes it' start
expect_error 'start/checkpoint.h5: unfinished work of another job; pieces.uses: then 0, now 3; give what it was then, or another --out; --restart' \
  start --set pieces.uses=3
rm start/checkpoint.h5
expect_error 'start/checkpoint.previous.h5: unfinished work; --resume=previous goes on with it' start
expect_error 'start/checkpoint.h5: no such file; start/checkpoint.previous.h5 is there: --resume=previous' start \
  --resume
mv start/checkpoint.previous.h5 start/checkpoint.h5
expect_error 'start/checkpoint.previous.h5: no such file; start/checkpoint.h5 is there: --resume goes' start \
  --resume=previous
expect_error 'none/checkpoint.h5: no such file, nothing to go on with' none --resume
expect_error 'none/checkpoint.previous.h5: no such file, nothing to go on with' none --resume=previous
expect_error '--resume' start --resume=yesterday
expect_error '--restart' start --resume --restart
start 1 start --restart
expect_end 0 "--restart"
expect_result start
echo "ok ways to start"

# --resume=auto: the option that a batch script gives each time.
unfinished auto
start 1 auto --resume=auto
expect_end 0 "--resume=auto with a checkpoint"
grep -q 'going on from auto/checkpoint.h5' output || fail "--resume=auto: not from the checkpoint"
expect_result auto
touch -d '1 hour ago' auto/*
start 1 auto --resume=auto --set devices.use=cpu
expect_end 0 "--resume=auto with a finished result"
grep -q 'auto: finished before' output || fail "--resume=auto: no word of the finished result"
[[ ! auto/pieces.geojson -nt kept/pieces.geojson ]] || fail "--resume=auto: made again"
expect_error 'auto: holds the finished result of another job; seed: then 1, now 4; give what it was then' auto \
  --resume=auto --set seed=4
rm -r auto
start 3 auto --resume=auto
expect_end 0 "--resume=auto without anything"
expect_result auto
unfinished auto
rm auto/checkpoint.h5
start 1 auto --resume=auto
expect_end 0 "--resume=auto with the previous checkpoint"
grep -q 'going on from auto/checkpoint.previous.h5' output || fail "--resume=auto: not from the previous checkpoint"
expect_result auto
echo "ok --resume=auto"

unfinished other
expect_error 'unfinished work of another job; seed: then 1, now 4; pieces.uses: then 0, now 2; give what it was then' other \
  --resume --set seed=4 --set pieces.uses=2
cp -r drawings fewer
rm fewer/star.svg
"$tessera" library build fewer -o other.h5 >output 2>errors || fail "the other library"
expect_error 'library.file: another content' other --resume --set library.file=other.h5
echo '<svg xmlns="http://www.w3.org/2000/svg" width="240" height="180"><circle cx="90" cy="90" r="80"/></svg>' >mask.svg
expect_error 'canvas.file: another content' other --resume --set canvas.file=mask.svg
cp own.h5 moved.h5
start 1 other --resume --set library.file=moved.h5 --set output.width_px=100 --set checkpoint.every_s=9 \
  --set devices.use=cpu --set stop.seconds=900
expect_end 0 "what may differ"
expect_result other
echo "ok other jobs"

# change_byte FILE AT: changes one byte
change_byte() {
  local byte
  byte=$(od -An -tu1 -j "$2" -N 1 "$1")
  # shellcheck disable=SC2059
  printf "\\x$(printf %x $((byte ^ 16)))" | dd of="$1" bs=1 seek="$2" conv=notrunc status=none
}
unfinished damaged
change_byte damaged/checkpoint.h5 5000
expect_error 'damaged/checkpoint.h5: damaged' damaged --resume
grep -q -- 'checkpoint.previous.h5 is good: --resume=previous goes on from it; --restart' errors || fail "no way out"
truncate -s 3000 damaged/checkpoint.h5
expect_error 'damaged/checkpoint.h5: cut off: 3000 of' damaged --resume
echo "notes" >damaged/checkpoint.h5
expect_error 'damaged/checkpoint.h5: not a checkpoint' damaged --resume
cp own.h5 damaged/checkpoint.h5
expect_error 'damaged/checkpoint.h5: not a checkpoint' damaged --resume
cp kept/checkpoint.h5 damaged/checkpoint.h5
change_byte damaged/checkpoint.h5 27
expect_error 'damaged/checkpoint.h5: checkpoint format version' damaged --resume
start 1 damaged --resume=previous
expect_end 0 "from the previous checkpoint"
expect_result damaged
unfinished damaged
change_byte damaged/checkpoint.previous.h5 5000
expect_error 'damaged/checkpoint.previous.h5: damaged' damaged --resume=previous
grep -q -- 'damaged/checkpoint.h5 is good: --resume goes on from it; --restart' errors ||
  fail "no way back to the latest"
change_byte damaged/checkpoint.h5 5000
expect_error 'damaged/checkpoint.h5: damaged' damaged --resume
grep -q 'is good' errors && fail "offers a damaged checkpoint"
expect_error 'damaged/checkpoint.previous.h5: damaged' damaged --resume=previous
echo "ok damaged checkpoints"

# If no more checkpoints can be written, the run goes on and warns once.
start 1 blocked --set checkpoint.every_s=0.01
wait_for_checkpoint blocked
until mkdir -p blocked/checkpoint.h5.tmp/in_the_way 2>/dev/null; do :; done
expect_end 0 "without checkpoints"
cmp expected.geojson blocked/pieces.geojson || fail "without checkpoints: other pieces"
warning='warning: no checkpoint: cannot write blocked/checkpoint.h5: checkpoint.h5.tmp is in the way'
[[ $(grep -c "$warning" errors) == 1 ]] || fail "warning"
rm -r blocked
start 1 blocked --time-limit 4 --set improve.trials=0 --set improve.seconds=1000 --set checkpoint.every_s=1000
until grep -qs 'rank 0 of 1' blocked/run.log || ! kill -0 "$started" 2>/dev/null; do sleep 0.01; done
mkdir -p blocked/checkpoint.h5.tmp/in_the_way
expect_end 1 "unfinished without a checkpoint"
grep -q 'unfinished, and without a checkpoint' errors || fail "does not say that there is no checkpoint"
# An obstacle that is there from the start is found before the computation.
rm -r blocked
mkdir -p blocked/checkpoint.h5.tmp/in_the_way
start 1 blocked
expect_end 1 "blocked from the first"
grep -q 'cannot write blocked/checkpoint.h5: checkpoint.h5.tmp is in the way' errors || fail "blocked from the first"
echo "ok no checkpoint can be written"

# break_disk HOW REASON: the disk breaks after the first checkpoint, which is enough to go on with.
# The disk cannot be made read-only while the run holds its lock, so a read-only disk is mounted over it.
break_disk() {
  start 1 disk
  wait_for_checkpoint disk
  if [[ $1 == full ]]; then cat /dev/zero >disk/filler 2>/dev/null; else mount -t tmpfs -o ro none disk; fi
  expect_end 1 "$1 disk"
  [[ $(grep -c "warning: no checkpoint: .*$2" errors) == 1 ]] || fail "$1 disk: not one warning"
  if [[ $1 == full ]]; then rm disk/filler; else umount disk; fi
  start 1 disk --resume
  expect_end 0 "after a $1 disk"
  cmp expected.geojson disk/pieces.geojson || fail "$1 disk: other pieces"
}
mkdir disk
if mount -t tmpfs -o size=2M none disk 2>/dev/null; then
  trap 'umount disk' EXIT
  break_disk full 'No space left on device'
  break_disk read-only 'Read-only file system'
  echo "ok disks that fail"
else
  echo "skipped: disks that fail (needs mount)"
fi
