#!/usr/bin/env bash
# checked_kernels_test.sh memcheck|helgrind TEST_KERNELS TEST_PAIR_SEARCH TEST_OPENCL_RUNTIME NEW_FOLDER: runs every kernel on PoCL under
# valgrind, which observes the compiled kernels.
# memcheck finds reads beyond buffers and of uninitialised data. helgrind finds work items of two threads at the same place.
# The kernels must also give the reference's bits, here on a CPU without AVX-512, which valgrind does not support.
# Faulty kernels show that both tools find faults.
# Work items for lanes are left out except for the building blocks: PoCL would need longer to compile them than for all the rest.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tool=$1 test_kernels=$2 test_pair_search=$3 test_opencl_runtime=$4 folder=$5

rm -rf "$folder"
mkdir -p "$folder/pocl"
export POCL_CACHE_DIR=$folder/pocl  # the kernels for this other CPU

# checked LOG COMMAND...: fails if valgrind reports anything.
# --fair-sched gives threads their turns. Without it one thread may run all work items while the others wait for valgrind's lock, which
# hides a race.
checked() {
  local log=$1
  shift
  valgrind --tool="$tool" --fair-sched=yes --suppressions="$here/valgrind.supp" --error-exitcode=99 \
    --log-file="$log" "$@"
}

# found FAULT: succeeds if valgrind reports the faulty kernel of that name.
found() {
  local log=$folder/$1.log
  export TESSERA_TEST_FAULTY=1
  if checked "$log" "$test_opencl_runtime" --gtest_filter="Faulty.$1" >"$folder/$1.txt" 2>&1; then
    echo "$tool does not find the fault of Faulty.$1" >&2
    return 1
  fi
  grep -q 'ERROR SUMMARY: [1-9]' "$log" || { echo "Faulty.$1 ends, but not by a fault:" >&2; cat "$log" >&2; return 1; }
  unset TESSERA_TEST_FAULTY
}

case $tool in
  memcheck)
    found ReadsBeyondItsBuffer
    found DecidesByWhatNobodyWrote
    ;;
  helgrind) found TwoItemsWriteTheSamePlace ;;
  *) echo "no such tool: $tool" >&2; exit 2 ;;
esac

for run in "$test_kernels --gtest_filter=*Kernels.*:*seed1vectors:*seed2vectors" "$test_pair_search"; do
  log=$folder/$(basename "${run%% *}").log
  # shellcheck disable=SC2086  # a command and its argument
  if ! checked "$log" $run >"$folder/output.txt" 2>&1; then
    tail -n 40 "$folder/output.txt" "$log" >&2
    exit 1
  fi
done
