#!/usr/bin/env bash
# restart_kill_test.sh TESSERA MPIRUN NEW_FOLDER KILLS [SEED]: kills a random rank at a random moment and restarts the run, again and again.
# Every run that ends has the same pieces, and no checkpoint is ever lost.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
kills=$4
RANDOM=${5:-$$}
echo "seed ${5:-$$}"
# shellcheck source=tests/cli/restart_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../restart_fixture.sh"

make_job 100

killed=0
finished=0
resumed=0
until ((killed >= kills && finished >= 1)); do
  options=(--set checkpoint.every_s=0.001) # after every round, so that many kills hit the writing
  if [[ -e out/checkpoint.h5 || -e out/manifest.json ]]; then
    options+=(--resume)
    resumed=$((resumed + 1))
  elif [[ -e out/checkpoint.previous.h5 ]]; then
    fail "only the previous checkpoint is left"
  fi
  ranks=$((RANDOM % 2 ? 3 : 1))
  start "$ranks" out "${options[@]}"
  if ((killed < kills)); then
    # Kills at any moment. Every other kill comes after the first round, however busy the machine is.
    ((killed % 2)) && wait_for_checkpoint out
    pause_ms=$((RANDOM % run_ms))
    sleep "$((pause_ms / 1000)).$(printf %03d $((pause_ms % 1000)))"
    read -ra victims < <(cat "/proc/$started/task/$started/children" 2>/dev/null)
    [[ $ranks == 1 ]] && victims=("$started")
    if ((${#victims[@]} > 0)) && kill -KILL "${victims[RANDOM % ${#victims[@]}]}" 2>/dev/null; then
      killed=$((killed + 1))
    fi
  fi
  wait "$started" 2>/dev/null
  code=$?
  [[ $code != 2 ]] || fail "kill $killed: what was left is refused"
  if [[ $code == 0 ]]; then
    expect_result out
    rm -r out
    finished=$((finished + 1))
  elif ((${#options[@]} > 2)) && [[ ! -e out/checkpoint.h5 && ! -e out/manifest.json ]]; then
    fail "kill $killed: the checkpoint is lost"
  fi
done
((resumed > 0)) || fail "no run went on from a checkpoint"
echo "ok: $killed kills, $resumed runs went on from a checkpoint, $finished came to their end"
