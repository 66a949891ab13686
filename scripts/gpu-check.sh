#!/usr/bin/env bash
# gpu-check.sh BUNDLE OUT [--minutes M] [--only NAME,...]: what the programs of a bundle (docs/bundle.md) do on this
# machine's OpenCL devices: whether the bits are the reference's, and how fast they are. BUNDLE: the unpacked folder, or
# bundle.tar.xz. The most telling checks come first, each with a limit of its own, all within M minutes (default 5).
# A table comes last; OUT gets gpu-check.log and results.tar.gz.
# Exit code: 0 all passed, 1 no OpenCL device, 2 wrong arguments, 3 some failed or were not begun in time.
set -uo pipefail

# Each check's name and seconds, for a run of at most five minutes; in a longer run each check may take longer, too. The checks that tell
# most about a new machine come first.
readonly plan=(
  "facts 30" "devices 120" "test_arithmetic_probe 120" "test_kernels 180" "test_pair_search 90"
  "test_opencl_runtime 60" "test_device_memory 60" "library 60" "golden 150" "pairs 60" "headline 60" "demo 120"
  "library_10000 90" "two_ranks 120"
  "profile 60" "library_100000 150" "test_stored_matching 90" "test_device_room 60" "test_device_speed 60"
  "test_opencl_devices 60" "test_opencl_matcher 300" "table2 180")

# The lines of a check's log that the table shows: their largest number, and a pattern.
declare -rA shown=(
  [devices]='6 ^platform|: (gpu|cpu|accelerator) "'
  [pairs]='2 ^device,'
  [headline]='3 ^(time, ms|of it counting|docking and refining)'
  [demo]='5 ^ *(coverage|pieces  |total time|of it improving|drawing time)'
  [library_10000]='1 ^ *10000 '
  [library_100000]='1 ^ *100000 '
  [profile]='15 ^(\(|[a-z_]+ ).* [0-9.]+ +[0-9.]+$'
  [table2]='3 ^(Fig|paper|here|seconds)'
)
readonly most_lines=60

usage() {
  sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}"
  echo "Checks: ${plan[*]% *} (facts, devices: always)"
}

# wrong WORDS: reports wrong arguments and exits.
wrong() {
  echo "gpu-check.sh: $1" >&2
  usage >&2
  exit 2
}

read_arguments() {
  local places=() name
  while [[ $# -gt 0 ]]; do
    case $1 in
      -h | --help) usage; exit 0 ;;
      --minutes)
        [[ ${2-} =~ ^[1-9][0-9]{0,3}$ ]] || wrong "--minutes takes whole minutes, not '${2-}'"
        minutes=$2
        shift 2
        ;;
      --only) [[ -n ${2-} ]] || wrong "--only takes names"; only=$2; shift 2 ;;
      -*) wrong "unknown option $1" ;;
      *) places+=("$1"); shift ;;
    esac
  done
  [[ ${#places[@]} -eq 2 ]] || wrong "it takes a bundle and a folder"
  for name in ${only//,/ }; do
    [[ " ${plan[*]% *} " == *" $name "* ]] || wrong "there is no check '$name'"
  done
  bundle=${places[0]} out=${places[1]}
}

# open_bundle: unpacks the bundle if it is an archive, and loads its environment.
open_bundle() {
  if [[ -f $bundle ]]; then
    tar -C "$work" -xf "$bundle" || { echo "gpu-check.sh: cannot unpack $bundle" >&2; exit 2; }
    bundle=$work/bundle
  fi
  [[ -e $bundle/env.sh ]] || wrong "$bundle is no bundle: it has no env.sh"
  # shellcheck source=scripts/bundle-env.sh
  source "$bundle/env.sh"
}

# check NAME LIMIT_S: runs run_NAME with its own log. It prints a line of the table and the chosen lines of the log.
check() {
  local name=$1 limit=$2 left=$((ends - SECONDS)) started=$EPOCHREALTIME result took said
  if ((left < 3)); then
    add_row "$name" - "not begun: the minutes are over"
    failed=3
    return
  fi
  ((limit < left)) || limit=$left
  echo "== $name"
  timeout -k 5 "$limit" bash -c "set -eo pipefail; run_$name" >>"$results/logs/$name.log" 2>&1 </dev/null &
  running=$!
  tell_processes_after $((limit - 1)) $running >>"$results/logs/$name.log" 2>/dev/null &
  local watch=$!
  wait $running
  result=$?
  kill $watch 2>/dev/null
  end_processes $running
  running=
  took=$(awk -v a="$started" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.1f s", b - a }')
  { echo "== $name: $took, exit code $result"; cat "$results/logs/$name.log"; echo; } >>"$out/gpu-check.log"
  case $result in
    0) said=passed ;;
    124 | 137) said="FAILED: stopped after $limit s" ;;
    *) said="FAILED ($result): $(grep -m 1 -E 'FAILED|rror|differ|no OpenCL|NOT ' "$results/logs/$name.log" |
      cut -c 1-150)" ;;
  esac
  [[ $said == passed ]] || failed=3
  add_row "$name" "$took" "$said"
  add_shown "$name"
  tail -n 2 "$results/logs/$name.log"
}

# processes_of GROUP: prints the ids of a check's processes, one a line. timeout makes a process group of them.
processes_of() {
  awk -v group="$1" '{ sub(/^.*\) /, ""); if ($3 == group) print FILENAME }' /proc/[0-9]*/stat 2>/dev/null |
    cut -d / -f 3
}

# tell_processes GROUP: prints the state of each thread of a check that is about to be stopped.
tell_processes() {
  local process thread
  echo "stopped at:"
  for process in $(processes_of "$1"); do
    echo "$process: $(tr '\0' ' ' <"/proc/$process/cmdline")"
    for thread in "/proc/$process/task"/*; do
      # The state, the kernel function, and the system call with its arguments.
      echo "  $(cat "$thread/comm") $(cut -d ')' -f 2 "$thread/stat" | cut -c 2) $(cat "$thread/wchan" "$thread/syscall" | tr '\n' ' ')"
    done
  done 2>/dev/null
}

# tell_processes_after SECONDS GROUP: waits without `sleep`, which would outlive this script.
tell_processes_after() {
  local never
  exec {never}<> <(:)
  read -rt "$1" -u "$never" || tell_processes "$2"
}

# end_processes GROUP: ends what a check left behind, so that it does not slow down the next one.
end_processes() {
  local process
  for process in $(processes_of "$1"); do kill -KILL "$process" 2>/dev/null; done
}

add_row() { table+=("$(printf '%-24s %9s  %s' "$@")"); }

add_shown() {
  local most pattern line
  [[ -n ${shown[$1]-} ]] || return 0
  read -r most pattern <<<"${shown[$1]}"
  while IFS= read -r line; do
    table+=("    $line")
  done < <(grep -E "$pattern" "$results/logs/$1.log" | head -n "$most")
}

# finish: prints the table and writes the files in OUT.
finish() {
  [[ -z $running ]] || kill "$running" 2>/dev/null
  {
    echo "Checks on $(uname -n), bundle of commit $(cat "$bundle/commit.txt" 2>/dev/null):"
    printf '%s\n' "${table[@]}"
  } | head -n $most_lines >"$results/table.txt"
  tar -C "$work" -czf "$out/results.tar.gz" results
  echo
  tee -a "$out/gpu-check.log" <"$results/table.txt"
  cd / && rm -rf "$work"
}

run_facts() {
  nvidia-smi 2>&1 || true
  echo "OpenCL libraries of drivers:"
  vendor_opencl || true
  echo "Files in /etc/OpenCL/vendors:"
  grep . /etc/OpenCL/vendors/*.icd 2>&1 || true
  PATH=$PATH:/sbin:/usr/sbin ldconfig -p 2>/dev/null | grep -iE 'opencl|libcuda|nvvm|ptxjit' || true
  env | grep -E 'CUDA|NVIDIA|LD_LIB|OCL|OPAL|PMIX' || true
  ldd --version | sed -n 1p
  nproc
  grep -m 1 'model name' /proc/cpuinfo || true
  grep -E 'MemTotal|MemAvailable' /proc/meminfo
}

run_devices() {
  tessera devices | tee devices.txt
  ! grep -E 'NOT USABLE|NOT AVAILABLE' devices.txt
}

run_test_arithmetic_probe() { "$bundle/tests/test_arithmetic_probe"; }
run_test_kernels() { "$bundle/tests/test_kernels"; }
run_test_pair_search() { "$bundle/tests/test_pair_search"; }
run_test_opencl_runtime() { "$bundle/tests/test_opencl_runtime"; }
run_test_device_memory() { "$bundle/tests/test_device_memory"; }
run_test_stored_matching() { "$bundle/tests/test_stored_matching"; }
run_test_device_room() { "$bundle/tests/test_device_room"; }
run_test_device_speed() { "$bundle/tests/test_device_speed"; }
run_test_opencl_devices() { "$bundle/tests/test_opencl_devices" --gtest_filter='-NoPlatform.*'; }
run_test_opencl_matcher() { "$bundle/tests/test_opencl_matcher"; }
run_golden() { "$bundle/tests/golden/golden_test.sh" tessera "$bundle/tests/golden_inputs" "$work/golden"; }
run_library() { tessera library build "$bundle/animals" -o animals.h5; }
need_library() { [[ -e animals.h5 ]] || run_library; }
run_pairs() { tessera bench pairs --out "$results/pairs.json"; }
run_headline() { tessera bench headline --out "$results/headline.json"; }

# main_job NAME COMMAND...: runs the demo's job, and shows its card and its picture.
main_job() {
  local name=$1
  shift
  need_library
  "$@" tessera collage "$bundle/jobs/animals.toml" --set library.file="$work/animals.h5" --out "$work/$name" --quiet
  cat "$name/card.txt"
  cp "$name/pieces.geojson" "$results/$name.geojson"
  cp "$name/collage.png" "$results/$name.png"
}
run_demo() { main_job demo; }

# Two workers share one GPU.
run_two_ranks() {
  main_job two_ranks mpirun -n 3 --oversubscribe --bind-to none
  [[ ! -e demo/pieces.geojson ]] || cmp demo/pieces.geojson two_ranks/pieces.geojson
}

# Only the rounds: kernels, copies, waits.
run_profile() {
  need_library
  LD_PRELOAD=$bundle/lib/libopencl_profile.so tessera collage "$bundle/jobs/animals.toml" \
    --set library.file="$work/animals.h5" --set improve.trials=0 --out "$work/profile" --quiet
}

large_library() {
  need_library
  tessera bench library --library "$work/animals.h5" --sizes "$1" --out "$results/library_$1.json"
}
run_library_10000() { large_library 10000; }
run_library_100000() { large_library 100000; }

run_table2() {
  need_library
  tessera bench table2 --library "$work/animals.h5" --out "$results/table2.json"
}

minutes=5 only='' bundle='' out='' running='' failed=0 table=()
read_arguments "$@"
mkdir -p "$out" || exit 2
out=$(readlink -f "$out")
[[ ! -e $bundle ]] || bundle=$(readlink -f "$bundle")
work=$(mktemp -d)
results=$work/results
mkdir -p "$results/logs"
ends=$((SECONDS + minutes * 60))
trap 'rm -rf "$work"' EXIT
open_bundle
trap finish EXIT
trap 'exit 3' INT TERM
: >"$out/gpu-check.log"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 RC_PARAMS=seed=2016
export work bundle results
# shellcheck disable=SC2046
export -f $(declare -F | awk '$3 ~ /^run_|^main_job$|^large_library$|^need_library$|^vendor_opencl$/ { print $3 }')
cd "$work" || exit 1

for line in "${plan[@]}"; do
  read -r name limit <<<"$line"
  if [[ -n $only && $name != facts && $name != devices && ,$only, != *,$name,* ]]; then continue; fi
  ((minutes <= 5)) || limit=$((limit * minutes / 5))
  check "$name" "$limit"
  said=$results/logs/devices.log
  if [[ $name == devices && -e $said ]] && ! grep -qE ': (gpu|cpu|accelerator) "' "$said"; then
    table+=("There is no OpenCL device on this machine. With pocl.tar.xz unpacked, too, its CPU is one.")
    exit 1
  fi
done
exit $failed
