#!/usr/bin/env bash
# random_signals_test.sh TESSERA MPIRUN NEW_FOLDER MOMENTS [SEED]: ends runs by Ctrl-C, TERM, USR2 and the time limit.
# The ends come at random moments, also while drawing, on 1 and 3 ranks.
# Each run ends in time, and goes on to the bytes of an undisturbed run. PATIENCE=3 allows three times as long, for busy machines.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
moments=$4
RANDOM=${5:-$$}
echo "seed ${5:-$$}"
patience=${PATIENCE:-1}
# shellcheck source=tests/cli/restart_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../restart_fixture.sh"
# shellcheck source=tests/cli/drawing_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../drawing_fixture.sh"

make_drawn_job 20 2000
seconds() { echo "$(($1 / 1000)).$(printf %03d $(($1 % 1000)))"; }

# The files in the folder decide how to go on. tessera draw draws every other finished collage.
go_on() { # NUMBER OF ENDS SO FAR
  if [[ ! -e out/checkpoint.h5 && -e out/manifest.json ]] && (($1 % 2)); then
    "$tessera" draw out >output 2>errors || fail "end $1: tessera draw"
    return
  fi
  local options=()
  [[ ! -e out/checkpoint.h5 && ! -e out/manifest.json ]] || options=(--resume)
  start 1 out "${options[@]}"
  expect_end 0 "end $1: going on"
}

# Waits for $started and sets its exit $code.
# mpirun of Debian 12 may hang in PMIx_server_finalize if a rank was ended while it connected. The ranks are then gone, and mpirun waits for
# itself. The test ends mpirun and counts the case.
locked_up=0
await_end() { # RANKS
  local alone=0
  while (($1 == 3)) && kill -0 "$started" 2>/dev/null; do
    sleep 0.1
    ps -o stat= --ppid "$started" >children
    if grep -qv '^Z' children; then alone=0; else alone=$((alone + 1)); fi
    ((alone < 300)) || break
  done
  if ((alone >= 300)); then
    locked_up=$((locked_up + 1))
    kill -KILL "$started" 2>/dev/null
  fi
  wait "$started" 2>/dev/null
  code=$?
}

computing=0
drawing=0
for ((n = 0; n < moments; ++n)); do
  rm -rf out
  ranks=$((RANDOM % 2 ? 3 : 1))
  moment_ms=$((RANDOM % (run_ms + run_ms / 4)))
  how=$((n % 4))
  most_ms=$(((ranks == 1 ? 2000 : 5000) * patience))
  if ((how == 3)); then
    moment_ms=$((moment_ms + (ranks == 1 ? 2100 : 6100))) # a limit below the time kept for the end is refused
    start "$ranks" out --time-limit "$(seconds "$moment_ms")"
    most_ms=$(((ranks == 1 ? 500 : 3000) * patience)) # mpirun starts before the limit counts, and ends after it
  else
    start "$ranks" out
  fi
  sleep "$(seconds "$moment_ms")"
  signals=(INT TERM USR2)
  ((how == 3)) || kill -s "${signals[how]}" "$started" 2>/dev/null
  began_ms=$(date +%s%3N)
  await_end "$ranks"
  took_ms=$(($(date +%s%3N) - began_ms))
  [[ $code != 2 ]] || fail "end $n: what was there is refused"
  if [[ $code == 75 ]] && ((took_ms > most_ms)); then
    fail "end $n: took $took_ms ms after ${signals[how]-the limit}"
  fi
  [[ $code == 0 || -z $(find out -name 'collage*.tmp' 2>/dev/null) || $ranks == 3 ]] ||
    fail "end $n: a half-written picture"
  if [[ -e out/manifest.json && ! -e out/checkpoint.h5 && $code != 0 ]]; then
    drawing=$((drawing + 1))
  elif [[ -e out/checkpoint.h5 ]]; then
    computing=$((computing + 1))
  fi
  echo "$n: $ranks ranks, ${signals[how]-limit} after $moment_ms ms: exit code $code in $took_ms ms"
  [[ $code == 0 ]] || go_on "$n"
  expect_drawn out
done
((locked_up <= 2)) || fail "mpirun locked up $locked_up times"
echo "ok: $moments ends, $computing while computing, $drawing while drawing"
