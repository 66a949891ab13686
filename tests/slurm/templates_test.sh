#!/usr/bin/env bash
# templates_test.sh NEW_FOLDER: the templates' messages about options and limits that do not fit them. It runs without Slurm: Slurm's
# commands, mpirun and the program are replaced.
set -uo pipefail
folder=$1
slurm=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../slurm" && pwd)
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../cli/command_fixture.sh"

new_folder
mkdir bin
for name in mpirun tessera squeue scontrol; do
  printf '#!/bin/sh\n[ %s != mpirun ] || echo "$@"\n' "$name" >"bin/$name"
done
chmod +x bin/*
touch job.toml own.h5

# collage SECONDS_LEFT OPTION...: runs the template with this time left
collage() {
  local left_s=$1
  shift
  env -i PATH="$folder/bin:/usr/bin:/bin" SLURM_JOB_ID=1 SLURM_NTASKS=3 TESSERA_ROOT="$slurm/.." \
    SLURM_JOB_END_TIME=$(($(date +%s) + left_s)) bash "$slurm/collage.sbatch" job.toml own.h5 out "$@" >output 2>errors
}

collage 1800 --set seed=2 || fail "the template"
grep -q 'collage job.toml --out out --resume=auto .*--set seed=2' output || fail "another command"
[[ ! -s errors ]] || fail "a warning of half an hour"
collage 120 || fail "a short limit"
grep -qE 'warning: the job ends in 1[12][0-9] s, .* 180 s early as the template sets it: .*give it more time' errors ||
  fail "no warning of two minutes"
[[ -s output ]] || fail "does not run"
collage -100 || fail "a limit that is over"
[[ ! -s errors ]] || fail "a warning of a limit that is another job's"
echo "ok limits"

# Exit code 3: done, but pieces are missing.
cp bin/mpirun mpirun.before
printf '#!/bin/sh\nexit 3\n' >bin/mpirun
collage 1800 || fail "exit code 3 of tessera collage is not taken as done"
grep -q '^out: done, but pieces are missing: .* (exit code 3)$' output || fail "does not say that pieces are missing"
grep -q 'queued again' output && fail "queued again for exit code 3"
cp mpirun.before bin/mpirun
echo "ok incomplete collages"

for option in --restart --restart=true --resume --resume=previous; do
  collage 1800 "$option"
  [[ $? == 2 && ! -s output ]] || fail "$option: not refused"
  grep -qe "^$option: not in a template, .* to start again give another folder, or remove checkpoint.h5" errors ||
    fail "$option: does not say what to do"
done
echo "ok other starts"
