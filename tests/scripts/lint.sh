#!/usr/bin/env bash
# Every script of the repository parses, and shellcheck warns of nothing in it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

scripts=(scripts/*.sh slurm/*.s* tests/*/*.sh .ci/run)
for script in "${scripts[@]}"; do
  bash -n "$script"
done
shellcheck --external-sources --severity=warning "${scripts[@]}"
# All of tessera prints through terminal/terminal.h, which escapes names and finds what is lost; progress redraws itself.
if grep -nE '\b(printf|fprintf|puts|fputs|fputc|putchar)\(|std::(cout|cerr|clog)\b' src/cli/*.cpp src/bench/*.cpp src/program/*.cpp |
  grep -vE '^src/cli/(terminal|progress_bar)\.cpp|fputc\(.\\n., stderr\)'; then
  echo "print by print_line, print_lines, print_cells, print_message or print_warning (src/cli/terminal.h)"
  exit 1
fi
echo "${#scripts[@]} scripts checked"
