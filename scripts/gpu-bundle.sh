#!/usr/bin/env bash
# scripts/gpu-bundle.sh FOLDER [--without-pocl]: the program for machines on which nothing can be installed
# (docs/bundle.md). FOLDER/bundle.tar.xz: programs with all that they need besides the C library and a device's OpenCL
# library, Open MPI with its plug-ins, kernel tests, golden jobs, drawings, a job and gpu-check.sh. FOLDER/pocl.tar.xz:
# PoCL with its compiler, for machines without OpenCL. Both unpack into the folder "bundle".
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() { sed -n '2,5s/^# //p' "scripts/${BASH_SOURCE[0]##*/}"; }

with_pocl=yes
arguments=()
for argument; do
  case $argument in
    -h | --help) usage; exit 0 ;;
    --without-pocl) with_pocl=no ;;
    -*) echo "gpu-bundle.sh: unknown option $argument" >&2; exit 2 ;;
    *) arguments+=("$argument") ;;
  esac
done
[[ ${#arguments[@]} -eq 1 ]] || { usage >&2; exit 2; }

readonly build=build/release
readonly system=/usr/lib/x86_64-linux-gnu
readonly kernel_tests=(test_arithmetic_probe test_kernels test_pair_search test_opencl_runtime test_device_memory
  test_device_room test_device_speed test_opencl_devices test_opencl_matcher test_stored_matching)
readonly drawings=/usr/share/openclipart/svg/animals

check_parts() {
  local test missing=() needed=("$build/src/cli/tessera" "$build/src/cli/tessera-drawer"
    "$build/src/cli/tessera-bench" "$build/bench/libopencl_profile.so" "$build/tests/golden/golden_inputs")
  for test in "${kernel_tests[@]}"; do needed+=("$build/tests/worker/$test"); done
  for test in "${needed[@]}"; do [[ -e $test ]] || missing+=("$test"); done
  if [[ ${#missing[@]} -gt 0 ]]; then
    echo "gpu-bundle.sh: not built: ${missing[*]}; scripts/build.sh builds all" >&2
    exit 1
  fi
  [[ -d $drawings ]] || { echo "gpu-bundle.sh: no $drawings: install openclipart-svg" >&2; exit 1; }
}
check_parts

mkdir -p "${arguments[0]}"
folder=$(readlink -f "${arguments[0]}")
readonly folder
work=$(mktemp -d "$folder/gpu-bundle.XXXXXX")
trap 'rm -rf "$work"' EXIT

# libraries_of FILE...: prints the libraries that the files load, one path a line, without the parts of glibc.
libraries_of() {
  ldd "$@" | awk '$2 == "=>" && $3 ~ /^\// { print $3 }' | sort -u |
    grep -vE '/(ld-linux[^/]*|lib(c|m|dl|rt|pthread|resolv|util|nsl|mvec|anl)\.so[^/]*)$' || true  # there may be none
}

# copy_libraries INTO [UNLESS_IN] -- FILE...: copies the libraries of each file, except those in one of the folders.
copy_libraries() {
  local into=$1 also=$1 file library
  shift
  [[ $1 == -- ]] || { also=$1; shift; }
  shift
  # The files are handled one by one. If a library is replaced, the loader does not see what the original one needs.
  for file; do
    while read -r library; do
      [[ -e $into/${library##*/} || -e $also/${library##*/} ]] || cp -L "$library" "$into/"
    done < <(LD_LIBRARY_PATH=$into libraries_of "$file")
  done
}

# xz_archive ARCHIVE FOLDER: packs the folder "bundle" in FOLDER.
xz_archive() {
  tar -C "$2" --sort=name --owner=0 --group=0 --numeric-owner -c bundle | xz -T0 -6 >"$1.new"
  mv "$1.new" "$1"
  echo "$1: $(($(stat -c %s "$1") / 1000000)) MB"
}

# strip_all FOLDER...
strip_all() {
  find "$@" -type f \( -perm -100 -o -name '*.so*' \) -exec sh -c 'strip --strip-unneeded "$1" 2>/dev/null' _ {} \;
}

# stand_in_for_icu_data INTO: replaces ICU's tables, which take 31 MB. libxml2 asks ICU for encodings that glibc's iconv does not know.
# The replacement is an empty table in ICU's own form ("stubdata"), with which ICU says that it knows no encoding.
stand_in_for_icu_data() {
  cat >"$work/icu_data.c" <<'END'
#include <unicode/udata.h>
struct {
  uint16_t header_size;
  uint8_t magic1, magic2;
  UDataInfo info;
  char padding[8];
  uint32_t count, reserved;
  int32_t no_name_and_data[4];
} const icudt72_dat = {32, 0xda, 0x27, {sizeof(UDataInfo), 0, 0, 0, 2, 0, {'T', 'o', 'C', 'P'}, {1, 0, 0, 0}, {0}},
                       {0}, 0, 0, {0}};
END
  gcc -shared -fPIC -Wl,-soname,libicudata.so.72 -o "$1/libicudata.so.72" "$work/icu_data.c"
}

# copy_open_mpi TO: copies Open MPI, which finds its plug-ins under OPAL_PREFIX in the folders of Debian's packages.
# It leaves out those of networks other than TCP, whose drivers a bundle cannot bring, and those of OpenSHMEM.
copy_open_mpi() {
  local to=$1 plug_ins=lib/x86_64-linux-gnu/openmpi/lib/openmpi3 pmix=lib/x86_64-linux-gnu/pmix2/lib/pmix
  mkdir -p "$to/$plug_ins" "$to/$pmix" "$to/share"
  cp -L /usr/bin/mpirun /usr/bin/orted "$to/bin/"
  cp /usr/$plug_ins/mca_*.so "$to/$plug_ins/"
  rm -f "$to/$plug_ins"/mca_*_{ofi,ucx,psm*,usnic,cuda,portals4,openib}.so
  rm -f "$to/$plug_ins"/mca_{atomic,memheap,scoll,spml,sshmem}_*.so
  cp /usr/$pmix/*.so "$to/$pmix/"
  cp -r /usr/share/openmpi "$to/share/"
  cp -rL $system/pmix2/share/pmix "$to/share/"
}

# copy_fonts TO: copies one font, for machines without fonts. Without any font, the silhouettes of drawings with text would differ from run
# to run.
copy_fonts() {
  mkdir -p "$1/share/fonts"
  cp /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf "$1/share/fonts/"
  cat >"$1/share/fonts/fonts.conf" <<'END'
<?xml version="1.0"?>
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig>
  <dir prefix="relative">.</dir>
  <cachedir prefix="xdg">fontconfig</cachedir>
</fontconfig>
END
}

make_main() {
  local to=$work/main/bundle test
  mkdir -p "$to"/{bin,lib,tests/golden,jobs,out}
  cp $build/src/cli/tessera{,-drawer,-bench} "$to/bin/"
  copy_open_mpi "$to"
  copy_fonts "$to"
  for test in "${kernel_tests[@]}"; do cp "$build/tests/worker/$test" "$to/tests/"; done
  cp -r tests/golden/jobs tests/golden/digests.txt tests/golden/golden_test.sh "$to/tests/golden/"
  cp -r tests/support "$to/tests/"
  cp $build/tests/golden/golden_inputs "$to/tests/"
  cp $build/bench/libopencl_profile.so "$to/lib/"
  stand_in_for_icu_data "$to/lib"
  copy_libraries "$to/lib" -- "$to"/bin/* "$to"/tests/test_* "$to/tests/golden_inputs" \
    "$to"/lib/x86_64-linux-gnu/openmpi/lib/openmpi3/*.so "$to"/lib/x86_64-linux-gnu/pmix2/lib/pmix/*.so
  strip_all "$to/bin" "$to/tests" "$to/lib"
  cp -r $drawings "$to/"
  cp jobs/animals.toml "$to/jobs/"
  cp LICENSE "$to/"
  cp docs/bundle.md "$to/README.md"
  cp scripts/gpu-check.sh "$to/"
  cp scripts/bundle-env.sh "$to/env.sh"
  git rev-parse HEAD >"$to/commit.txt" 2>/dev/null || echo unknown >"$to/commit.txt"
  xz_archive "$folder/bundle.tar.xz" "$work/main"
}

# PoCL looks for ../../share/pocl from its own folder, and calls `ld` from PATH with the usual folders.
# On a machine without a compiler, a wrapper gives ld the files to link against. It takes the shared parts of the C library from the
# machine.
make_pocl() {
  local to=$work/pocl/bundle/pocl lib
  lib=$to/lib/x86_64-linux-gnu
  mkdir -p "$to"/{bin,share/pocl,link} "$lib"
  cp -L $system/libpocl.so.2 "$lib/"
  cp -r $system/pocl "$lib/"
  cp -L /usr/bin/x86_64-linux-gnu-ld.bfd "$to/bin/ld.bfd"
  copy_libraries "$lib" "$work/main/bundle/lib" -- $system/libpocl.so.2 $system/pocl/*.so "$to/bin/ld.bfd"
  cp -r /usr/share/pocl/include "$to/share/pocl/"
  cp /usr/share/pocl/kernel-x86_64-pc-linux-gnu-avx{2,512}.bc "$to/share/pocl/"  # these fit the CPU of any server since 2013
  cp "$(gcc -print-libgcc-file-name)" $system/libc_nonshared.a "$to/link/"
  strip --strip-debug "$to/link/libgcc.a"
  echo 'GROUP ( libgcc_s.so.1 -lgcc )' >"$to/link/libgcc_s.so"
  echo 'GROUP ( libm.so.6 AS_NEEDED ( libmvec.so.1 ) )' >"$to/link/libm.so"
  echo 'GROUP ( libc.so.6 libc_nonshared.a AS_NEEDED ( ld-linux-x86-64.so.2 ) )' >"$to/link/libc.so"
  cat >"$to/bin/ld" <<'END'
#!/bin/sh
# For PoCL: ld, where the machine has no folder of a compiler to link against.
pocl=$(dirname "$(dirname "$(readlink -f "$0")")")
exec "$pocl/bin/ld.bfd" -L"$pocl/link" "$@" -L"$pocl/../lib" -L/lib64 -L/usr/lib64
END
  chmod +x "$to/bin/ld"
  strip_all "$to/bin" "$lib"
  xz_archive "$folder/pocl.tar.xz" "$work/pocl"
}

make_main
[[ $with_pocl == no ]] || make_pocl
