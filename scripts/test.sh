#!/usr/bin/env bash
# scripts/test.sh [--long] [--asan] [CTEST ARGUMENT...]: packages, build, all tests.
#   --long  the tests with the label "long" too
#   --asan  with the address and undefined-behaviour sanitizers, and without mpirun (Open MPI itself leaks)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=release
long=no
sections=(program tests)
while [[ ${1-} == --long || ${1-} == --asan ]]; do
  if [[ $1 == --long ]]; then long=yes sections+=(long-tests); else preset=asan-ubsan; fi
  shift
done

left_out=none  # a regular expression of labels
[[ $long == yes ]] || left_out+='|long'
[[ $preset == release ]] || left_out+='|mpi'

if [[ $EUID -eq 0 ]]; then  # Open MPI refuses root unless told twice; in a container there is often nobody else
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi

scripts/install-packages.sh "${sections[@]}"
scripts/build.sh --preset "$preset"
# Three at a time, of which a test with ranks counts as two: such a test has all cores busy or waits, for signals, time limits and
# Slurm, half of its time.
ctest --preset "$preset" -j 3 --no-tests=error --no-label-summary -LE "^($left_out)\$" "$@"
