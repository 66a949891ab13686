# shellcheck shell=bash
# Functions for all templates, which source this file. It has no settings of a site.
#
#   TESSERA, TESSERA_ROOT  the place of the program (program.sh)
#   TESSERA_MAX_RESTARTS   how often a job may be restarted, node failures included (20)

: "${SLURM_JOB_ID:?is not set: sbatch starts these files, not the shell}"
slurm_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=slurm/program.sh
source "$slurm_folder/program.sh"
find_tessera || exit 1
restarts=${SLURM_RESTART_COUNT:-0}
most_restarts=${TESSERA_MAX_RESTARTS:-20}

# Node failures restart a job, too, without running this script's checks.
if ((restarts > most_restarts)); then
  echo "given up after $most_restarts restarts (TESSERA_MAX_RESTARTS)" >&2
  exit 1
fi

# The program needs the time at which the limit ends the job. Not every Slurm sets it (22.05 does not).
if [[ -z ${SLURM_JOB_END_TIME-} ]] && end=$(date -d "$(squeue -h -j "$SLURM_JOB_ID" -o %e)" +%s 2>/dev/null); then
  export SLURM_JOB_END_TIME=$end
fi

# The templates' --signal, and the minute by which Slurm may be early. Only the time before that is used for computing.
# Slurm does not tell a job whether sbatch was given another signal.
readonly signal_lead_s=180

warn_of_short_limit() {
  [[ ${SLURM_JOB_END_TIME-} =~ ^[0-9]+$ ]] || return 0
  local left_s=$((SLURM_JOB_END_TIME - $(date +%s)))
  ((left_s > 0 && left_s <= signal_lead_s)) || return 0
  echo "warning: the job ends in $left_s s, and Slurm's signal before the time limit may come $signal_lead_s s early" \
    "as the template sets it: little or nothing will be computed each time it is queued; give it more time (sbatch --time=00:30:00)" >&2
}

# The program would refuse these options beside --resume=auto, but cannot explain it, as it does not know the template.
refuse_other_starts() {  # options of tessera collage...
  local option
  for option in "$@"; do
    case $option in
      --restart | --restart=* | --resume | --resume=*)
        echo "$option: not in a template, which goes on from a checkpoint where there is one (--resume=auto) and comes back" \
          "by itself; to start again give another folder, or remove checkpoint.h5 and checkpoint.previous.h5 from it" >&2
        exit 2
        ;;
    esac
  done
}

# Exit codes of `tessera collage`:
readonly incomplete=3     # done, but required pieces are missing
readonly checkpointed=75  # it wrote a checkpoint and can continue

# Runs a command and passes on the signals that Slurm sends to the batch shell. Its exit code goes to `status`.
# USR2 comes before the time limit (--signal). TERM comes when the job is cancelled, preempted or requeued.
# mpirun uses TERM and USR1 itself and passes USR2 on to the ranks, so both signals become USR2. The program accepts it twice.
run_forwarding() {
  local again
  terminated=no
  "$@" &
  program=$!
  trap 'again=yes; kill -s USR2 "$program" 2>/dev/null || true' USR2
  trap 'again=yes; terminated=yes; kill -s USR2 "$program" 2>/dev/null || true' TERM
  again=yes
  while [[ $again == yes ]]; do  # a trapped signal ends `wait` before the program ends
    again=no
    status=0
    wait "$program" || status=$?
  done
  trap - USR2 TERM
}

# Makes one collage with all ranks of the job, from its checkpoint if there is one. A finished collage is left as it is.
# The function returns only when the collage is done.
run_collage() {  # RANKS JOB OUT_DIR [options of tessera collage...]
  local ranks=$1 job=$2 out=$3
  shift 3
  refuse_other_starts "$@"
  warn_of_short_limit
  TESSERA_MASTER_NODE=$(hostname)  # rank 0 runs on the same node as this script
  export TESSERA_MASTER_NODE
  # --map-by node: every node gets the same number of workers, as far as its tasks allow. --bind-to none: a rank's OpenCL device uses all
  # cores of the job.
  run_forwarding mpirun -n "$ranks" --map-by node --bind-to none -x TESSERA_MASTER_NODE \
    "$slurm_folder/gpu_share.sh" "$tessera" collage "$job" --out "$out" --resume=auto "$@"
  if [[ $status -eq $incomplete ]]; then
    echo "$out: done, but pieces are missing: the warnings above and card.txt name them (exit code $incomplete)"
  elif [[ $status -ne 0 ]]; then
    come_back_or_fail
  fi
}

# Queues the same job again after a checkpoint or the loss of a node, up to the allowed number of restarts. Any other end of the program is
# not worth repeating.
come_back_or_fail() {
  [[ $terminated == no ]] || exit "$status"  # the job is cancelled, or Slurm queues it again by itself
  if [[ $status -ne $checkpointed ]]; then
    if every_node_answers; then exit "$status"; fi
    echo "a node of the job does not answer" >&2
  fi
  if ((restarts >= most_restarts)); then
    echo "given up after $restarts restarts (TESSERA_MAX_RESTARTS)" >&2
    exit 1
  fi
  echo "queued again (restart $((restarts + 1)) of $most_restarts)"
  scontrol requeue "$SLURM_JOB_ID"
  exit 0
}

# mpirun ends the job as soon as a node is lost. Slurm notices minutes later, and would then call the job failed.
every_node_answers() {
  timeout 60 srun --overlap --quiet --ntasks="$SLURM_JOB_NUM_NODES" --ntasks-per-node=1 true 2>/dev/null
}
