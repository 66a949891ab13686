# shellcheck shell=bash disable=SC2154
# For the tests of checkpoints, which source it: a job with a library of its own in $folder, and how to run it.
# Needs: $tessera, $mpirun, $folder (new).
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
unset SLURM_JOB_END_TIME

fail() {
  echo "FAILED $*"
  cat output errors 2>/dev/null
  exit 1
}

draw() { # NAME PATH
  echo "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><path fill='teal' d='$2'/></svg>" \
    >"drawings/$1.svg"
}

# Folder, drawings, library, job, and the pieces of a run without interruption: expected.geojson; it took $run_ms.
make_job() {
  rm -rf "$folder"
  mkdir -p "$folder/drawings"
  cd "$folder" || exit 1
  draw bean "M10 50 C10 10 90 10 90 50 C90 90 70 60 50 60 C30 60 10 90 10 50Z"
  draw star "M50 5 L61 38 L95 38 L67 59 L78 93 L50 72 L22 93 L33 59 L5 38 L39 38Z"
  draw corner "M10 10 H90 V45 H45 V90 H10Z"
  draw leaf "M10 90 C10 30 50 10 90 10 C90 60 60 90 10 90Z"
  draw drop "M50 5 C60 40 85 50 85 70 A35 25 0 0 1 15 70 C15 50 40 40 50 5Z"
  "$tessera" library build drawings -o own.h5 >output 2>errors || fail "library"
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
