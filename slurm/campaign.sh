#!/usr/bin/env bash
# campaign.sh JOB.toml LIB.h5 OUT_DIR [tessera campaign's options...] [-- sbatch's options...]
# Submits an array with a task for each variation of the job, and a job that ranks the results when all tasks are over.
# Run it where sbatch is, from any folder; README.md says how the program is found. Prints the numbers of the two jobs.
#
#   slurm/campaign.sh jobs/animals.toml out/animals.h5 out/campaign --seeds 1-8
#   slurm/campaign.sh jobs/animals.toml out/animals.h5 out/campaign --seeds 1-4 --set objective.gap_weight=0.5,1,2 \
#     -- --ntasks=9 --gres=gpu:2
set -euo pipefail
slurm_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=slurm/program.sh
source "$slurm_folder/program.sh"

if [[ $# -lt 4 ]]; then
  sed -n '2,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
arguments=("$1" "$(realpath "$2")" "$3")
shift 3
options=()
while [[ $# -gt 0 && $1 != -- ]]; do options+=("$1"); shift; done
[[ $# -eq 0 ]] || shift

find_tessera || exit 1
list=$("$tessera" campaign "${arguments[0]}" --set "library.file=\"${arguments[1]}\"" --out "${arguments[2]}" \
  "${options[@]}" --list)
count=$(wc -l <<<"$list")
template=$slurm_folder/campaign.sbatch
array=$(sbatch --parsable --array="0-$((count - 1))" "$@" "$template" "${arguments[@]}" "${options[@]}")
# afterany: one failed collage must not stop the ranking of the others.
ranking=$(sbatch --parsable "$@" --dependency="afterany:${array%%;*}" --nodes=1 --ntasks=1 \
  --time=00:10:00 --output=tessera-campaign-%j-ranking.log "$template" "${arguments[@]}" "${options[@]}")
echo "collages: array $array, $count tasks; ranking: job $ranking, into ${arguments[2]}"
