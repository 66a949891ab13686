#!/usr/bin/env bash
# scripts/gpu-bundle.sh FOLDER: makes FOLDER/bundle.tar.xz, the program with all that it needs besides the C library
# (glibc 2.36 or newer) and a device's OpenCL library, for a machine on which nothing can be installed: programs,
# libraries, Open MPI with its plug-ins, kernel tests, golden jobs, a small library with its drawings, jobs and
# scripts/gpu-check.sh. Also FOLDER/pocl.tar.xz: PoCL with its compiler, where the machine has no OpenCL of its own.
# Both unpack into the folder "bundle". Needs the release build with its tests (scripts/build.sh).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

[[ $# -eq 1 && $1 != -* ]] || { echo "usage: scripts/gpu-bundle.sh FOLDER" >&2; exit 2; }
readonly build=build/release
readonly system=/usr/lib/x86_64-linux-gnu
mkdir -p "$1"
folder=$(readlink -f "$1")
readonly folder
work=$(mktemp -d "$folder/gpu-bundle.XXXXXX")
trap 'rm -rf "$work"' EXIT

readonly kernel_tests=(test_arithmetic_probe test_kernels test_pair_search test_opencl_runtime test_device_memory test_device_room
  test_device_speed test_opencl_devices test_opencl_matcher test_stored_matching)

# libraries_of FILE...: what they load, one path a line, without the parts of glibc.
libraries_of() {
  ldd "$@" | awk '$2 == "=>" && $3 ~ /^\// { print $3 }' | sort -u |
    grep -vE '/(ld-linux[^/]*|lib(c|m|dl|rt|pthread|resolv|util|nsl|mvec|anl)\.so[^/]*)$' || true  # nothing
}

# copy_libraries INTO FILE...
copy_libraries() {
  local into=$1 library
  shift
  while read -r library; do
    [[ -e $into/${library##*/} || -e $work/main/bundle/lib/${library##*/} ]] || cp -L "$library" "$into/"
  done < <(libraries_of "$@")
}

# xz_archive ARCHIVE FOLDER: the folder "bundle" in it.
xz_archive() {
  tar -C "$2" --sort=name --owner=0 --group=0 --numeric-owner -c bundle | xz -T0 -${xz_level:-9} >"$1.new"
  mv "$1.new" "$1"
  echo "$1: $(($(stat -c %s "$1") / 1000000)) MB"
}

# stub_gdal LIB: OpenCV's imgcodecs names functions of GDAL, which brings 100 MB of libraries and reads maps, which
# nobody here does. Functions that find nothing stand in for them; libraries that GDAL alone needs are left out.
stub_gdal() {
  local codecs=$system/libopencv_imgcodecs.so.406 symbols stub=$work/stub.c
  symbols=$(comm -12 <(nm -D --undefined-only "$codecs" | awk '{ print $2 }' | sort) \
    <(nm -D --defined-only $system/libgdal.so.32 | awk '{ print $3 }' | sort))
  {
    awk '{ printf "void *f%d(void) __asm__(\"%s\"); void *f%d(void) { return 0; }\n", NR, $1, NR }' <<<"$symbols"
  } >"$stub"
  gcc -shared -fPIC -Wl,-soname,libgdal.so.32 -o "$1/libgdal.so.32" "$stub"
  local needed=("$to"/bin/* "$to"/tests/test_* "$to/tests/golden_inputs" "$to/$plug_ins"/*.so
    "$to"/lib/x86_64-linux-gnu/pmix2/lib/pmix/*.so) file
  # With the stub in GDAL's place ldd does not meet what GDAL needs.
  for file in "${needed[@]}"; do LD_LIBRARY_PATH=$1 libraries_of "$file"; done | sort -u |
    while read -r file; do [[ -e $1/${file##*/} ]] || cp -L "$file" "$1/"; done
}

make_main() {
  local to=$work/main/bundle
  mkdir -p "$to"/{bin,lib,tests,share,jobs,out}
  cp $build/src/cli/tessera $build/src/cli/tessera-drawer "$to/bin/"
  cp -L /usr/bin/mpirun "$to/bin/"
  cp -L /usr/bin/orted "$to/bin/"
  local test
  for test in "${kernel_tests[@]}"; do cp "$build/tests/worker/$test" "$to/tests/"; done
  mkdir -p "$to/tests/golden"
  cp -r tests/golden/jobs tests/golden/digests.txt tests/golden/golden_test.sh "$to/tests/golden/"
  cp -r tests/support "$to/tests/"
  cp $build/tests/golden/golden_inputs "$to/tests/"
  # Open MPI finds its plug-ins under OPAL_PREFIX, in the folders of Debian's packages.
  local plug_ins=lib/x86_64-linux-gnu/openmpi/lib/openmpi3
  mkdir -p "$to/$plug_ins" "$to/lib/x86_64-linux-gnu/pmix2/lib"
  cp /usr/$plug_ins/*.so "$to/$plug_ins/"
  rm -f "$to/$plug_ins"/*_{ofi,ucx,psm*,usnic,cuda,portals4}.so  # of networks that one machine has not
  cp -r $system/pmix2/lib/pmix "$to/lib/x86_64-linux-gnu/pmix2/lib/"
  cp -r /usr/share/openmpi "$to/share/"
  [[ ! -d /usr/share/pmix ]] || cp -r /usr/share/pmix "$to/share/"
  stub_gdal "$to/lib"
  # For programs and libraries alike: their libraries lie in lib.
  find "$to/bin" "$to/tests" "$to/lib" -type f \( -perm -100 -o -name '*.so*' \) -exec strip --strip-unneeded {} + 2>/dev/null || true
  cp -r /usr/share/openclipart/svg/animals "$to/"
  cp jobs/animals.toml "$to/jobs/"
  cp scripts/gpu-check.sh scripts/gpu-env.sh "$to/"
  git rev-parse HEAD >"$to/commit.txt"
  xz_archive "$folder/bundle.tar.xz" "$work/main"
}

make_pocl() {
  local to=$work/pocl/bundle/pocl
  mkdir -p "$to"/{lib,share,vendors,bin}
  cp -L $system/libpocl.so.2 "$to/lib/"
  cp -r $system/pocl "$to/lib/"
  copy_libraries "$to/lib" $system/libpocl.so.2 $system/pocl/*.so
  cp -r /usr/share/pocl "$to/share/"
  xz_archive "$folder/pocl.tar.xz" "$work/pocl"
}

make_main
[[ -n ${no_pocl-} ]] || make_pocl
