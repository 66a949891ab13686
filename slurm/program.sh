# shellcheck shell=bash
# Where the program is, for campaign.sh and job.sh, which source it.
#
#   TESSERA       the program, where it is none of those below
#   TESSERA_ROOT  the folder that holds slurm/: the repository, or share/tessera of an installation

# Sets `tessera`: TESSERA, or the first that is there of: PATH, TESSERA_ROOT's, the one beside these files.
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
    tessera=$(realpath "$tessera")  # the other nodes' working directory and PATH may be others
    return
  done
  {
    echo "tessera: no such program; looked for (in this order): ${candidates[*]}"
    echo "The first is looked up in PATH. Put the program's folder into PATH, or set TESSERA to the program, or"
    echo "TESSERA_ROOT to the repository it was built in or to share/tessera of its installation."
  } >&2
  return 1
}
