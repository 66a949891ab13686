#!/usr/bin/env bash
# gpu_share.sh COMMAND...: runs the command as a rank that sees only its share of the node's GPUs.
# Slurm says which GPUs of the node the job has, but mpirun shows all of them to every rank.
# This script divides them among the node's workers by local rank; if there are more workers than GPUs, several share one.
# Rank 0, the master, needs none. Without such a variable (CPU devices), with one GPU or with one rank, nothing changes.
set -euo pipefail

worker=${OMPI_COMM_WORLD_LOCAL_RANK:-${SLURM_LOCALID:-0}}
workers=${OMPI_COMM_WORLD_LOCAL_SIZE:-${SLURM_TASKS_PER_NODE:-1}}
workers=${workers%%(*}  # Slurm writes "2(x4)"
if [[ $(hostname) == "${TESSERA_MASTER_NODE-}" ]]; then  # local rank 0 of this node is the master
  worker=$((worker - 1))
  workers=$((workers - 1))
fi

# share_of LIST: prints this worker's share of a list like "0,1,2,3".
share_of() {
  local all mine=() i
  IFS=, read -r -a all <<<"$1"
  if ((workers >= ${#all[@]})); then
    mine=("${all[worker % ${#all[@]}]}")
  else
    for ((i = worker; i < ${#all[@]}; i += workers)); do mine+=("${all[i]}"); done
  fi
  (IFS=,; echo "${mine[*]}")
}

if ((worker >= 0 && workers > 1)); then
  # AMD's runtime counts GPU_DEVICE_ORDINAL among the GPUs that ROCR_VISIBLE_DEVICES leaves. If both were narrowed, none would remain.
  [[ -z ${ROCR_VISIBLE_DEVICES:-} ]] || unset GPU_DEVICE_ORDINAL
  for name in CUDA_VISIBLE_DEVICES ROCR_VISIBLE_DEVICES GPU_DEVICE_ORDINAL; do
    [[ -z ${!name:-} ]] || export "$name=$(share_of "${!name}")"
  done
fi

exec "$@"
