#!/usr/bin/env bash
# slurm_test.sh TESSERA NEW_FOLDER: the templates of slurm/ on a Slurm of four nodes (cluster.sh). Exit code 77 means that no cluster can
# run here.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source-path=SCRIPTDIR source=cluster.sh
source "$here/cluster.sh"
# shellcheck source=tests/support/drawings.sh
source "$here/../support/drawings.sh"

if [[ ${1-} != --inside ]]; then
  reason=$(reason_against_cluster)
  if [[ -n $reason ]]; then
    echo "skipped: $reason"
    exit 77
  fi
  exec unshare "${name_spaces[@]}" "$here/slurm_test.sh" --inside "$@"
fi
trap 'exit 130' INT TERM  # the first process of a name space has no default actions
program=$(realpath "$2")
folder=$3

export TESSERA=$program
templates=$(realpath "$here/../../slurm")
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

fail() {
  {
    echo "FAILED $*"
    squeue -o '%.6i %.9T %.10M %R' || true
    tail -n 20 "$lab"/log/slurmctld ./*.log || true
  } >&2
  exit 1
}

ok() { echo "ok $1 (${SECONDS} s)"; }

# submit TEMPLATE [sbatch's options... --] ARGUMENT...: prints the job's number
submit() {
  local template=$templates/$1 options=()
  shift
  while [[ $1 == -* ]]; do options+=("$1"); shift; done
  sbatch --parsable "${options[@]}" "$template" "$@" || fail "sbatch of $template"
}

make_inputs() {
  make_drawings drawings
  cat >small.toml <<'END'
quality = "draft"
[library]
file = "own.h5"
[canvas]
size_px = [160, 120]
[pieces]
scale_px = [14, 60]
[output]
width_px = 160
END
  sed 's/^\[output\]/[improve]\ntrials = 300\n&/' small.toml >long.toml  # takes about 10 s
  sed 's/trials = 300/trials = 930/' long.toml >longer.toml
}

expect_same_pieces() {  # FOLDER FOLDER
  cmp "$1/pieces.geojson" "$2/pieces.geojson" || fail "$2/pieces.geojson differs from $1's"
}

check_prepare() {
  local job
  job=$(submit prepare.sbatch --cpus-per-task=2 drawings own.h5)
  expect_completed 30 "$job"
  "$program" library info own.h5 | grep -q '^shapes *5$' || fail "the library has not 5 shapes"
  ok "prepare: a library from a folder"
}

check_collage() {
  cat >where.sh <<END
#!/bin/bash
hostname >>where.txt
exec "$program" "\$@"
END
  chmod +x where.sh
  local job
  "$program" collage small.toml --out alone --quiet
  job=$(TESSERA=$PWD/where.sh submit collage.sbatch --nodes=4 --ntasks=5 --ntasks-per-node=2 \
        small.toml own.h5 four_nodes)
  expect_completed 60 "$job"
  expect_same_pieces alone four_nodes
  [[ $(sort where.txt | uniq -c | xargs) == "2 n1 1 n2 1 n3 1 n4" ]] || fail "ranks on nodes: $(sort where.txt | xargs)"
  ok "collage on four nodes: the bytes of one process"
}

# Two pieces of a shape must be farther apart than the canvas is wide. With exit code 3 the job completes and says so.
check_incomplete_collage() {
  local job
  job=$(submit collage.sbatch --ntasks=2 small.toml own.h5 incomplete --set 'pieces.uses=[2, 2]' \
        --set pieces.apart_px=900)
  expect_completed 60 "$job"
  grep -q '^incomplete: done, but pieces are missing: .* (exit code 3)$' "tessera-$job.log" ||
    fail "incomplete collage: the log does not say so"
  grep -q '5 pieces are missing: ' "tessera-$job.log" || fail "incomplete collage: the log does not name them"
  ok "an incomplete collage is done, and says so"
}

# Submits from an unrelated folder, with the program only in PATH; and without the program.
check_another_folder() {
  local job
  mkdir -p elsewhere path
  ln -sf "$program" path/tessera
  job=$(cd elsewhere && unset TESSERA && PATH=$PWD/../path:$PATH \
        submit collage.sbatch --ntasks=2 ../small.toml ../own.h5 result)
  expect_completed 60 "$job"
  expect_same_pieces alone elsewhere/result
  job=$(cd elsewhere && TESSERA=/none/tessera submit collage.sbatch --ntasks=2 ../small.toml ../own.h5 without)
  wait_until 30 "the end of job $job" job_over "$job"
  [[ $(job_state "$job") == FAILED ]] || fail "without a program: $(job_state "$job")"
  grep -q '/none/tessera.*' "elsewhere/tessera-$job.log" || fail "without a program: the log does not name it"
  grep -q 'TESSERA_ROOT' "elsewhere/tessera-$job.log" || fail "without a program: no word of TESSERA_ROOT in the log"
  ok "submitted from another folder; no program: said with the cure"
}

# The GPUs of each node are divided among its workers. The program sees its share through the drivers' own variable.
check_gpu_shares() {
  cat >show_gpus.sh <<'END'
#!/bin/bash
echo "$(hostname) rank $OMPI_COMM_WORLD_RANK gpus $CUDA_VISIBLE_DEVICES" >>gpus.txt
END
  chmod +x show_gpus.sh
  local job
  job=$(TESSERA=$PWD/show_gpus.sh submit collage.sbatch --nodes=2 --ntasks=5 --ntasks-per-node=3 --gres=gpu:2 \
        small.toml own.h5 gpus)
  expect_completed 30 "$job"
  # The first node has three ranks: the master and two workers with a GPU each. The second has two workers.
  # Slurm chooses the nodes by load, so the test numbers them in the order of the output.
  printf '%s\n' '1 rank 0 gpus 0,1' '1 rank 2 gpus 0' '1 rank 4 gpus 1' '2 rank 1 gpus 0' '2 rank 3 gpus 1' |
    diff - <(sort gpus.txt | awk '!($1 in node) { node[$1] = ++nodes } { $1 = node[$1]; print }') || fail "GPU shares"
  ok "GPUs: a share for each worker of a node"
}

check_campaign() {
  local printed
  printed=$("$templates/campaign.sh" small.toml own.h5 campaign --seeds 1-3 --weight variety=0.2 -- --ntasks=2)
  [[ $printed =~ array\ ([0-9]+),\ 3\ tasks.*job\ ([0-9]+) ]] || fail "campaign.sh printed: $printed"
  local ranking=${BASH_REMATCH[2]}
  expect_completed 60 "$ranking"
  [[ $(wc -l <campaign/ranking.csv) == 4 ]] || fail "campaign: not three results in ranking.csv"
  [[ -s campaign/ranking.png ]] || fail "campaign: no ranking.png"
  expect_same_pieces alone campaign/seed_1
  cp campaign/ranking.csv array.csv
  # The same campaign in one process: all results are there, and the ranking is the same.
  "$program" campaign small.toml --set 'library.file=own.h5' --seeds 1-3 --weight variety=0.2 --out campaign \
    >campaign.log
  [[ $(grep -c 'finished before' campaign.log) == 3 ]] || fail "campaign: results of the array were made again"
  cmp array.csv campaign/ranking.csv || fail "campaign: another ranking"
  ok "campaign: an array, then the ranking"
}

check_scaling() {
  local job
  job=$(submit scaling.sbatch --array=2,3 --ntasks=3 small.toml own.h5 scaling)
  wait_until 60 "the end of job $job" array_over "$job"
  [[ $(wc -l <scaling/scaling.csv) == 3 ]] || fail "scaling: not two lines: $(cat scaling/scaling.csv)"
  grep -qE '^2,([0-9.]+,){6}[0-9a-f]{32}$' scaling/scaling.csv || fail "scaling: $(cat scaling/scaling.csv)"
  expect_same_pieces alone scaling/ranks_2
  expect_same_pieces alone scaling/ranks_3
  ok "scaling: an array over numbers of ranks"
}
array_over() { [[ -z $(squeue -h -j "$1" 2>/dev/null) ]]; }

# The templates' promises about restarts, with programs that replace tessera. Ranks other than 0 do nothing.
stand_in() {  # NAME, what rank 0 does on standard input; $out is its folder
  {
    cat <<'END'
#!/bin/bash
[[ $OMPI_COMM_WORLD_RANK == 0 ]] || exit 0
resume=no
automatic=no
[[ " $* " != *" --resume=auto "* ]] || automatic=yes
while [[ $1 != --out ]]; do shift; done
out=$2
[[ $automatic == no || ! -e $out/checkpoint.h5 ]] || resume=yes
mkdir -p "$out"
echo "resume=$resume" >>"$out/runs.txt"
END
    cat
  } >"$1"
  chmod +x "$1"
}

# The program never gets further than a checkpoint.
start_endless_job() {
  stand_in endless.sh <<'END'
touch "$out/checkpoint.h5"
exit 75
END
  endless_job=$(TESSERA=$PWD/endless.sh TESSERA_MAX_RESTARTS=2 \
                submit collage.sbatch --ntasks=2 small.toml own.h5 endless)
}

check_endless_job() {
  wait_until 60 "the end of job $endless_job" job_over "$endless_job"
  [[ $(job_state "$endless_job") == FAILED ]] || fail "endless job: $(job_state "$endless_job")"
  printf 'resume=%s\n' no yes yes | diff - endless/runs.txt || fail "endless job: other runs than allowed"
  grep -q 'given up after 2 restarts' "tessera-$endless_job.log" || fail "endless job: no word of it in the log"
  ok "restarts: two allowed, two made"
}

# Slurm sends the signal before the time limit up to a minute early. Here it comes some time in the first ten seconds.
start_job_beyond_its_limit() {
  beyond_job=$(TESSERA_MAX_RESTARTS=20 submit collage.sbatch --nodes=2 --nodelist=n3,n4 --ntasks=3 --ntasks-per-node=2 \
               --time=1 --signal=B:USR2@50 longer.toml own.h5 beyond)
}

check_job_beyond_its_limit() {
  expect_completed 150 "$beyond_job"
  [[ $(job_field "$beyond_job" Restarts) -ge 1 ]] || fail "time limit: not one restart"
  grep -q "going on from beyond/checkpoint.h5" "tessera-$beyond_job.log" || fail "time limit: not from the checkpoint"
  expect_same_pieces longer_alone beyond
  ok "time limit: signal, checkpoint, $(job_field "$beyond_job" Restarts) restarts, the same bytes"
}

# A node is lost with all its processes. The job restarts on other nodes, from its checkpoint if there is one.
start_job_that_loses_a_node() {
  widow_job=$(submit collage.sbatch --nodes=2 --ntasks=3 --ntasks-per-node=2 long.toml own.h5 widow)
  wait_until 30 "the start of job $widow_job" [ -d widow ]
  sleep 2
  [[ $(job_field "$widow_job" NodeList) == "n[1-2]" ]] || fail "lost node: not on the nodes that were free"
  kill_node n2
}

check_job_that_lost_a_node() {
  expect_completed 100 "$widow_job"
  [[ $(job_field "$widow_job" Restarts) == 1 ]] || fail "lost node: not one restart"
  expect_same_pieces long_alone widow
  ok "a node is lost: restart on others, the same bytes"
}

# The signal is the one before the time limit. The job avoids n2, which was killed, as Slurm may not know that yet.
check_interrupted_collage() {
  local job
  job=$(submit collage.sbatch --exclude=n2 --nodes=2 --ntasks=3 --ntasks-per-node=2 long.toml own.h5 interrupted)
  wait_until 30 "the start of job $job" [ -d interrupted ]
  sleep 2
  scancel --batch --signal=USR2 "$job"
  wait_until 30 "a checkpoint" [ -s interrupted/checkpoint.h5 ]
  expect_completed 100 "$job"
  [[ $(job_field "$job" Restarts) == 1 ]] || fail "interrupted: not one restart"
  [[ ! -e interrupted/checkpoint.h5 ]] || fail "interrupted: the checkpoint is still there"
  grep -q "going on from interrupted/checkpoint.h5" "tessera-$job.log" || fail "interrupted: not from the checkpoint"
  expect_same_pieces long_alone interrupted
  ok "interrupted collage: checkpoint, restart, the same bytes"
}

rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
start_cluster "$here/slurm.conf"
ok "cluster"
make_inputs
check_prepare
start_endless_job
start_job_beyond_its_limit
check_collage
check_incomplete_collage
check_another_folder
check_gpu_shares
check_campaign
check_scaling
check_endless_job
start_job_that_loses_a_node
"$program" collage longer.toml --out longer_alone --quiet
"$program" collage long.toml --out long_alone --quiet  # Slurm needs 20 s to notice that a node is gone
check_interrupted_collage
check_job_beyond_its_limit
check_job_that_lost_a_node
