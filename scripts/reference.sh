#!/usr/bin/env bash
# scripts/reference.sh [FOLDER]: writes job-keys.md and commands.md in FOLDER (docs/reference), as the program prints them today.
# The program must have been built (scripts/build.sh tessera tessera-bench).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly tessera=${TESSERA:-build/release/src/cli/tessera}
readonly folder=${1:-docs/reference}

if [[ $# -gt 1 || ${1-} == -* ]]; then
  echo "usage: scripts/reference.sh [FOLDER]" >&2
  exit 2
fi

# The names of the sub-commands in a --help.
subcommands_in() { sed -n '/^Subcommands:$/,/^$/s/^  \([a-z0-9_-]\{1,\}\) .*/\1/p' <<<"$1"; }

# print_command HEADING [WORD...]: the help of `tessera WORD...`, then that of all commands below it.
print_command() {
  local heading=$1 help name
  shift
  help=$("$tessera" "$@" --help)
  printf '\n%s tessera%s\n\n```\n%s\n```\n' "$heading" "${*:+ $*}" "$(sed 's/ *$//' <<<"$help")"
  for name in $(subcommands_in "$help"); do
    print_command "#$heading" "$@" "$name"
  done
}

print_commands() {
  cat <<'END'
# All commands

What `tessera --help` and the help of each of its commands say. Options may stand in any order. `--name VALUE` and
`--name=VALUE` are the same.

`scripts/reference.sh` makes this page from the program, and a test compares both. Do not edit it.
END
  print_command '##'
}

# A page is replaced when all of the new one is there.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$tessera" keys --markdown >"$work/job-keys.md"
print_commands >"$work/commands.md"
mkdir -p "$folder"
cp "$work/job-keys.md" "$work/commands.md" "$folder"
