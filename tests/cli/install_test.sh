#!/usr/bin/env bash
# install_test.sh CMAKE BUILD_FOLDER NEW_FOLDER: runs cmake --install and moves the installation elsewhere.
# From there, in an environment without repository and build, it makes a library and a collage, and the templates find all files.
set -uo pipefail
cmake=$1
build=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

new_folder
mkdir work
cd work || exit 1
"$cmake" --install "$build" --prefix "$folder/first" >output 2>errors || fail "cmake --install"
mv "$folder/first" "$folder/moved"
prefix=$folder/moved
share=$prefix/share/tessera

for file in README.md ARCHITECTURE.md LICENSE docs/job-format.md docs/gallery/animals.jpg jobs/animals.toml \
  jobs/canvas/heart.svg slurm/README.md slurm/collage.sbatch slurm/job.sh slurm/program.sh; do
  [[ -s $share/$file ]] || fail "not installed: $file"
done
[[ -x $share/slurm/gpu_share.sh && -x $share/slurm/campaign.sh ]] || fail "scripts that cannot be run"
echo "ok all files"

# The environment has only PATH, a HOME for the kernels' cache, and the variables of the sanitizers' preset.
bare() {
  env -i PATH="$prefix/bin:/usr/bin:/bin" HOME="${HOME-/tmp}" ASAN_OPTIONS="${ASAN_OPTIONS-}" LSAN_OPTIONS="${LSAN_OPTIONS-}" \
    ${OCL_ICD_VENDORS:+"OCL_ICD_VENDORS=$OCL_ICD_VENDORS"} "$@"
}
bare tessera --version >output || fail "--version"
for program in tessera tessera-bench; do
  readelf -d "$prefix/bin/$program" >output || fail "not installed: $program"
  grep -qiE 'R(UN)?PATH' output && fail "$program looks for libraries in fixed folders"
done
bare tessera bench pairs --quick >output 2>errors || fail "tessera bench"
[[ -s out/bench_pairs.json ]] || fail "no report of tessera bench"
rm -r out
make_drawings drawings
bare tessera library build drawings -o own.h5 >output 2>errors || fail "library build"
# One of the installed jobs, whose canvas lies beside it.
bare tessera collage "$share/jobs/heart.toml" --set library.file=own.h5 --set 'canvas.size_px=[160, 120]' \
  --set 'pieces.scale_px=[14, 60]' --set output.width_px=160 --set stop.pieces=3 --out result >output 2>errors ||
  fail "collage"
[[ -s result/collage.png && -s result/pieces.geojson ]] || fail "no result"
grep -q "\"command_line\": \"tessera collage $share/jobs/heart.toml" result/card.json ||
  fail "another command in the card"
echo "ok a library and a collage"

# The commands of docs/guide/install.md for the installed jobs, with other drawings and fewer pieces.
# shellcheck disable=SC2016  # as it stands there
for line in 'cp -r $HOME/tessera/share/tessera/jobs .' 'mkdir out' 'tessera library build /usr/share/openclipart' \
  '-o out/animals.h5' 'tessera collage jobs/animals.toml'; do
  grep -qF -- "$line" "$share/docs/guide/install.md" || fail "docs/guide/install.md lacks: $line"
done
cp -r "$share/jobs" .
mkdir out
bare tessera library build drawings -o out/animals.h5 >output 2>errors || fail "the jobs' library"
for job in animals heart; do
  bare tessera collage "jobs/$job.toml" --set stop.pieces=2 --set output.width_px=100 >output 2>errors ||
    fail "jobs/$job.toml"
  [[ -s out/$job/collage.png ]] || fail "no result of jobs/$job.toml"
done
echo "ok the jobs that came with it"

# The templates look for the program in PATH, then in TESSERA_ROOT, then beside themselves. Without any, they say what to do.
found() {  # VARIABLE=VALUE...: prints the program that program.sh of $slurm finds
  # shellcheck disable=SC2016  # for the inner shell
  env -i "$@" bash -c 'source "$1/program.sh" && find_tessera && echo "$tessera"' find "$slurm" 2>errors
}
stand_in() {  # PATH_OF_A_PROGRAM
  mkdir -p "$(dirname "$1")"
  printf '#!/bin/sh\n' >"$1"
  chmod +x "$1"
}
stand_in "$PWD/path/tessera"
stand_in "$PWD/repository/build/release/src/cli/tessera"
stand_in "$PWD/own"
slurm=$share/slurm
tools=PATH=/usr/bin:/bin
[[ $(found "PATH=$PWD/path:/usr/bin:/bin" "TESSERA_ROOT=$PWD/repository") == "$PWD/path/tessera" ]] ||
  fail "PATH is not first"
[[ $(found "$tools" "TESSERA_ROOT=$PWD/repository") == "$PWD/repository/build/release/src/cli/tessera" ]] ||
  fail "TESSERA_ROOT is not second"
[[ $(found "$tools") == "$prefix/bin/tessera" ]] || fail "not the one beside the templates"
[[ $(found "$tools" "TESSERA_ROOT=$share") == "$prefix/bin/tessera" ]] || fail "not the installed one by TESSERA_ROOT"
[[ $(found "PATH=$PWD/path:/usr/bin:/bin" "TESSERA=$PWD/own") == "$PWD/own" ]] || fail "TESSERA is not before all"
found "$tools" "TESSERA=$PWD/none" && fail "TESSERA that is not there"
grep -qF "$PWD/none" errors || fail "does not name TESSERA's program"
mkdir lonely
cp -r "$share/slurm" lonely/slurm
slurm=$PWD/lonely/slurm
found "$tools" && fail "found a program where there is none"
for word in PATH TESSERA TESSERA_ROOT lonely/build/release/src/cli/tessera; do
  grep -qF "$word" errors || fail "the message lacks $word"
done
for template in "$share"/slurm/*.sbatch; do
  cp "$template" lonely/copy.sbatch  # as Slurm does
  env -i $tools bash lonely/copy.sbatch >output 2>errors && fail "a template without job.sh"
  grep -q 'cannot find job.sh.*set TESSERA_ROOT' errors || fail "$template: does not name TESSERA_ROOT"
  env -i $tools "TESSERA_ROOT=$share" bash lonely/copy.sbatch >output 2>errors && fail "a template without Slurm"
  grep -q 'sbatch starts these files' errors || fail "$template: does not name sbatch"
done
echo "ok the templates find the program"
