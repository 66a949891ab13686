#!/usr/bin/env bash
# rusticl_test.sh TEST_KERNELS TEST_PAIR_SEARCH TEST_OPENCL_RUNTIME TEST_DEVICE_MEMORY TEST_OPENCL_MATCHER CACHE_FOLDER:
# the kernels on another OpenCL implementation than PoCL: Mesa's rusticl with its CPU driver llvmpipe (Debian:
# mesa-opencl-icd), whose compiler makes SPIR-V and NIR of them and vectors over work items of 256 bits. The bits must be
# the reference's there, too. It says that it does neither divide with correct rounding nor know denormal numbers, and
# does both; jobs refuse it for what it says, so only those tests run that take the first device as it is.
set -euo pipefail
test_kernels=$1 test_pair_search=$2 test_opencl_runtime=$3 test_device_memory=$4 test_opencl_matcher=$5 folder=$6

export OCL_ICD_VENDORS=/etc/OpenCL/vendors/rusticl.icd  # and no other implementation
export RUSTICL_ENABLE=llvmpipe
[[ -e $OCL_ICD_VENDORS ]] || { echo "no $OCL_ICD_VENDORS: apt-get install mesa-opencl-icd"; exit 77; }
mkdir -p "$folder"
export MESA_SHADER_CACHE_DIR=$folder  # compiling takes most of the first run

"$test_kernels"
"$test_pair_search"
"$test_opencl_runtime"
"$test_device_memory"
"$test_opencl_matcher" --gtest_filter='*/LittleRoom:OpenCLMatcher.CountsInSteps'
