#!/usr/bin/env bash
# Every script of the repository parses; shellcheck warns of nothing in it, where shellcheck is installed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

scripts=(scripts/*.sh slurm/*.s* tests/*/*.sh .ci/run)
for script in "${scripts[@]}"; do
  bash -n "$script"
done
if command -v shellcheck >/dev/null; then
  shellcheck --external-sources --severity=warning "${scripts[@]}"
fi
echo "${#scripts[@]} scripts checked"
