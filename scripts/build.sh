#!/usr/bin/env bash
# scripts/build.sh [--preset NAME] [--without-tests] [TARGET...]: configures and builds a CMake preset (default: release, all targets).
#   --without-tests  does not configure tests, so their packages may be missing. A build folder that already has tests keeps them.
# Without the tests in its rules, CMake would remove their built files.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=release
if [[ ${1-} == --preset ]]; then
  preset=${2:?--preset needs a name: release, debug or asan-ubsan}
  shift 2
fi

tests=ON
if [[ ${1-} == --without-tests ]]; then
  shift
  # A failed configuration leaves a cache, but no rules.
  folder=build/$preset
  [[ -e $folder/build.ninja ]] && grep -qx TESSERA_BUILD_TESTS:BOOL=ON "$folder/CMakeCache.txt" || tests=OFF
fi

log=build/$preset/configure.log
mkdir -p "$(dirname "$log")"
started=$SECONDS
if ! cmake --preset "$preset" -DTESSERA_BUILD_TESTS="$tests" >"$log" 2>&1; then
  cat "$log" >&2
  exit 1
fi
if [[ $# -gt 0 ]]; then
  cmake --build --preset "$preset" --target "$@"
else
  cmake --build --preset "$preset"
fi
echo "Built build/$preset in $((SECONDS - started)) s."
