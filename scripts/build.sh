#!/usr/bin/env bash
# scripts/build.sh [--preset NAME] [TARGET...]: configures and builds a CMake preset (default: release, all targets).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=release
if [[ ${1-} == --preset ]]; then
  preset=${2:?--preset needs a name: release, debug or asan-ubsan}
  shift 2
fi

log=build/$preset/configure.log
mkdir -p "$(dirname "$log")"
started=$SECONDS
if ! cmake --preset "$preset" >"$log" 2>&1; then
  cat "$log" >&2
  exit 1
fi
if [[ $# -gt 0 ]]; then
  cmake --build --preset "$preset" --target "$@"
else
  cmake --build --preset "$preset"
fi
echo "Built build/$preset in $((SECONDS - started)) s."
