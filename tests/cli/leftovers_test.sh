#!/usr/bin/env bash
# leftovers_test.sh TESSERA NEW_FOLDER KILLS: kills each command KILLS times at random moments, then lets it finish. The files are then
# exactly those of an undisturbed run.
set -uo pipefail
tessera=$1
folder=$2
kills=$3
RANDOM=${4:-$$}
echo "seed ${4:-$$}"
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

files_of() { (cd "$1" && find . | sort); }

# try COMMAND...: the command writes into the folder "made".
try() {
  local begun_ms run_ms pause_ms started
  rm -rf made && mkdir made
  begun_ms=$(date +%s%3N)
  run 0 "$@"
  run_ms=$(($(date +%s%3N) - begun_ms))
  files_of made >files.undisturbed
  rm -rf made && mkdir made
  for ((i = 0; i < kills; ++i)); do
    "$tessera" "$@" >output 2>errors &
    started=$!
    pause_ms=$((RANDOM % run_ms))
    sleep "$((pause_ms / 1000)).$(printf %03d $((pause_ms % 1000)))"
    kill -KILL "$started" 2>/dev/null
    wait "$started" 2>/dev/null
  done
  run 0 "$@"
  files_of made | diff files.undisturbed - || fail "other files after $kills kills: $*"
  echo "ok $*"
}

enter_folder
printf 'no picture' >spoiled.png
write_job '120, 90' '14, 40' 1200
try library build drawings spoiled.png --embed -o made/own.h5
try campaign job.toml --seeds 1 --out made --set checkpoint.every_s=0.001
run 0 collage job.toml --out result --quiet
try draw result --png --svg --pdf --tiff --to made --quiet
