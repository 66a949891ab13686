#!/usr/bin/env bash
# From a fresh Debian 12 machine to a collage: packages, build, a library of clip art, one master and two workers.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/collage.sh
source scripts/collage.sh

readonly tessera=build/release/src/cli/tessera
readonly library=out/animals.h5
readonly result=out/animals

if [[ $# -gt 0 ]]; then
  echo "usage: scripts/demo.sh" >&2
  exit 2
fi
if [[ $EUID -eq 0 ]]; then  # Open MPI refuses root unless told twice; in a container there is often no other user
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi

scripts/install-packages.sh program
scripts/build.sh --without-tests tessera

mkdir -p out
if [[ ! $library -nt $tessera ]]; then
  clipart=$(dpkg -L openclipart-svg | grep -x '.*/svg/animals')
  echo "Building the library $library from $clipart"
  "$tessera" library build "$clipart" -o "$library"
fi

echo "Computing the collage: one master and two workers"
# --oversubscribe: there are three ranks on two cores. --bind-to none: a rank's OpenCL device uses all cores.
make_collage mpirun --oversubscribe --bind-to none -n 3 "$tessera" collage jobs/animals.toml --out "$result" --restart

echo
echo "The picture: $PWD/$result/collage.png (collage.svg, pieces.geojson, card.json and job.toml beside it)"
