#!/usr/bin/env bash
# reference_test.sh PROGRAM: the generated pages of docs/reference are what the program prints today, and the tables of exit codes and of
# environment variables are those of the sources (reference_tables_test.py). A key, an option, a code or a variable that is added
# to the sources alone is found.
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
fail() { echo "FAILED $1"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

TESSERA=$program scripts/reference.sh "$work/pages" || fail "scripts/reference.sh"
for page in job-keys.md commands.md; do
  diff -u "docs/reference/$page" "$work/pages/$page" ||
    fail "docs/reference/$page is outdated: scripts/build.sh tessera tessera-bench && scripts/reference.sh"
done

# No command and no table is passed over.
for heading in 'tessera library build' 'tessera puzzle solve' 'tessera keys' 'tessera bench pairs'; do
  grep -q "^#* $heading\$" "$work/pages/commands.md" || fail "commands.md has no heading $heading"
done
commands=$(grep -c '^#* tessera' "$work/pages/commands.md")
((commands >= 37)) || fail "commands.md has $commands commands alone"
keys=$(grep -c '^| `' "$work/pages/job-keys.md")
listed=$("$program" keys | grep -cvE '^$|^key |^Top level$|^\[')
((keys >= 100 && keys == listed)) || fail "job-keys.md has $keys keys, tessera keys lists $listed"

python3 tests/scripts/reference_tables_test.py || fail "docs/reference/exit-codes.md or environment.md"

# The test of this test: each line is added to a file of a copy, and the comparison must name what is new.
mkdir "$work/copy"
cp -r --parents src scripts slurm docs/reference "$work/copy"
expected=()
add() {  # FILE LINE MESSAGE
  echo "$2" >>"$work/copy/$1"
  expected+=("$3")
}
add src/terminal/exit_codes.h 'inline constexpr int kLateExitCode = 76;' 'lacks the exit code 76,'
add src/comm/watchdog.cpp 'void f() { std::_Exit(77); }' 'lacks the exit code 77,'
add src/artwork/drawer/drawer_memory.cpp 'constexpr int kNew = 72; void f() { ::_exit(tessera::kNew); }' 'lacks the exit code 72,'
add src/cli/draw_command.cpp 'int f() { return 4; }' 'lacks the exit code 4,'
add src/comm/watchdog.cpp 'auto f() { return std::getenv("TESSERA_NEW"); }' 'lacks the variable TESSERA_NEW,'
add src/comm/launcher_check.cpp '{"NEW_SIZE", "NEW_RANK", "a new launcher"},' 'lacks the variable NEW_SIZE,'
add src/files/own_file.cpp 'auto f() { return getenv("LANG"); }' 'lacks the variable LANG,'
add slurm/job.sh "echo \"\${TESSERA_LATER:-20}\"" 'lacks the variable TESSERA_LATER,'
add scripts/demo.sh 'export VERBOSE=1' 'lacks the variable VERBOSE,'
add docs/reference/exit-codes.md '| `99` | gone |' 'has the exit code 99, which no source'
add docs/reference/environment.md '| `TESSERA_GONE` | |' 'has the variable TESSERA_GONE, which no source'
if output=$(python3 tests/scripts/reference_tables_test.py "$work/copy" 2>&1); then fail "nothing new was found"; fi
for message in "${expected[@]}"; do
  [[ $output == *"$message"* ]] || fail "not found: $message"$'\n'"$output"
done
echo "ok $commands commands, $keys keys"
