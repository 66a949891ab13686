#!/usr/bin/env bash
# gpu-check.sh OUT [--minutes M] [--only NAME,...]: what a bundle's programs do on this machine's OpenCL devices: that
# the bits are the reference's, and how fast they are. It stands in the folder of a bundle (scripts/gpu-bundle.sh). The
# most telling checks come first, each with a limit of its own; a table of all comes last, and OUT/results.tar.gz has
# the whole output. Exit code: 0 all passed, 3 some failed.
set -uo pipefail

usage() {
  echo "usage: gpu-check.sh OUT [--minutes M] [--only NAME,...]" >&2
  exit 2
}
out= minutes=5 only=
while [[ $# -gt 0 ]]; do
  case $1 in
    --minutes) minutes=${2:?--minutes needs a number}; shift 2 ;;
    --only) only=,${2:?--only needs names},; shift 2 ;;
    -*) usage ;;
    *) [[ -z $out ]] || usage; out=$1; shift ;;
  esac
done
[[ -n $out ]] || usage
mkdir -p "$out"
out=$(readlink -f "$out")
# shellcheck source=scripts/gpu-env.sh
source "$(dirname "${BASH_SOURCE[0]}")/gpu-env.sh"
work=$(mktemp -d)
logs=$work/logs
mkdir -p "$logs"
cd "$work" || exit 1
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 RC_PARAMS=seed=2016
[[ $minutes =~ ^[0-9]+$ ]] || usage
ends=$((SECONDS + minutes * 60))
table=() failed=0

# check NAME LIMIT_S COMMAND...: runs it, its output to a log; a line of the table.
check() {
  local name=$1 limit=$2 started result left
  shift 2
  [[ -z $only || $only == *,$name,* ]] || return 0
  left=$((ends - SECONDS))
  if ((left < 3)); then
    table+=("$(printf '%-24s %7s  not begun: the minutes are over' "$name" -)")
    return 0
  fi
  ((limit < left)) || limit=$left
  echo "== $name"
  started=$EPOCHREALTIME
  timeout -k 5 "$limit" "$@" >"$logs/$name.log" 2>&1 </dev/null
  result=$?
  local took
  took=$(awk -v a="$started" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.1f s", b - a }')
  tail -n 3 "$logs/$name.log"
  case $result in
    0) table+=("$(printf '%-24s %7s  passed' "$name" "$took")") ;;
    124 | 137) table+=("$(printf '%-24s %7s  FAILED: longer than its %s s' "$name" "$took" "$limit")"); failed=3 ;;
    *) table+=("$(printf '%-24s %7s  FAILED (%s): %s' "$name" "$took" "$result" \
      "$(grep -m 1 -E 'FAILED|error|rror:|differ' "$logs/$name.log" | cut -c 1-150)")"); failed=3 ;;
  esac
}

# figures NAME PATTERN: lines of a check's log that belong into the table.
figures() {
  [[ -e $logs/$1.log ]] || return 0
  local line
  while IFS= read -r line; do table+=("    $line"); done < <(grep -E "$2" "$logs/$1.log" | head -n "${3:-12}")
}

facts() {
  nvidia-smi 2>&1
  ldconfig -p | grep -i -E 'opencl|libcuda|nvvm|ptxjit'
  echo "OpenCL libraries of drivers:"; vendor_opencl
  ls -l /usr/local/nvidia /usr/local/nvidia/lib* /etc/OpenCL/vendors 2>&1 | head -n 120
  env | grep -E 'CUDA|NVIDIA|LD_LIB|OCL' ; ldd --version | head -n 1; nproc; free -g
  true
}

main_job() { # NAME COMMAND...: the demo's job, and its picture
  local name=$1
  shift
  "$@" tessera collage "$bundle/jobs/animals.toml" --set library.file="$work/animals.h5" --out "$work/$name" --quiet &&
    cat "$work/$name/card.txt" && sha256sum "$work/$name/pieces.geojson" && cp "$work/$name/collage.png" "$out/$name.png"
}
export -f facts main_job vendor_opencl
export work bundle out

check facts 30 bash -c facts
check devices 120 tessera devices
figures devices 'platform|gpu|cpu|accelerator|NOT' 8
if [[ ! -s $logs/devices.log ]] || grep -q 'no OpenCL platform' "$logs/devices.log"; then
  echo "gpu-check: no OpenCL device on this machine; the bundle's PoCL: BUNDLE_POCL=1 $0 ..."
fi
check test_arithmetic_probe 120 "$bundle/tests/test_arithmetic_probe"
check test_kernels 180 "$bundle/tests/test_kernels"
check test_opencl_runtime 60 "$bundle/tests/test_opencl_runtime" --gtest_filter='-Faulty*'
check test_device_memory 60 "$bundle/tests/test_device_memory"
check test_pair_search 90 "$bundle/tests/test_pair_search"
check library 60 tessera library build "$bundle/animals" -o "$work/animals.h5"
check golden 120 "$bundle/tests/golden/golden_test.sh" tessera "$bundle/tests/golden_inputs" "$work/golden"
check pairs 60 tessera bench pairs --out "$out/pairs.json"
figures pairs '.' 16
check headline 60 tessera bench headline --out "$out/headline.json"
figures headline '.' 16
check demo 90 bash -c 'main_job demo'
figures demo 'coverage|overlap|Coverage|pieces|time|seconds|[0-9a-f]{64}' 14
check library_10000 60 tessera bench library --library "$work/animals.h5" --sizes 10000 --out "$out/library_10000.json"
figures library_10000 '.' 10
check two_ranks 90 bash -c 'main_job two_ranks mpirun -n 3 --oversubscribe --bind-to none'
figures two_ranks '[0-9a-f]{64}'
check library_100000 90 tessera bench library --library "$work/animals.h5" --sizes 100000 --out "$out/library_100000.json"
figures library_100000 '.' 10
check test_opencl_matcher 120 "$bundle/tests/test_opencl_matcher"
check test_stored_matching 60 "$bundle/tests/test_stored_matching"
check test_device_room 60 "$bundle/tests/test_device_room"
check test_device_speed 60 "$bundle/tests/test_device_speed"
check test_opencl_devices 60 "$bundle/tests/test_opencl_devices" --gtest_filter='-NoPlatform.*'
check table2 120 tessera bench table2 --library "$work/animals.h5" --out "$out/table2.json"
figures table2 '.' 20

tar -C "$work" -czf "$out/results.tar.gz" logs
echo
echo "Checks on $(hostname), bundle of commit $(cat "$bundle/commit.txt" 2>/dev/null):"
printf '%s\n' "${table[@]}" | tee "$out/table.txt"
rm -rf "$work" "$vendors"
exit $failed
