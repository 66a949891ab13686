#!/usr/bin/env bash
# scripts/concept-figures.sh [FOLDER]: draws the figures of the pipeline into FOLDER (docs/concepts), from Debian's drawings of animals.
# Build the program first (scripts/build.sh).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly tessera=${TESSERA:-build/release/src/cli/tessera}
readonly folder=${1:-docs/concepts}

if [[ $# -gt 1 || ${1-} == -* ]]; then
  echo "usage: scripts/concept-figures.sh [FOLDER]" >&2
  exit 2
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
clipart=$(dpkg -L openclipart-svg | grep -x '.*/svg/animals')
"$tessera" library build "$clipart" -o "$work/animals.h5"
"$tessera" bench concepts --library "$work/animals.h5" --shape dolphin --to "$folder"
