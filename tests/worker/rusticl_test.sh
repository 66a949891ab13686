#!/usr/bin/env bash
# rusticl_test.sh TEST_KERNELS TEST_PAIR_SEARCH TEST_OPENCL_RUNTIME TEST_DEVICE_MEMORY TEST_OPENCL_MATCHER TESSERA GOLDEN_INPUTS
# CACHE_FOLDER: runs the kernels on an OpenCL implementation other than PoCL.
# This is Mesa's rusticl with its CPU driver llvmpipe (Debian: mesa-opencl-icd). Its compiler turns them into SPIR-V, NIR and vectors over
# work items of 256 bits.
# The bits must equal the reference's there, too.
# rusticl reports neither correctly rounded divisions nor denormal numbers, but has both. Jobs accept it for its results, and one golden job
# must have the same digest as on PoCL.
set -euo pipefail
test_kernels=$1 test_pair_search=$2 test_opencl_runtime=$3 test_device_memory=$4 test_opencl_matcher=$5
tessera=$6 golden_inputs=$7 folder=$8
golden=$(cd "$(dirname "${BASH_SOURCE[0]}")/../golden" && pwd)

export OCL_ICD_VENDORS=/etc/OpenCL/vendors/rusticl.icd  # hides all other implementations
export RUSTICL_ENABLE=llvmpipe
[[ -e $OCL_ICD_VENDORS ]] || { echo "FAILED no $OCL_ICD_VENDORS: scripts/install-packages.sh tests"; exit 1; }
mkdir -p "$folder"
export MESA_SHADER_CACHE_DIR=$folder  # compiling takes most of the first run

"$test_kernels"
"$test_pair_search"
"$test_opencl_runtime"
"$test_device_memory"
"$test_opencl_matcher" --gtest_filter='*/LittleRoom:OpenCLMatcher.CountsInSteps'

rm -rf "$folder/job"
mkdir "$folder/job"
"$golden_inputs" "$folder/job"
cp "$golden/jobs/plain.toml" "$folder/job/"
"$tessera" collage "$folder/job/plain.toml" --out "$folder/job/plain" --quiet 2>&1 |
  grep -v 'drawn as silhouettes' || true
digest=$(sha256sum <"$folder/job/plain/pieces.geojson")
if ! grep -q "^plain .* ${digest%% *}\$" "$golden/digests.txt"; then
  echo "FAILED the golden job plain: ${digest%% *}"
  exit 1
fi
