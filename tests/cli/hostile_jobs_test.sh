#!/usr/bin/env bash
# hostile_jobs_test.sh TESSERA WRITE_HOSTILE_JOBS NEW_FOLDER DATA_KIB: job files that nobody should write, given to the
# program: no crash, no more than 20 s and DATA_KIB of memory each (or "unlimited"); what is refused is refused in one line.
set -uo pipefail
tessera=$1
write_hostile_jobs=$2
folder=$3
data_kib=$4
# shellcheck source=tests/support/drawings.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/drawings.sh"
unset SLURM_JOB_END_TIME

fail() {
  echo "FAILED $*"
  head -c 2000 output errors
  exit 1
}

# run CODES COMMAND...: tessera's exit code is one of CODES (0, 2, 75).
run() {
  local expected=$1 code
  shift
  (
    ulimit -d "$data_kib"
    exec timeout 20 "$tessera" "$@"
  ) >output 2>errors
  code=$?
  [[ " $expected " == *" $code "* ]] || fail "exit code $code, not $expected: $*"
  [[ $code != 2 || $(wc -l <errors) == 1 ]] || fail "not refused in one line: $*"
}
refused() { # WORD COMMAND...
  local word=$1
  shift
  run 2 "$@"
  grep -qF -- "$word" errors || fail "does not name $word: $*"
  grep -q 'allowed' errors || fail "does not say what is allowed: $*"
}

rm -rf "$folder"
mkdir -p "$folder/folder"
cd "$folder" || exit 1
make_drawings drawings
"$tessera" library build drawings -o own.h5 >output 2>errors || fail "library"
cp drawings/leaf.svg mask.svg
mkfifo pipe

cat >job.toml <<'END_OF_JOB'
[library]
file = 'own.h5'
[canvas]
size_px = [64, 48]
[pieces]
scale_px = [14, 40]
[stop]
pieces = 2
[output]
width_px = 64
END_OF_JOB
collage=(collage job.toml --out result --quiet --time-limit 5)

for file in pipe /dev/zero folder none; do
  for command in plan collage; do
    refused library.file "$command" job.toml --set "library.file=$file"
    refused canvas.file "$command" job.toml --set "canvas.file=$file"
  done
done
for file in pipe /dev/zero folder; do run 2 plan "$file"; done
echo "ok pipes, devices and folders"

refused canvas.size_px plan job.toml --set 'canvas.size_px=[1, 1]'
refused canvas.size_px plan job.toml --set 'canvas.size_px=[20000, 20000]'
refused output.width_px "${collage[@]}" --set output.width_px=20001
refused output.width_px "${collage[@]}" --set 'canvas.size_px=[16, 20000]' --set output.width_px=64
refused pieces.scale_px plan job.toml --set 'pieces.scale_px=[40, 14]'
echo "ok refused sizes"

# Legal, if hardly sensible.
for value in 'canvas.size_px=[16, 16]' 'canvas.size_px=[2000, 16]' 'pieces.padding_px=500' 'pieces.scale_px=[2, 5000]' \
  'pieces.scale_px=[4999, 5000]' 'pieces.rotation_deg=[-360, 360]' 'pieces.rotation_deg=[360, 360]' pieces.uses=1000000 \
  match.levels=2 match.levels=6 match.delta_tau=0.02 match.delta_tau=1 match.top_percent=100 match.top_percent=0.001 \
  match.most_pairs=0 match.beta=0 match.beta=4 match.tangent_dockings=0 match.tangent_dockings=100000 match.delta_px=50 \
  objective.overlap_weight=0 objective.gap_weight=100 objective.length_exponent=0 objective.length_exponent=4 \
  objective.scale_exponent=4 objective.repetition_exponent=4 objective.near_twin_factor=0 stop.coverage=0.01 \
  stop.seconds=1e7 improve.seconds=1e7 checkpoint.every_s=0 checkpoint.every_s=1e6; do
  run "0 75" "${collage[@]}" --set "$value" --restart
  [[ -s result/pieces.geojson ]] || fail "no pieces: $value"
done
echo "ok extremes"

"$write_hostile_jobs" 60
for job in job_*.toml; do
  run "0 2" plan "$job"
  [[ -s errors ]] || run "0 75" collage "$job" --out any --quiet --restart --time-limit 5 --set stop.pieces=1 \
    --set output.width_px=64 --set 'canvas.size_px=[64, 48]' --set devices.use=cpu --set devices.per_worker=0
done
echo "ok job files by chance"
