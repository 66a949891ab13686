#!/usr/bin/env bash
# scripts/test.sh [--long] [--asan] [CTEST ARGUMENT...]: installs packages, builds, and runs all tests.
#   --long  also runs the tests with the label "long"
#   --asan  uses the address and undefined-behaviour sanitizers, without mpirun (Open MPI itself leaks)
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

if [[ $EUID -eq 0 ]]; then  # Open MPI refuses root unless told twice; in a container there is often no other user
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi

scripts/install-packages.sh "${sections[@]}"
scripts/build.sh --preset "$preset"
# Three tests run at a time; a test with ranks counts as two. Such a test uses all cores half of its time, and otherwise waits for signals,
# time limits or Slurm.
ctest --preset "$preset" -j 3 --no-tests=error --no-label-summary -LE "^($left_out)\$" "$@"
