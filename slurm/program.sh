# shellcheck shell=bash
# Finds the program. campaign.sh and job.sh source this file.
#
#   TESSERA       the program, if it is in none of the places below
#   TESSERA_ROOT  the folder that holds slurm/: the repository, or share/tessera of an installation

# Sets `tessera` to $TESSERA, or to the first that exists: in PATH, in TESSERA_ROOT, beside these files.
find_tessera() {
  local here candidate root candidates
  here=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
  candidates=("${TESSERA:-tessera}")
  if [[ -z ${TESSERA-} ]]; then
    for root in "${TESSERA_ROOT-}" "$here"; do
      [[ -z $root ]] || candidates+=("$root/build/release/src/cli/tessera" "$root/../../bin/tessera")
    done
  fi
  for candidate in "${candidates[@]}"; do
    tessera=$(command -v "$candidate") || continue
    tessera=$(realpath "$tessera")  # other nodes may have another working directory and PATH
    return
  done
  {
    echo "tessera: no such program; looked for (in this order): ${candidates[*]}"
    echo "The first is looked up in PATH. Put the program's folder into PATH, or set TESSERA to the program, or"
    echo "TESSERA_ROOT to the repository it was built in or to share/tessera of its installation."
  } >&2
  return 1
}
