#!/usr/bin/env bash
# mpi_job_test.sh MPIRUN MPI_JOB: checks how a job of three ranks ends under mpirun.
# It checks the exit code, the one error line of one rank, and the written file after mpirun was told to stop.
set -uo pipefail
mpirun=$1
job=$2
# shellcheck source=tests/support/ranks.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/ranks.sh"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "FAILED $*"
  cat "$folder/errors"
  exit 1
}

start() { timeout 60 "${on_ranks[@]}" 3 "$job" "$1" "$folder/$1" 2>"$folder/errors"; }

# expect HOW CODE LINE: the job ends with this exit code. Its errors are one line that matches LINE, or none.
expect() {
  start "$1"
  local code=$?
  without_launcher_warnings "$folder/errors"
  [[ $code == "$2" ]] || fail "$1: exit code $code, not $2"
  if [[ -z $3 ]]; then
    [[ ! -s $folder/errors ]] || fail "$1: errors"
  else
    [[ $(wc -l <"$folder/errors") == 1 ]] || fail "$1: not one line"
    grep -qE "^error: $3\$" "$folder/errors" || fail "$1: another line"
  fi
  echo "ok $1"
}

expect 'done' 0 ''
expect rank_0_input_error 2 'job.toml:3: bad key'
expect rank_0_environment_error 1 'disk full'
expect worker_input_error 2 'rank 1 on .*: library.h5 is damaged'
expect worker_bug 1 'rank 1 on .*: internal error: oops'

expect late_message 2 'nothing to do'

start worker_dies
[[ $? == 137 ]] || fail "worker_dies: exit code"
echo "ok worker_dies"

# One rank does not come to a point where MPI waits for it. The test tries each rank; the file that rank 0 wrote before is there.
hangs() { # HOW CODE LINE WITHIN_S
  SECONDS=0
  expect "$1" "$2" "$3"
  ((SECONDS <= $4)) || fail "$1: took $SECONDS s"
}
hangs stopped_starting_1 1 'rank 0 has waited 2 s for the other ranks to start MPI: .*' 8
[[ ! -e $folder/stopped_starting_1 ]] || fail "it ran without rank 1"
hangs stopped_starting_0 1 'rank 1 has waited 7 s for the other ranks to start MPI: .*' 13
# mpirun reports a failure if rank 0 leaves without the other ranks.
hangs stopped_ending_1 1 "rank 0 has waited 2 s for the other ranks to end MPI: .*; the run's files are written" 8
[[ -s $folder/stopped_ending_1 ]] || fail "nothing was written before the end"

"${on_ranks[@]}" 3 "$job" interrupted "$folder/interrupted" >"$folder/output" 2>"$folder/errors" &
started=$!
for ((i = 0; i < 200; ++i)); do
  grep -qs running "$folder/output" && break
  sleep 0.05
done
kill -TERM $started # mpirun does the same on Ctrl-C, but a background process does not get that signal
SECONDS=0
wait $started
[[ -s $folder/interrupted ]] || fail "interrupted: rank 0 could not write"
((SECONDS <= 3)) || fail "interrupted: took $SECONDS s"
echo "ok interrupted"
