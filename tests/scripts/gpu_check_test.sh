#!/usr/bin/env bash
# gpu_check_test.sh: runs scripts/gpu-check.sh on a bundle of replacement programs. It checks which checks run, the effects of a failure, a
# hang and the time limit, the table, and the exit codes.
# shellcheck disable=SC2016  # the stand-ins expand their variables themselves
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1

sandbox=$(mktemp -d)
trap 'rm -rf "$sandbox"' EXIT
bundle=$sandbox/bundle
mkdir -p "$bundle"/{bin,lib,tests/golden,jobs,animals}
cp scripts/bundle-env.sh "$bundle/env.sh"
echo 0123abc >"$bundle/commit.txt"

stand_in() {  # FILE, script on standard input
  { echo '#!/bin/bash'; cat; } >"$bundle/$1"
  chmod +x "$bundle/$1"
}
stand_in bin/tessera <<'END'
case $1 in
  devices)
    [[ ! -e $bundle/no_devices ]] || { echo "tessera: no OpenCL platform is installed" >&2; exit 1; }
    echo 'platform "Stand-in"'
    echo "  0: gpu \"Card\", driver 1$(cat "$bundle/hindrance" 2>/dev/null)"
    ;;
  library) touch animals.h5 ;;
  collage)
    while [[ $1 != --out ]]; do shift; done
    mkdir -p "$2"
    echo "  coverage  88 %" >"$2/card.txt"
    echo "${RANKS:-}" >"$2/pieces.geojson"
    touch "$2/collage.png"
    ;;
  bench) for i in {1..40}; do echo "device, line $i"; done ;;
esac
END
stand_in bin/mpirun <<'END'
while [[ $1 != tessera ]]; do shift; done
RANKS=$(cat "$bundle/ranks" 2>/dev/null) exec "$@"
END
for test in arithmetic_probe kernels pair_search opencl_runtime device_memory stored_matching device_room device_speed \
  opencl_devices opencl_matcher; do
  stand_in tests/test_$test <<<'exit 0'
done
stand_in tests/golden/golden_test.sh <<<'echo 14 jobs'
touch "$bundle/tests/golden_inputs" "$bundle/lib/libopencl_profile.so" "$bundle/jobs/animals.toml"
sed 's/"test_pair_search 90"/"test_pair_search 5"/' scripts/gpu-check.sh >"$bundle/gpu-check.sh"

# check ARGUMENT...: puts the output and the exit code into variables.
check() {
  code=0
  said=$(PATH=$PATH:/usr/sbin bash "$bundle/gpu-check.sh" "$@" 2>&1) || code=$?
}
# expect CODE WHAT PATTERN...: the output matches each PATTERN; "!PATTERN" must not match.
expect() {
  local what=$2 pattern
  [[ $code == "$1" ]] || { echo "FAILED $what: exit code $code, not $1"; echo "$said"; exit 1; }
  shift 2
  for pattern; do
    if [[ $pattern == !* ]]; then
      ! grep -qE -- "${pattern#!}" <<<"$said" || { echo "FAILED $what: ${pattern#!}"; echo "$said"; exit 1; }
    else
      grep -qE -- "$pattern" <<<"$said" || { echo "FAILED $what: no $pattern"; echo "$said"; exit 1; }
    fi
  done
}

check --help
expect 0 help '^gpu-check.sh BUNDLE OUT' 'Exit code: 0' 'golden'
check "$bundle"
expect 2 'one argument' 'takes a bundle and a folder'
for minutes in 0 1.5 -1 x '' 99999; do
  check "$bundle" "$sandbox/out" --minutes "$minutes"
  expect 2 "--minutes '$minutes'" 'whole minutes'
done
check "$bundle" "$sandbox/out" --only golden,gulden
expect 2 'a name that is none' "no check 'gulden'"
check "$bundle" "$sandbox/out" --fast
expect 2 'an option that is none' 'unknown option --fast'
check "$sandbox" "$sandbox/out"
expect 2 'no bundle' 'is no bundle'

check "$bundle" "$sandbox/out"
expect 0 'all pass' 'bundle of commit 0123abc' '^golden +[0-9.]+ s  passed' '^table2 ' ': gpu "Card"' '!FAILED'
lines=$(sed -n '/^Checks on/,$p' <<<"$said" | wc -l)
[[ $lines -gt 22 && $lines -le 60 ]] || { echo "FAILED a table of $lines lines"; exit 1; }
[[ $(ls "$sandbox/out") == $'gpu-check.log\nresults.tar.gz' ]] || { echo "FAILED files: $(ls "$sandbox/out")"; exit 1; }
files=$(tar -tf "$sandbox/out/results.tar.gz")
[[ $files == *results/table.txt* && $files == *results/logs/golden.log* && $files == *results/demo.png* ]] ||
  { echo "FAILED in the archive: $files"; exit 1; }
grep -q '^== golden: .*exit code 0' "$sandbox/out/gpu-check.log" || { echo "FAILED no log of golden"; exit 1; }

tar -C "$sandbox" -cJf "$sandbox/bundle.tar.xz" bundle
check "$sandbox/bundle.tar.xz" "$sandbox/out" --only golden,two_ranks
expect 0 'an archive, some checks' '^devices ' '^golden ' '^two_ranks ' '!^demo ' '!^pairs '

stand_in tests/test_pair_search <<<'sleep 30'
stand_in tests/test_kernels <<<'echo "[  FAILED  ] Kernels.Some"; exit 1'
echo other >"$bundle/ranks"
check "$bundle" "$sandbox/out" --only test_kernels,test_pair_search,golden,demo,two_ranks
expect 3 'a failure, a hang, other bytes' '^test_kernels .*FAILED \(1\): .*Kernels.Some' \
  '^test_pair_search .*FAILED: stopped after 5 s' '^golden .*passed' '^two_ranks .*FAILED.*differ'
grep -q '^[0-9]*: sleep 30' "$sandbox/out/gpu-check.log" || { echo "FAILED the log does not tell what hung"; exit 1; }
! grep -lz "^$sandbox/bundle/tests/test_pair_search" /proc/[0-9]*/cmdline 2>/dev/null ||
  { echo "FAILED what hung is still there"; exit 1; }

stand_in tests/test_kernels <<<'sleep 30'
sed -i 's/minutes \* 60/minutes * 4/' "$bundle/gpu-check.sh"
check "$bundle" "$sandbox/out" --minutes 1 --only test_kernels,golden
expect 3 'the minutes are over' '^test_kernels .*FAILED: stopped' '^golden .*not begun: the minutes are over'
sed -i 's/minutes \* 4/minutes * 60/' "$bundle/gpu-check.sh"

echo ', NOT USABLE: no compiler' >"$bundle/hindrance"
check "$bundle" "$sandbox/out" --only golden
expect 3 'a device that cannot be used' '^devices .*FAILED.*NOT USABLE' '^golden '
touch "$bundle/no_devices"
check "$bundle" "$sandbox/out"
expect 1 'no device' '^There is no OpenCL device' '!^golden'

# env.sh with three kinds of drivers: the machine's list, a driver's library that no list names, and PoCL.
touch "$sandbox/libnvidia-opencl.so.1"
mkdir -p "$bundle/pocl/lib/x86_64-linux-gnu"
# chosen LISTED UNLISTED [VARIABLE=VALUE]: prints what env.sh chooses in that case.
chosen() {
  env -u OCL_ICD_VENDORS "${@:3}" bash -c 'vendors=$1 found=$2
    source <(sed "s#^choose_opencl\$##; s#\${BASH_SOURCE\[0\]}#'"$bundle"'/env.sh#" "'"$bundle"'/env.sh")
    listed_opencl() { [[ -z $vendors ]] || echo "$vendors"; }
    vendor_opencl() { [[ -z $found ]] || echo "$found"; }
    choose_opencl
    echo "${OCL_ICD_VENDORS-}"' _ "$1" "$2"
}
is() { [[ $1 == "$2" ]] || { echo "FAILED env.sh chose '$1', not '$2'"; exit 1; }; }
driver=$sandbox/libnvidia-opencl.so.1
pocl=$bundle/pocl/lib/x86_64-linux-gnu/libpocl.so.2
is "$(chosen libnvidia-opencl.so.1 "$driver")" ''
is "$(chosen libMesaOpenCL.so.1 "$driver")" "$driver"
is "$(chosen '' "$driver")" "$driver"
is "$(chosen '' '')" "$pocl"
is "$(chosen libMesaOpenCL.so.1 '')" ''
is "$(chosen '' "$driver" BUNDLE_POCL=1)" "$pocl"
is "$(chosen '' "$driver" OCL_ICD_VENDORS=/mine)" /mine
echo "ok gpu-check"
