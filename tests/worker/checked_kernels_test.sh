#!/usr/bin/env bash
# checked_kernels_test.sh memcheck|helgrind TEST_KERNELS TEST_PAIR_SEARCH TEST_OPENCL_RUNTIME NEW_FOLDER: every kernel
# runs on PoCL under valgrind, which sees what the compiled kernels do: reads beyond buffers and of what nobody wrote
# (memcheck), work items of two threads at the same place (helgrind). That they still give the reference's bits is
# seen on the way, on a CPU without AVX-512, as valgrind has none. Faulty kernels show that faults are found. Work items
# for lanes are left out but for the building blocks: to compile all of them takes PoCL longer there than all the rest.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tool=$1 test_kernels=$2 test_pair_search=$3 test_opencl_runtime=$4 folder=$5

rm -rf "$folder"
mkdir -p "$folder/pocl"
export POCL_CACHE_DIR=$folder/pocl  # kernels for this other CPU

# checked LOG COMMAND...: fails where valgrind has anything to say.
# Threads get their turns by --fair-sched: without it one may do all work items while the others wait for valgrind's lock,
# and there is no race to be seen.
checked() {
  local log=$1
  shift
  valgrind --tool="$tool" --fair-sched=yes --suppressions="$here/valgrind.supp" --error-exitcode=99 \
    --log-file="$log" "$@"
}

# found FAULT: whether valgrind tells of the faulty kernel of that name.
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
