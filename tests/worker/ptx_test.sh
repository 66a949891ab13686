#!/usr/bin/env bash
# ptx_test.sh KERNEL_PROGRAM FOLDER: compiles the kernels to NVIDIA's PTX with Debian's clang and libclc.
# For any match.levels there must be no fused and no approximate operation.
# If ptxas is there, it also checks registers, spills and stack for an H100.
set -euo pipefail
kernel_program=$1 folder=$2

readonly library=/usr/lib/clc/nvptx64--nvidiacl.bc
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
"$kernel_program" .
fail() {
  echo "FAILED $1"
  exit 1
}

# libclc's get_global_id ignores the offset that NVIDIA's OpenCL puts into these registers.
cat >global_id.h <<'END'
static size_t tessera_global_id(uint d) {
  uint offset = 0;
  if (d == 0) __asm("mov.u32 %0, %%envreg3;" : "=r"(offset));
  if (d == 1) __asm("mov.u32 %0, %%envreg4;" : "=r"(offset));
  return (uint)get_group_id(d) * (uint)get_local_size(d) + (uint)get_local_id(d) + offset;
}
#define get_global_id tessera_global_id
END
kernels=$(grep -oE '^([A-Z]+_KERNEL|kernel)\b.*void [a-z_]+' kernels.cl | awk '{ print $NF }' | paste -sd,)

# ptx LEVELS OUT OPTION...: -cl-std is clang's own option; OPTION sets the rounding.
ptx() {
  local levels=$1 out=$2 defines
  shift 2
  read -ra defines < <(sed 's/-cl-[^ ]*//g' "options_$levels.txt")
  clang-15 -x cl -cl-std=CL1.2 -D__OPENCL_VERSION__=120 -target nvptx64-nvidia-nvcl -Xclang -finclude-default-header \
    -O3 -include global_id.h "$@" -emit-llvm -c "${defines[@]}" -o kernels.bc kernels.cl
  llvm-link-15 -suppress-warnings kernels.bc $library -o linked.bc
  opt-15 -passes='internalize,default<O3>' -internalize-public-api-list="$kernels" linked.bc -o optimised.bc
  llc-15 -mcpu=sm_70 -O3 "${contraction[@]}" optimised.bc -o "$out"
}

# inexact PTX: prints the operations that may give other bits. Without .rn, ptxas may fuse a product and a sum.
inexact() {
  local fused='(fma|mad)\.[a-z.]*f(32|64)' fusible='(add|sub|mul)\.f(32|64)' flushed='[a-z]+\.[a-z.]*ftz[a-z0-9.]*'
  local approximate='(div|sqrt|rcp|rsqrt|sin|cos|ex2|lg2|tanh)\.(approx|full)[a-z0-9.]*'
  grep -oE "\b($fused|$fusible|$flushed|$approximate)" "$1" | sort | uniq -c
}

contraction=()
exact=(-ffp-contract=off -Xclang -cl-fp32-correctly-rounded-divide-sqrt)
for options in options_*.txt; do
  levels=${options//[!0-9]/}
  ptx "$levels" "$levels.ptx" "${exact[@]}"
  found=$(inexact "$levels.ptx" || true)
  [[ -z $found ]] || fail "match.levels = $levels: $found"
  [[ $(grep -c '\.entry ' "$levels.ptx") == "$(tr , '\n' <<<"$kernels" | wc -l)" ]] || fail "kernels are missing"
done
# The search must find such operations in a careless build.
contraction=(-fp-contract=fast -nvptx-prec-divf32=0)
ptx 5 careless.ptx -ffp-contract=fast
found=$(inexact careless.ptx || true)
[[ $found == *fma.rn.f32* && $found == *add.f32* && $found == *div.approx* ]] ||
  fail "careless code looks exact: $found"

ptxas=$(PATH=$PATH:/usr/local/cuda/bin command -v ptxas || true)
[[ -n $ptxas ]] || { echo "no ptxas: not looked at"; exit; }
"$ptxas" -v -arch=sm_90 5.ptx -o 5.cubin 2>ptxas.txt || fail "$(cat ptxas.txt)"
awk '/Compiling entry function/ { split($0, words, "\047"); name = words[2] }
  /bytes stack frame/ { stack = $1; spills = $5 + $9 }
  /Used [0-9]+ registers/ { match($0, /Used [0-9]+/); print name, substr($0, RSTART + 5, RLENGTH - 5), stack, spills }' \
  ptxas.txt >used.txt
echo "kernel, registers, bytes of stack, bytes of spills:"
cat used.txt
[[ $(wc -l <used.txt) == "$(tr , '\n' <<<"$kernels" | wc -l)" ]] || fail "ptxas says: $(cat ptxas.txt)"
# With 128 registers a multiprocessor has room for 16 warps.
awk '$2 > 128 || $3 > 512 || $4 > 0 { print "FAILED too much:", $0; failed = 1 } END { exit failed }' used.txt
