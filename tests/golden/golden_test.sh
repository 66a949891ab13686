#!/usr/bin/env bash
# golden_test.sh TESSERA GOLDEN_INPUTS NEW_FOLDER [MPIRUN]: runs the jobs in jobs/ and compares the digests of their pieces.geojson with
# digests.txt. With MPIRUN it runs only seven jobs, on 3 ranks.
# golden_test.sh --renew TESSERA GOLDEN_INPUTS NEW_FOLDER: writes digests.txt instead. scripts/renew-golden.sh does this.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
renew=no
if [[ $1 == --renew ]]; then
  renew=yes
  shift
fi
tessera=$1 golden_inputs=$2 folder=$3 mpirun=${4-}
# shellcheck source=tests/support/ranks.sh
source "$here/../support/ranks.sh"
unset SLURM_JOB_END_TIME

rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
"$golden_inputs" .
cp "$here"/jobs/*.toml .

# line JOB: runs JOB and prints its line of digests.txt.
line() {
  local command=("$tessera" collage "$1.toml" --out "$1" --quiet)
  [[ -z $mpirun ]] || command=("${on_ranks[@]}" 3 "${command[@]}")
  "${command[@]}" >output 2>&1 || { cat output >&2; return 1; }
  local pieces digest
  pieces=$(grep -c '"type":"Feature",' "$1/pieces.geojson")
  digest=$(sha256sum <"$1/pieces.geojson")
  printf '%-16s %3d pieces  %s\n' "$1" "$pieces" "${digest%% *}"
}

jobs=()
for job in *.toml; do jobs+=("${job%.toml}"); done
[[ -z $mpirun ]] || jobs=(balanced colours fit_all many_places outward paper_improved seamless)
for job in "${jobs[@]}"; do
  echo "running $job"  # if a job hangs, the log names it
  line "$job" >>found.txt
done

if [[ $renew == yes ]]; then
  cp found.txt "$here/digests.txt"
  exit
fi
expected=$here/digests.txt
if [[ -n $mpirun ]]; then
  for job in "${jobs[@]}"; do grep "^$job " "$expected"; done >expected.txt
  expected=expected.txt
fi
if ! diff "$expected" found.txt; then
  cat >&2 <<'END'
FAILED: the jobs of tests/golden give other pieces than before (< before, > now).
If nobody meant to change the result, this is a fault. If the change was meant, fix the new digests with
  scripts/renew-golden.sh "why the result changed"
and commit tests/golden/digests.txt and tests/golden/renewals.md together with the change.
END
  exit 1
fi
