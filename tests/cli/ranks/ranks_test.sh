#!/usr/bin/env bash
# ranks_test.sh TESSERA MPIRUN NEW_FOLDER: ranks that disagree, ranks that hang, launchers that start several masters, and two runs in one
# folder.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/restart_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../restart_fixture.sh"

make_job 50

expect_error_line() { # TEXT WHAT
  grep -qE -- "$1" errors || fail "$2: another error than: $1"
}

# The ranks read different files under one name, each in its own working directory.
mkdir -p theirs mine
cp own.h5 theirs/lib.h5
cp -r drawings others
draw_svg others/leaf "M10 90 C10 30 50 10 90 10 C90 75 50 90 10 90Z"
"$tessera" library build others -o mine/lib.h5 >output 2>errors || fail "the other library"
# other_library MASTERS_FOLDER WORKERS_FOLDER: the worker on rank 2 reads another library of the same size
other_library() {
  local command=("$tessera" collage "$folder/job.toml" --set library.file=/proc/self/cwd/lib.h5 --out "$folder/other")
  command+=(--quiet)
  "${on_ranks[@]}" 2 --wdir "$folder/$1" "${command[@]}" : -n 1 --wdir "$folder/$2" "${command[@]}" >output 2>errors &
  started=$!
}
other_library theirs mine
expect_end 2 "another library on a worker"
expect_error_line "tessera: rank 2 on .*lib.h5: not the master's library of the same name" "another library on a worker"
[[ ! -e other/pieces.geojson ]] || fail "another library: pieces all the same"
other_library mine theirs
expect_end 2 "another library on the master"
expect_error_line "tessera: rank 2 on .*lib.h5: not the master's library of the same name" "another library on the master"
other_library theirs theirs
expect_end 0 "the same library in two places"
cmp expected.geojson other/pieces.geojson || fail "the same library in two places: other pieces"
echo "ok other libraries"

# stop_worker OUT OPTION...: stops rank 2 (SIGSTOP) after the first checkpoint.
stop_worker() {
  local out=$1 rank
  start 3 "$@" --set checkpoint.every_s=0.05
  wait_for_checkpoint "$out"
  for rank in $(cat "/proc/$started/task/$started/children"); do
    tr '\0' '\n' <"/proc/$rank/environ" | grep -qx OMPI_COMM_WORLD_RANK=2 && kill -STOP "$rank"
  done
  SECONDS=0
}
stop_worker silent --set comm.silence_s=1
expect_end 75 "a stopped worker"
((SECONDS <= 12)) || fail "a stopped worker: the run went on for $SECONDS s"
expect_error_line 'rank 2 on .* has not been heard of for 1 s' "a stopped worker"
grep -q 'stopped by *lost_rank' silent/card.txt || fail "a stopped worker: another end"
start 1 silent --resume
expect_end 0 "after a stopped worker"
expect_result silent
echo "ok a stopped worker"

stop_worker limited --time-limit 7
expect_end 75 "a stopped worker and a time limit"
((SECONDS <= 8)) || fail "a stopped worker and a time limit: $SECONDS s"
grep -q 'stopped by *time_limit' limited/card.txt || fail "a stopped worker and a time limit: another end"
start 1 limited --resume
expect_end 0 "after the time limit"
expect_result limited
echo "ok a stopped worker and a time limit"

# Two runs in one folder.
start 1 shared --set checkpoint.every_s=0.05
first=$started
wait_for_checkpoint shared
kill -STOP "$first"
for again in --resume --restart --quiet; do
  start 1 shared $again
  expect_end 2 "a second run ($again)"
  expect_error_line "shared: another run is at work here: process $first on $(hostname)" "a second run"
done
kill -KILL "$first"
wait "$first" 2>/dev/null
[[ -e shared/run.lock ]] || fail "no lock was left by a killed run"
start 1 shared --resume
expect_end 0 "after a killed run"
expect_result shared
[[ ! -e shared/run.lock ]] || fail "the lock is left"
printf 'host elsewhere\npid 7\nboot another\nslurm_job 12\nslurm_restart 0\n' >shared/run.lock
start 1 shared
expect_end 2 "a run elsewhere"
expect_error_line 'process 7 on elsewhere, Slurm job 12.* remove shared/run.lock' "a run elsewhere"
SLURM_JOB_ID=12 start 1 shared
expect_end 2 "the same Slurm job, not queued again"
SLURM_JOB_ID=12 SLURM_RESTART_COUNT=1 start 1 shared
expect_end 0 "the same Slurm job, queued again"
expect_result shared
echo "ok two runs in one folder"

# Three processes that cannot find each other.
for launcher in PMI_SIZE=3,PMI_RANK=0 SLURM_STEP_NUM_TASKS=3,SLURM_PROCID=0,SLURM_NTASKS=3; do
  rm -rf alone
  # shellcheck disable=SC2086
  env ${launcher//,/ } "$tessera" collage job.toml --out alone >output 2>errors
  [[ $? == 2 ]] || fail "$launcher: not refused"
  expect_error_line 'mpirun -n 3 tessera' "$launcher"
  [[ ! -e alone ]] || fail "$launcher: something was written"
done
SLURM_JOB_ID=3 SLURM_NTASKS=3 SLURM_PROCID=0 start 1 alone
expect_end 0 "one process in a batch script of three tasks"
echo "ok launchers"

# The output of rank 0 is lost. Another rank never starts: the time limit also holds for MPI, but for at least 10 s.
"${on_ranks[@]}" 2 bash -c "exec '$tessera' library info own.h5 >/dev/full" >output 2>errors
[[ $? == 1 ]] || fail "lost output of rank 0: another exit code"
expect_error_line '^tessera: standard output cannot be written: No space left on device' "lost output of rank 0"
SECONDS=0
"${on_ranks[@]}" 2 bash -c "((OMPI_COMM_WORLD_RANK == 1)) && exec sleep 60
  exec '$tessera' collage job.toml --out none --time-limit 4" >output 2>errors
[[ $? == 1 ]] || fail "a rank that never starts: another exit code"
((SECONDS >= 10 && SECONDS <= 20)) || fail "a rank that never starts: took $SECONDS s"
expect_error_line '^tessera: rank 0 has waited 10 s for the other ranks to start MPI' "a rank that never starts"
[[ ! -e none ]] || fail "a rank that never starts: something was written"
echo "ok lost output and lost ranks"
