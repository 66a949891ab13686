# shellcheck shell=bash disable=SC2154
# For the tests of checkpoints, which source it: a job with a library of its own in $folder, and how to run it.
# Needs: $tessera, $mpirun, $folder (new).
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

# Folder, drawings, library, job, and the pieces of a run without interruption: expected.geojson; it took $run_ms.
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

# start RANKS OUT OPTION...: in the background, as process $started; its first checkpoint is newer than the file "begun".
start() {
  local ranks=$1 out=$2
  shift 2
  touch begun
  local command=("$tessera" collage job.toml --out "$out" "$@")
  [[ $ranks == 1 ]] || command=("$mpirun" -q --oversubscribe --bind-to none -n "$ranks" "${command[@]}")
  "${command[@]}" >output 2>errors &
  started=$!
}

# Until $started has written a checkpoint, or has ended.
wait_for_checkpoint() { # OUT
  until [[ $1/checkpoint.h5 -nt begun ]] || ! kill -0 "$started" 2>/dev/null; do sleep 0.01; done
}

expect_end() { # CODE WHAT
  wait "$started"
  local code=$?
  [[ $code == "$1" ]] || fail "$2: exit code $code, not $1"
}

expect_result() { # OUT
  cmp expected.geojson "$1/pieces.geojson" || fail "$1: other pieces"
  [[ -z $(find "$1" -name 'checkpoint*') ]] || fail "$1: a finished run leaves checkpoints"
}
