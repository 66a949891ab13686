#!/usr/bin/env bash
# bench_test.sh TESSERA MPIRUN NEW_FOLDER: tessera bench becomes the program tessera-bench beside tessera, which a script replaces here.
# Further parts: the message if that program is missing, and the real one on several ranks.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"

new_folder
mkdir bin
cp "$tessera" bin/tessera
true_tessera=$tessera
tessera=$folder/bin/tessera

for arguments in "" "pairs --quick" "--help"; do
  # shellcheck disable=SC2086  # words
  run 1 bench $arguments
  expect_word "tessera-bench, which measures, is missing: looked for $folder/bin/tessera-bench; "
  expect_word 'scripts/build.sh --without-tests tessera-bench builds it'
  [[ $(wc -l <errors) == 1 ]] || fail "more than one line"
done
run_on_ranks 2 1 bench pairs
[[ $(grep -c 'is missing: looked for' errors) == 1 ]] || fail "not said once"
run 0 --help bench pairs
grep -q 'tessera bench --help names the benchmarks' output || fail "no help of bench: $(cat output)"
run 0 --help
grep -qE '^ +bench +Measure' output || fail "no bench in the help"
echo "ok the program is missing"

echo 'no script' >bin/tessera-bench
run 1 bench pairs
expect_word "cannot start $folder/bin/tessera-bench: Permission denied"
echo "ok a file that is no program"

# The process and the arguments stay the same.
cat >bin/tessera-bench <<'END'
#!/bin/bash
echo "$BASHPID" >process
printf '<%s>' "$@" >arguments
exit 75
END
chmod +x bin/tessera-bench
ln -s "$tessera" link  # the link's target counts
strange=(library --time-limit= -- ++ "" 'two words' $'two\nlines' --help bench -h --version)
./link bench "${strange[@]}" &
started=$!
wait $started
[[ $? == 75 ]] || fail "another exit code"
[[ $(cat process) == "$started" ]] || fail "another process"
[[ $(cat arguments) == "$(printf '<%s>' "${strange[@]}")" ]] || fail "other arguments: $(cat arguments)"
echo "ok the arguments, the process, the exit code"

tessera=$true_tessera
for arguments in "--help" "pairs --help"; do
  # shellcheck disable=SC2086  # words
  run 0 bench $arguments
  grep -q "^Usage: tessera bench ${arguments/--help/}" output || fail "another name in the help: $(cat output)"
done
run_on_ranks 2 0 bench pairs --quick --out pairs.json
[[ $(grep -c '^written to pairs.json' output) == 1 && -s pairs.json ]] || fail "not one report: $(cat output)"
echo "ok the true one"
