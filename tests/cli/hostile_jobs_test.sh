#!/usr/bin/env bash
# hostile_jobs_test.sh TESSERA WRITE_HOSTILE_JOBS NEW_FOLDER DATA_KIB: runs the program with harmful job files.
# Each run ends without a crash within 20 s and DATA_KIB of memory (or "unlimited"). A refusal is one line.
set -uo pipefail
tessera=$1
write_hostile_jobs=$2
folder=$3
data_kib=$4
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

# try CODES COMMAND...: like run; a refusal (exit code 2) must be one line.
try() {
  run "$@"
  [[ $code != 2 || $(wc -l <errors) == 1 ]] || fail "not refused in one line: ${*:2}"
}
refused() { # WORD COMMAND...
  local word=$1
  shift
  try 2 "$@"
  grep -qF -- "$word" errors || fail "does not name $word: $*"
  grep -q 'allowed' errors || fail "does not say what is allowed: $*"
}

enter_folder
mkdir folder
cp drawings/leaf.svg mask.svg
mkfifo pipe
write_job '64, 48' '14, 40' 64
ulimit -d "$data_kib"
most_s=20
collage=(collage job.toml --out result --quiet --time-limit 5)

for file in pipe /dev/zero folder none; do
  for command in plan collage; do
    refused library.file "$command" job.toml --set "library.file=$file"
    refused canvas.file "$command" job.toml --set "canvas.file=$file"
  done
done
for file in pipe /dev/zero folder; do try 2 plan "$file"; done
echo "ok pipes, devices and folders"

refused canvas.size_px plan job.toml --set 'canvas.size_px=[1, 1]'
refused canvas.size_px plan job.toml --set 'canvas.size_px=[20000, 20000]'
refused output.width_px "${collage[@]}" --set output.width_px=60001
refused output.width_px "${collage[@]}" --set 'canvas.size_px=[16, 20000]' --set output.width_px=64
refused pieces.scale_px plan job.toml --set 'pieces.scale_px=[40, 14]'
echo "ok refused sizes"

# These values are legal but hardly sensible.
for value in 'canvas.size_px=[16, 16]' 'canvas.size_px=[2000, 16]' 'pieces.padding_px=500' 'pieces.scale_px=[2, 5000]' \
  'pieces.scale_px=[4999, 5000]' 'pieces.rotation_deg=[-360, 360]' 'pieces.rotation_deg=[360, 360]' \
  pieces.uses=1000000 pieces.balance=0 pieces.balance=1 match.levels=2 match.levels=6 match.delta_tau=0.02 match.delta_tau=1 match.top_percent=100 \
  match.top_percent=0.001 match.most_pairs=0 match.beta=0 match.beta=4 match.tangent_dockings=0 \
  match.tangent_dockings=100000 match.delta_px=50 objective.overlap_weight=0 objective.gap_weight=100 \
  objective.length_exponent=0 objective.length_exponent=4 objective.scale_exponent=4 objective.repetition_exponent=4 \
  objective.near_twin_factor=0 stop.coverage=0.01 stop.seconds=1e7 improve.seconds=1e7 checkpoint.every_s=0 \
  checkpoint.every_s=1e6; do
  try "0 3 75" "${collage[@]}" --set "$value" --restart
  [[ -s result/pieces.geojson ]] || fail "no pieces: $value"
done
for value in pieces.least_scale_px=5000 'pieces.uses=[1000000, 1000000]' 'pieces.scale_px=[2, 5000]' pieces.apart_px=20000 \
  pieces.padding_px=500 pieces.sizes=drawn canvas.seamless=both start.grow=outward stop.coverage=0.01; do
  try "0 3 75" "${collage[@]}" --set pieces.fit=all --set stop.pieces=0 --set "$value" --restart
  [[ -s result/pieces.geojson ]] || fail "no pieces: pieces.fit=all, $value"
done
echo "ok extremes"

"$write_hostile_jobs" 60
for job in job_*.toml; do
  try "0 2" plan "$job"
  [[ -s errors ]] || try "0 3 75" collage "$job" --out any --quiet --restart --time-limit 5 --set stop.pieces=1 \
    --set output.width_px=64 --set 'canvas.size_px=[64, 48]' --set devices.use=cpu --set devices.per_worker=0
done
echo "ok job files by chance"
