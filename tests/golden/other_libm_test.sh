#!/usr/bin/env bash
# other_libm_test.sh LIBM_BITS TESSERA GOLDEN_INPUTS NEW_FOLDER: runs golden_test.sh with libm as on a CPU without FMA and AVX2.
# There libm rounds some functions differently, and no decision about a collage may depend on them.
# If the functions give the same bits here either way, the jobs would show nothing, and the test is skipped.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
libm_bits=$1
shift
other=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F,-AVX512VL

usual_bits=$("$libm_bits")
other_bits=$(GLIBC_TUNABLES=$other "$libm_bits")
differing=$(comm -13 <(sort <<<"$usual_bits") <(sort <<<"$other_bits") | cut -d ' ' -f 1 | xargs)
if [[ -z $differing ]]; then
  echo "SKIPPED: GLIBC_TUNABLES=$other changes no bit of libm's functions here, so that the jobs would show nothing."
  exit 77
fi
echo "libm gives other bits for: $differing"
GLIBC_TUNABLES=$other "$here/golden_test.sh" "$@"
