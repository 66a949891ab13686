#!/usr/bin/env bash
# serve_test.sh TESSERA NEW_FOLDER: tessera serve from its start to its end, with refinements, and with requests that it must refuse.
set -uo pipefail
tessera=$1
folder=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tests/cli/command_fixture.sh
source "$here/command_fixture.sh"
umask 077
server=
trap '[[ -n $server ]] && kill "$server" 2>/dev/null' EXIT

start_server() { # OPTION...: sets $server and $address
  rm -f address.txt
  "$tessera" serve result "$@" >address.txt 2>told.txt &
  server=$!
  for ((tries = 0; tries < 600; ++tries)); do
    address=$(grep -o 'http://127.0.0.1:[0-9]*/[0-9a-f]\{32\}/' address.txt) && return
    kill -0 "$server" 2>/dev/null || break
    sleep 0.05
  done
  cat told.txt
  fail "the server does not start"
}
ask() { python3 "$here/serve_client.py" "$address" "$@" || fail "serve_client.py $*"; }
expect_answer() { # WANTED COMMAND [ARGUMENT]
  local answer
  answer=$(ask "${@:2}") || exit 1
  # shellcheck disable=SC2053  # a pattern
  [[ $answer == $1 ]] || fail "${*:2}: $answer, not $1"
}
end_server() { # WANTED_CODE
  kill -INT "$server"
  wait "$server"
  local code=$?
  [[ $code == "$1" ]] || { cat told.txt; fail "the server ended with $code"; }
}
# The process that refines, once it is there.
child() { pgrep -P "$server" -f 'tessera refine'; }
erase() { echo "{\"result\":\"$1\",\"action\":\"erase\",\"pieces\":[$2],\"lock\":[],\"seed\":${3:-null}}"; }

enter_folder
write_job '120, 90' '14, 60' 120
run 0 collage job.toml --out result --quiet
cp -r result before

start_server
ask attack
[[ $(ls -d result*) == result ]] || fail "a refused request made a folder"
echo "ok what must be refused"

token=$(basename "$address")
cat /proc/[0-9]*/cmdline 2>/dev/null | tr '\0' ' ' | grep -vF serve_client | grep -qF "$token" && fail "the token is an argument of a process"
[[ $(grep -rlF "$token" . | sort) == ./address.txt ]] || fail "the token stands in a file: $(grep -rlF "$token" .)"
echo "ok the token is no secret of files or arguments"

expect_answer '202 {"name":"result-2"}' refine "$(erase result 1)"
expect_answer 'result-2 finished ' wait
run 0 refine result --marks result-2/marks.json --out again --quiet
cmp result-2/pieces.geojson again/pieces.geojson || fail "the server's refinement is another one than that of its marks"
diff -r result before >/dev/null || fail "the result itself has changed"
expect_answer '202 {"name":"result-3"}' refine "$(erase result-2 0 7)"
expect_answer 'result-3 finished ' wait
grep -qx 'seed = 7' result-3/job.toml || fail "the seed did not reach the job"
expect_answer '202 *' refine '{"result":"result","action":"relax","pieces":[],"lock":[1]}'
expect_answer 'result-4 finished ' wait
expect_answer '202 *' refine "$(erase result 99)"
expect_answer 'result-5 failed *99*' wait
echo "ok refinements"

# A second one is refused while one is at work, which stop ends.
expect_answer '202 *' refine "$(erase result 0)"
kill -STOP "$(child)" || fail "no process refines"
expect_answer '409 *result-6*' refine "$(erase result 1)"
ask stop
kill -CONT "$(child)"
expect_answer 'result-6 *' wait
echo "ok one at a time"

# The end of the server is that of the refinement, which keeps its state.
expect_answer '202 {"name":"result-7"}' refine "$(erase result 0)"
pid=$(child)
kill -STOP "$pid" || fail "no process refines"
kill -INT "$server"
sleep 0.3
kill -0 "$server" 2>/dev/null || fail "the server did not wait for its refinement"
expect_answer '409 *about to end*' refine "$(erase result 1)"
kill -CONT "$pid"
wait "$server" || fail "the server ended with $?"
kill -0 "$pid" 2>/dev/null && fail "the refinement goes on without its server"
[[ -e result-7/manifest.json || -z $(ls result-7/*.tmp 2>/dev/null) ]] || fail "half a result: $(ls result-7)"
echo "ok the end"

# A further session has another token, and finds what was made.
before=$address
start_server --port "$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')"
[[ $(basename "$before") != "$(basename "$address")" ]] || fail "the token is the old one"
ask state >states
for line in 'result finished -' 'result-2 finished result' 'result-3 finished result-2' 'result-4 finished result'; do
  grep -qxF "$line" states || fail "not in the state of the next session: $line: $(cat states)"
done
grep -q '^result-5' states && fail "a folder without a result is shown"
expect_answer '202 {"name":"result-8"}' refine "$(erase result-3 0)"
expect_answer 'result-8 finished ' wait
run 1 serve result --port "$(echo "$address" | cut -d: -f3 | cut -d/ -f1)"
expect_word "cannot listen"
end_server 0
echo "ok the next session"

(umask 022 && timeout 60 "$tessera" serve result >open.txt 2>errors) && fail "the address was printed into a file for all"
expect_word "umask 077"
[[ ! -s open.txt ]] || fail "the address stands in a file for all"
run 2 serve drawings
run 2 serve nowhere
echo "ok what it cannot serve"
