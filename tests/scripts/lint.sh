#!/usr/bin/env bash
# Every script of the repository parses, and shellcheck has no warning about it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

scripts=(scripts/*.sh slurm/*.s* tests/*/*.sh .ci/run)
for script in "${scripts[@]}"; do
  bash -n "$script"
done
shellcheck --external-sources --severity=warning "${scripts[@]}"
# All of src/ prints through terminal/terminal.h, which escapes names and notices lost output.
# Exceptions are the end of a progress line, and one message of MPI's guard before there is a job.
if grep -rnE '\b(printf|fprintf|puts|fputs|fputc|putchar)\(|std::(cout|cerr|clog)\b' src --include='*.cpp' --include='*.h' |
  grep -vE '^src/terminal/|^src/comm/mpi_job\.cpp|fputc\(.\\n., stderr\)'; then
  echo "print by print_line, print_lines, print_cells, print_message or print_warning (src/terminal/terminal.h)"
  exit 1
fi
# A script that takes an option for a file's name makes such files.
if compgen -G './-*'; then
  echo "a file whose name looks like an option"
  exit 1
fi
echo "${#scripts[@]} scripts checked"
