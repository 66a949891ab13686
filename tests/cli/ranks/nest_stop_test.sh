#!/usr/bin/env bash
# nest_stop_test.sh TESSERA MPIRUN NEW_FOLDER SLOW_DISK: signals and limits stop tessera nest while it searches, writes and draws. The best
# layout so far is then there as a whole. SLOW_DISK: the library of slow_disk.cpp.
set -uo pipefail
tessera=$1
# shellcheck disable=SC2034 # support/ranks.sh
mpirun=$2
folder=$3
slow_disk=$4
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"
export ASAN_OPTIONS=${ASAN_OPTIONS:-}:verify_asan_link_order=0 # slow_disk comes first

# expect_whole FOLDER PIECES: expects all files of one layout, with a place for each piece, and nothing else
expect_whole() {
  python3 - "$1" "$2" <<'PYTHON' || fail "$1 does not hold a whole layout"
import json, os, re, sys
folder, pieces = sys.argv[1], int(sys.argv[2])
solution = json.load(open(folder + "/layout.json"))["solution"]
placed, sheets = solution["layout"]["placed_items"], solution["sheets"]
assert len(placed) == pieces, len(placed)
names = ["layout"] if sheets == 1 else ["layout_%d" % (i + 1) for i in range(sheets)]
want = {"layout.json", "card.txt"} | {n + end for n in names for end in (".svg", ".dxf")}
there = {n for n in os.listdir(folder) if not n.endswith(".png")}
assert there == want, there ^ want
assert sum(open(folder + "/" + n + ".svg").read().count("<path") for n in names) == pieces
PYTHON
}

# wait_for SECONDS COMMAND...: waits until COMMAND succeeds
wait_for() {
  local tries=$(($1 * 50))
  until "${@:2}" 2>/dev/null; do
    ((tries-- > 0)) || fail "waited too long for: ${*:2}"
    sleep 0.02
  done
}

new_folder
cat >parts.json <<'JSON'
{"name": "parts", "strip_height": 40, "items": [
  {"id": 0, "demand": 40, "allowed_orientations": [0, 180], "shape": {"type": "simple_polygon", "data": [[0,0],[20,0],[10,15],[0,0]]}},
  {"id": 1, "demand": 40, "allowed_orientations": [0, 90], "shape": {"type": "simple_polygon", "data": [[0,0],[12,0],[12,4],[4,4],[4,12],[0,12]]}}]}
JSON

# A signal is an interruption; the best layout so far is written all the same.
for ranks in 1 2; do
  launch=()
  [[ $ranks -eq 1 ]] || launch=("${on_ranks[@]}" "$ranks")
  "${launch[@]}" "$tessera" nest parts.json --effort best --out "out/stopped_$ranks" >output 2>errors &
  nesting=$!
  wait_for 60 test -e "out/stopped_$ranks/run.lock"
  sleep 1
  kill -0 $nesting 2>/dev/null || fail "it ended before it was interrupted"
  before=$(date +%s%N)
  kill -TERM $nesting
  wait $nesting
  code=$?
  took_ms=$((($(date +%s%N) - before) / 1000000))
  [[ $ranks -gt 1 || $code -eq 75 ]] || fail "exit code $code after SIGTERM"
  ((took_ms < 4000)) || fail "it took $took_ms ms to end on $ranks ranks"
  expect_word 'stopped by a signal: the best layout so far was written'
  grep -q '^ "stopped_by": "signal",$' "out/stopped_$ranks/layout.json" || fail "layout.json does not tell of the signal"
  grep -q '^  stopped         by a signal' "out/stopped_$ranks/card.txt" || fail "nor the card"
  expect_whole "out/stopped_$ranks" 80
done
echo "ok signals"

# A stopped rank does not block the others: the program names it, and writes the best layout so far.
# stop_rank CODE RANK OPTION...
stop_rank() {
  local stopped=$2 rank process
  rm -rf out/lost
  "${on_ranks[@]}" 3 "$tessera" nest parts.json --out out/lost "${@:3}" >output 2>errors &
  nesting=$!
  wait_for 60 test -e out/lost/run.lock
  # shellcheck disable=SC2013 # one line of words
  for rank in $(cat "/proc/$nesting/task/$nesting/children"); do
    tr '\0' '\n' <"/proc/$rank/environ" | grep -qx "OMPI_COMM_WORLD_RANK=$stopped" && process=$rank
  done
  kill -STOP "$process"
  SECONDS=0
  wait $nesting
  code=$?
  [[ $code -eq $1 ]] || fail "exit code $code, not $1, where rank $stopped was stopped"
  ((SECONDS <= 30)) || fail "a stopped rank: the search went on for $SECONDS s"
  expect_whole out/lost 80
}
stop_rank 75 1 --effort draft --silence-s 1 --quiet
grep -qE 'warning: rank 1 on .* has not been heard of for 1 s \(--silence-s\): the search ends here' errors ||
  fail "the stopped rank is not named"
expect_word 'stopped by a lost rank: the best layout so far was written'
grep -q '^ "stopped_by": "lost_rank",$' out/lost/layout.json || fail "layout.json does not tell of the lost rank"
grep -q '^  stopped         by a lost rank' out/lost/card.txt || fail "nor the card"
stop_rank 0 2 --effort draft --silence-s 1 --quiet # there are only two searches, and this rank has none
expect_silence "a rank without a search is missed"
! grep -q stopped_by out/lost/layout.json || fail "the search was whole"
echo "ok lost ranks"

# A limit that the user gave is no failure: the user asked for it.
run_on_ranks 2 0 nest parts.json --effort best --out out/limited --time-limit 7 --quiet
expect_whole out/limited 80
run '0 75' nest parts.json --effort best --sheet 45,40 --spacing 1 --out out/sheets --time-limit 3 --quiet
expect_whole out/sheets 80
SLURM_JOB_END_TIME=$(($(date +%s) + 4)) run 75 nest parts.json --effort best --out out/slurm
expect_word 'stopped by the time limit: the best layout so far was written'
expect_whole out/slurm 80
run 2 nest parts.json --time-limit soon --out out/none
expect_word 'soon'
[[ ! -e out/none ]] || fail "left something behind"
echo "ok limits"

python3 - "$tessera" <<'PYTHON' || fail "a terminal is not shown how far it is, and how long it will take"
import os, pty, re, select, sys, time
pid, terminal = pty.fork()
if pid == 0:
    os.execv(sys.argv[1], [sys.argv[1], "nest", "parts.json", "--effort", "best", "--out", "out/shown", "--time-limit", "5"])
said, gaps, last = b"", [], time.monotonic()
while True:
    try:
        block = os.read(terminal, 4096)
    except OSError:
        break
    if not block:
        break
    gaps.append(time.monotonic() - last)
    last = time.monotonic()
    said += block
os.waitpid(pid, 0)
assert re.search(rb"nesting .* \d+ %  [\d.]+ % dense, [\d.]+ mm long  0:0\d left", said), said[-300:]
assert b"stopped by the time limit: the best layout so far was written" in said, said[-300:]
assert max(gaps) < 3, gaps
PYTHON
grep -q '^ "stopped_by": "time_limit",$' out/shown/layout.json || fail "layout.json does not tell of the limit"
expect_whole out/shown 80
[[ -s out/shown/layout.png ]] || fail "no picture"
echo "ok progress"

# Two runs do not mix their files. A folder that cannot be written is found before the search.
"$tessera" nest parts.json --effort best --time-limit 30 --out out/locked >first_output 2>first_errors &
nesting=$!
wait_for 60 test -e out/locked/run.lock
run 2 nest parts.json --effort draft --out out/locked
expect_word 'out/locked: another run is at work here: process '
kill -TERM $nesting
wait $nesting
[[ $? -eq 75 ]] || fail "the first run did not go on: $(cat first_errors)"
expect_whole out/locked 80
most_s=20 run 1 nest parts.json --effort best --out /proc/none
touch file
most_s=20 run '1 2' nest parts.json --effort best --out file/below
mkdir -p stuck/layout.dxf
echo 'tessera nest: parts' >stuck/card.txt
most_s=20 run 1 nest parts.json --effort best --out stuck
expect_word 'cannot write stuck/layout.dxf: is a folder; remove it'
[[ $(ls stuck) == $'card.txt\nlayout.dxf' ]] || fail "left something behind"
mv stuck/layout.dxf stuck/layout.svg.tmp
touch stuck/layout.svg.tmp/file stuck/layout_7.dxf.tmp
most_s=20 run 1 nest parts.json --effort best --out stuck
expect_word 'cannot write stuck/layout.svg.tmp: is a folder; remove it'
rm -r stuck/layout.svg.tmp
run 0 nest parts.json --effort draft --out stuck --quiet
expect_whole stuck 80
echo "ok folder"

# Each sheet holds one plate, and the disk is slow: there are many files, and one wait for the disk covers many of them.
cat >plates.json <<'JSON'
{"items": [{"id": "plate", "demand": 2, "allowed_orientations": [0], "shape": {"type": "simple_polygon", "data": [[0,0],[20,0],[20,15],[0,15]]}}]}
JSON
plates() { # DEMAND: prints the words of the command
  echo "$tessera nest plates.json --sheet 21,16 --effort draft --out out/plates --quiet --demand plate=$1"
}
on_slow_disk() { # FLUSH_MS RENAME_MS COMMAND...
  SLOW_FLUSH_MS=$1 SLOW_RENAME_MS=$2 LD_PRELOAD=$slow_disk exec "${@:3}" >output 2>errors
}
# start_plates DEMAND FLUSH_MS RENAME_MS: starts in the background, and waits until the files have temporary names
start_plates() {
  # shellcheck disable=SC2046
  on_slow_disk "$2" "$3" $(plates "$1") &
  nesting=$!
  wait_for 60 test -e "out/plates/layout_$1.svg.tmp"
}
# end_plates CODE MOST_MS: waits until the run is over
end_plates() {
  local before code
  before=$(date +%s%N)
  wait $nesting 2>/dev/null
  code=$?
  [[ $code -eq $1 ]] || fail "exit code $code, not $1: $(cat errors)"
  ((($(date +%s%N) - before) / 1000000 < $2)) || fail "it took $((($(date +%s%N) - before) / 1000000)) ms to end"
}
sums() { (cd out/plates && sha256sum ./*); }
# shellcheck disable=SC2046
run_program 0 $(plates 2)
expect_whole out/plates 2
before=$(sums)

start_plates 40 400 0
kill -KILL $nesting
end_plates 137 4000
rm -f out/plates/run.lock out/plates/*.tmp
[[ $(sums) == "$before" ]] || fail "a run that was killed while it wrote has changed the layout that was there"

# A second signal ends the run without the layout, and leaves the earlier layout as it was.
start_plates 100 700 0
kill -TERM $nesting
sleep 1.3
kill -INT $nesting
end_plates 75 5000
expect_word 'unfinished, nothing was written, and an earlier layout is as it was'
[[ $(sums) == "$before" ]] || fail "a second signal leaves something behind"

# Signals that end an idle process at once, and several signals together, end the run when all files are there. With one wait for each file
# it would take 40 s.
for signal in HUP XCPU TERM; do
  start_plates 80 250 0
  kill -s $signal $nesting
  kill -s INT $nesting
  end_plates 75 8000
  expect_whole out/plates 80
done
! grep -q stopped_by out/plates/layout.json || fail "the search was not stopped"

# The time limit leaves time to write the files.
SECONDS=0
most_s=20 on_slow_disk 200 0 "$tessera" nest plates.json --sheet 21,16 --effort best --out out/slow --quiet --demand plate=120 \
  --time-limit 6 &
wait $!
code=$?
[[ $code -eq 0 || $code -eq 75 ]] || fail "exit code $code within a limit on a slow disk: $(cat errors)"
((SECONDS <= 7)) || fail "a limit of 6 s took $SECONDS s on a slow disk"
expect_whole out/slow 120

# Pictures appear a few at a time, and a signal ends drawing.
start_plates 40 1300 0
wait_for 60 test -e out/plates/layout_3.png # the layout is whole, and pictures are being drawn
kill -TERM $nesting
end_plates 75 4000
grep -q 'out/plates: drew 32 of 40 layout pictures (.png); all other files are there' errors ||
  fail "does not tell that pictures are missing: $(cat errors)"
expect_whole out/plates 40
[[ $(find out/plates -name '*.png' | wc -l) -eq 32 ]] || fail "not the pictures that were drawn"
# shellcheck disable=SC2046
run_program 0 $(plates 2)
expect_whole out/plates 2
[[ $(find out/plates -name '*.png' | wc -l) -eq 2 ]] || fail "pictures of the layout before"

# The disk is full at the last moment: only layout.json is longer than the limit.
before=$(sums)
# shellcheck disable=SC2046
(ulimit -f 20 && run_program 1 $(plates 150)) || exit 1
expect_word 'cannot write out/plates/layout.json: File too large'
[[ $(sums) == "$before" ]] || fail "a full disk has changed the layout that was there"

# The run is killed while the new layout replaces the old one. Then layout.json is missing, and the next run repairs it.
start_plates 40 0 20
wait_for 60 test -e out/plates/layout_20.svg
kill -KILL $nesting
end_plates 137 4000
[[ ! -e out/plates/layout.json ]] || fail "layout.json is there before all files are"
# shellcheck disable=SC2046
run_program 0 $(plates 2)
expect_whole out/plates 2
[[ ! -e out/plates/run.lock ]] || fail "left the lock of a killed run"
echo "ok writing"

run 3 nest parts.json --sheet 19,30 --effort draft --out out/incomplete --quiet
expect_word 'warning: 40 of 80 pieces found no place: 0'
expect_whole out/incomplete 40
echo "ok pieces without a place"
