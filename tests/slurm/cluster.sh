# shellcheck shell=bash
# A Slurm of four nodes on this machine. slurm_test.sh sources this file.
# Everything runs in name spaces (processes, mounts, network) whose first process is the test itself. So no process outlives the test,
# however it ends.
# It writes only into memory, its network is its own loopback, and a node is a process that can be killed with all its children.

readonly lab=/run/lab  # on a /run that only the test sees
# --kill-child: if the test itself is killed, the whole cluster ends.
readonly name_spaces=(--pid --fork --kill-child --mount-proc --mount --net --uts --ipc)

# Prints why there can be no cluster here, or nothing if there can be one.
reason_against_cluster() {
  [[ $EUID -eq 0 ]] || { echo "not root, which name spaces need"; return; }
  unshare "${name_spaces[@]}" true 2>/dev/null || echo "unshare ${name_spaces[*]} is not allowed here"
}

start_cluster() {  # SLURM_CONF; returns when all nodes are idle
  export SLURM_CONF=$1
  mount -t tmpfs tmpfs /run
  mkdir -p "$lab"/{log,state,tmp} "$lab/munge"
  ip link set lo up
  ip address add 10.0.0.1/32 dev lo  # with only 127.0.0.1 the C library resolves no IPv4 address at all
  hostname login
  export TMPDIR=$lab/tmp  # for Open MPI's sessions
  # Open MPI uses the loopback only if told to.
  export OMPI_MCA_oob_tcp_if_include=lo OMPI_MCA_btl_tcp_if_include=lo
  mknod "$lab/gpu0" c 1 3  # the GPUs are copies of /dev/null
  mknod "$lab/gpu1" c 1 3
  start_munge
  slurmctld -f "$SLURM_CONF" -i
  local node
  for node in n1 n2 n3 n4; do start_node "$node"; done
  wait_until 20 "all nodes idle" all_nodes_idle
}

start_munge() {
  chmod 711 "$lab/munge"
  head -c 1024 /dev/urandom >"$lab/munge/key"
  chmod 600 "$lab/munge/key"
  munged --origin=127.0.0.1 --socket="$lab/munge/socket" --key-file="$lab/munge/key" --log-file="$lab/munge/log" \
    --pid-file="$lab/munge/pid" --seed-file="$lab/munge/seed"
}

declare -A node_process  # for each node, the process whose end is the node's end

start_node() {  # NAME
  local name=$1
  mkdir -p "$lab/spool.$name" "$lab/tmp.$name"
  # Each node needs its own host name and /dev/shm, or Open MPI takes all nodes for one.
  # Slurm's daemon must not be process 1, which has no default signal actions.
  unshare --pid --fork --kill-child --mount-proc --mount --uts bash -c "
    hostname $name
    mount -t tmpfs tmpfs /dev/shm
    slurmd -D -f '$SLURM_CONF' -N $name &
    wait" </dev/null >>"$lab/log/console.$name" 2>&1 &
  node_process[$name]=$!
}

kill_node() {  # NAME: ends the node like a power failure
  kill -KILL "${node_process[$1]}"
  wait "${node_process[$1]}" 2>/dev/null || true
}

all_nodes_idle() { [[ $(sinfo -h -o '%D %t' 2>/dev/null) == "4 idle" ]]; }

# Waits for a condition. The test fails if it does not come in time.
wait_until() {  # SECONDS WHAT CONDITION...
  local limit_s=$1 what=$2 end=$((SECONDS + $1))
  shift 2
  until "$@"; do
    ((SECONDS < end)) || fail "not within $limit_s s: $what"
    sleep 0.1
  done
}

# job_state JOB: prints PENDING, RUNNING, COMPLETED, FAILED, ...
job_state() { job_field "$1" JobState; }
job_field() { scontrol show job "$1" 2>/dev/null | grep -oE "\b$2=[^ ]*" | head -n 1 | cut -d= -f2; }

# Waits for the job's end, which must be COMPLETED. Otherwise the job's log gives the reason.
expect_completed() {  # SECONDS JOB
  local limit_s=$1 job=$2
  wait_until "$limit_s" "the end of job $job" job_over "$job"
  [[ $(job_state "$job") == COMPLETED ]] || fail "job $job: $(job_state "$job")"
}
job_over() { [[ $(job_state "$1") =~ ^(COMPLETED|FAILED|CANCELLED|TIMEOUT|NODE_FAIL|BOOT_FAIL|DEADLINE)$ ]]; }
