#!/usr/bin/env bash
# gpu_share_test.sh GPU_SHARE.SH: the GPUs that each worker of a node sees, by the variables that sites set.
set -euo pipefail
gpu_share=$1
# shellcheck disable=SC2016  # the worker's shell expands it
seen='echo "${CUDA_VISIBLE_DEVICES-} ${ROCR_VISIBLE_DEVICES-} ${GPU_DEVICE_ORDINAL-}"'

# expect WORKER WORKERS SEEN VARIABLE=VALUE...
expect() {
  local worker=$1 workers=$2 expected=$3 found
  shift 3
  found=$(env -u CUDA_VISIBLE_DEVICES -u ROCR_VISIBLE_DEVICES -u GPU_DEVICE_ORDINAL -u TESSERA_MASTER_NODE \
    OMPI_COMM_WORLD_LOCAL_RANK="$worker" OMPI_COMM_WORLD_LOCAL_SIZE="$workers" "$@" "$gpu_share" bash -c "$seen")
  [[ $found == "$expected" ]] || { echo "worker $worker of $workers, $*: sees '$found', not '$expected'" >&2; exit 1; }
}

expect 0 2 "0,2  " CUDA_VISIBLE_DEVICES=0,1,2,3
expect 1 2 "1,3  " CUDA_VISIBLE_DEVICES=0,1,2,3
expect 2 3 "0  " CUDA_VISIBLE_DEVICES=0,1
expect 1 2 " 1 " ROCR_VISIBLE_DEVICES=0,1
expect 1 2 "  1" GPU_DEVICE_ORDINAL=0,1
expect 1 2 " 1 " ROCR_VISIBLE_DEVICES=0,1 GPU_DEVICE_ORDINAL=0,1  # the second variable counts among the GPUs that the first one leaves
expect 0 1 " 0,1 0,1" ROCR_VISIBLE_DEVICES=0,1 GPU_DEVICE_ORDINAL=0,1
expect 0 2 "  "
