# shellcheck shell=bash disable=SC2154
# Tests of checkpoints source this file: a job with its own library in $folder, and functions to run it.
# It needs $tessera and $folder (new), and $mpirun for tests on several ranks.
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

# Makes the folder, drawings, library and job. The pieces of a run without interruption are in expected.geojson; it took $run_ms.
make_job() {
  enter_folder
  cat >job.toml <<END
[library]
file = 'own.h5'
[canvas]
size_px = [240, 180]
[pieces]
scale_px = [14, 60]
[improve]
trials = $1
[output]
width_px = 240
[checkpoint]
every_s = 0.2
END
  run_ms=$(date +%s%3N)
  start 1 expected
  expect_end 0 "the run without interruption"
  run_ms=$(($(date +%s%3N) - run_ms))
  mv expected/pieces.geojson expected.geojson
}

# start RANKS OUT OPTION...: starts a run in the background, as process $started. Its first checkpoint is newer than the file "begun".
start() {
  local ranks=$1 out=$2
  shift 2
  touch begun
  local command=("$tessera" collage job.toml --out "$out" "$@")
  [[ $ranks == 1 ]] || command=("${on_ranks[@]}" "$ranks" "${command[@]}")
  "${command[@]}" >output 2>errors &
  started=$!
}

# Waits until $started has written a checkpoint or has ended.
wait_for_checkpoint() { # OUT
  until [[ $1/checkpoint.h5 -nt begun ]] || ! kill -0 "$started" 2>/dev/null; do sleep 0.01; done
}

# interrupt SIGNAL RANKS OUT OPTION...: ends a run soon after its start, with a checkpoint, and sets its exit $code.
interrupt() {
  start "${@:2}"
  wait_for_checkpoint "$3"
  kill -s "$1" "$started" 2>/dev/null
  wait "$started"
  code=$?
}

expect_end() { # CODE WHAT
  wait "$started"
  code=$?
  expect_code "$@"
}
expect_code() { # CODE WHAT
  [[ $code == "$1" ]] || fail "$2: exit code $code, not $1"
}

expect_result() { # OUT
  cmp expected.geojson "$1/pieces.geojson" || fail "$1: other pieces"
  [[ -z $(find "$1" -name 'checkpoint*') ]] || fail "$1: a finished run leaves checkpoints"
}
