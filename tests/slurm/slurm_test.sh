#!/usr/bin/env bash
# slurm_test.sh TESSERA NEW_FOLDER: the templates of slurm/ on a Slurm of four nodes (cluster.sh). Exit code 77: there
# can be no cluster here.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source-path=SCRIPTDIR source=cluster.sh
source "$here/cluster.sh"

if [[ ${1-} != --inside ]]; then
  reason=$(reason_against_cluster)
  if [[ -n $reason ]]; then
    echo "skipped: $reason"
    exit 77
  fi
  exec unshare "${name_spaces[@]}" "$here/slurm_test.sh" --inside "$@"
fi
trap 'exit 130' INT TERM  # the first process of a name space has no default actions
program=$(realpath "$2")
folder=$3

export TESSERA=$program
TESSERA_ROOT=$(realpath "$here/../..")
export TESSERA_ROOT
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

fail() {
  echo "FAILED $*"
  squeue -o '%.6i %.9T %.10M %R' || true
  tail -n 20 "$lab"/log/slurmctld ./*.log || true
  exit 1
}

ok() { echo "ok $1 (${SECONDS} s)"; }

# submit TEMPLATE [sbatch's options... --] ARGUMENT...: prints the job's number
submit() {
  local template=$TESSERA_ROOT/slurm/$1 options=()
  shift
  while [[ $1 == -* ]]; do options+=("$1"); shift; done
  sbatch --parsable "${options[@]}" "$template" "$@"
}

draw() {  # NAME PATH
  echo "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><path fill='teal' d='$2'/></svg>" \
    >"drawings/$1.svg"
}

make_inputs() {
  mkdir drawings
  draw bean "M10 50 C10 10 90 10 90 50 C90 90 70 60 50 60 C30 60 10 90 10 50Z"
  draw star "M50 5 L61 38 L95 38 L67 59 L78 93 L50 72 L22 93 L33 59 L5 38 L39 38Z"
  draw corner "M10 10 H90 V45 H45 V90 H10Z"
  draw leaf "M10 90 C10 30 50 10 90 10 C90 60 60 90 10 90Z"
  draw drop "M50 5 C60 40 85 50 85 70 A35 25 0 0 1 15 70 C15 50 40 40 50 5Z"
  cat >small.toml <<'END'
[library]
file = "own.h5"
[canvas]
size_px = [160, 120]
[pieces]
scale_px = [14, 60]
[output]
width_px = 160
END
}

expect_same_pieces() {  # FOLDER FOLDER
  cmp "$1/pieces.geojson" "$2/pieces.geojson" || fail "$2/pieces.geojson differs from $1's"
}

check_collage() {
  "$program" collage small.toml --out alone --quiet
  local job
  job=$(submit collage.sbatch --nodes=4 --ntasks=5 --ntasks-per-node=2 small.toml own.h5 four_nodes)
  expect_completed 60 "$job"
  expect_same_pieces alone four_nodes
  ok "collage on four nodes: the bytes of one process"
}

rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
start_cluster "$here/slurm.conf"
ok "cluster"
make_inputs
"$program" library build drawings -o own.h5 >library.log 2>&1
check_collage
