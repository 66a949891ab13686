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

start_server() { # RESULT OPTION...: sets $server and $address
  rm -f address.txt
  "$tessera" serve "$@" >address.txt 2>told.txt &
  server=$!
  for ((tries = 0; tries < 600; ++tries)); do
    address=$(grep -o 'http://127.0.0.1:[0-9]*/[0-9a-f]\{32\}/' address.txt 2>/dev/null) && return
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
# The process that refines.
child() { cat /proc/"$server"/task/*/children | tr -d ' '; }

enter_folder
write_job '120, 90' '14, 60' 120
run 0 collage job.toml --out result --quiet
cp -r result before

start_server result
ask attack
[[ $(ls -d result*) == result ]] || fail "a refused request made a folder"
echo "ok what must be refused"

token=$(basename "$address")
commands=$(cat /proc/[0-9]*/cmdline 2>/dev/null | tr '\0' ' ')
[[ $commands != *"$token"* ]] || fail "the token is an argument of a process"
[[ $(grep -rlF "$token" . | sort) == ./address.txt ]] || fail "the token stands in a file: $(grep -rlF "$token" .)"
echo "ok the token is no secret of files or arguments"

expect_answer '202 {"name":"result-2"}' refine result erase 1
expect_answer 'result-2 finished ' wait
run 0 refine result --marks result-2/marks.json --out again --quiet
cmp result-2/pieces.geojson again/pieces.geojson || fail "the server's refinement is another one than that of its marks"
grep -qxF "tessera: tessera refine result --out result-2 --marks result-2/marks.json --early" told.txt || fail "the command is not told"
diff -r result before >/dev/null || fail "the result itself has changed"
expect_answer '202 {"name":"result-3"}' refine result-2 erase 0 "" 7
expect_answer 'result-3 finished ' wait
grep -qx 'seed = 7' result-3/job.toml || fail "the seed did not reach the job"
expect_answer '202 *' refine result relax "" 1
expect_answer 'result-4 finished ' wait
grep -qx 'lock = \[1\]' result-4/job.toml || fail "the lock did not reach the job"
run 0 refine result --marks result-4/marks.json --out again_4 --quiet
cmp result-4/pieces.geojson again_4/pieces.geojson || fail "marks that relax give another result"
expect_answer '202 *' refine result erase 99
expect_answer 'result-5 failed *99*' wait
echo "ok refinements"

# The pieces are there before they are improved, and do not change what comes of it.
run 0 refine result --marks result-2/marks.json --out early --quiet --early
cmp result-2/pieces.geojson early/pieces.geojson || fail "--early gives another result"
"$tessera" refine result --marks result-2/marks.json --out earlier --quiet --early --set improve.trials=1000000 --set stop.pieces=0 >/dev/null 2>&1 &
refining=$!
for ((tries = 0; tries < 600; ++tries)); do [[ -e earlier/manifest.json ]] && break; sleep 0.05; done
kill -9 "$refining"
wait "$refining" 2>/dev/null
[[ -e earlier/checkpoint.h5 ]] || fail "an early result without a checkpoint"
run 0 report earlier --quiet
grep -q '"finished":false' earlier/report.html || fail "an early result is called finished"
echo "ok early results"

# A second one is refused while one is at work. It is held at its beginning, so that stop finds it unfinished.
expect_answer '202 *' refine result erase 0
kill -STOP "$(child)" || fail "no process refines"
expect_answer '409 *result-6*' refine result erase 1
ask stop
kill -CONT "$(child)"
expect_answer 'result-6 @(stopped|failed) *' wait
echo "ok one at a time"

# The end of the server is that of the refinement, which keeps its state.
expect_answer '202 {"name":"result-7"}' refine result erase 0
pid=$(child)
kill -STOP "$pid" || fail "no process refines"
kill -INT "$server"
sleep 0.3
kill -0 "$server" 2>/dev/null || fail "the server did not wait for its refinement"
expect_answer '409 *about to end*' refine result erase 1
kill -CONT "$pid"
wait "$server" || fail "the server ended with $?"
kill -0 "$pid" 2>/dev/null && fail "the refinement goes on without its server"
[[ ! -e result-7/collage.png ]] || fail "the refinement was not stopped"
[[ -z $(find result-7 -name '*.tmp*') ]] || fail "half a file: $(ls result-7)"
echo "ok the end"

# A further session has another token, and finds what was made.
before=$address
mkdir result-1 result-02 result-+3 result-2147483647 result-9
for name in result-1 result-02 result-+3 result-2147483647; do cp -r before/. "$name"; done
start_server result --port "$(python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')"
[[ $(basename "$before") != "$(basename "$address")" ]] || fail "the token is the old one"
ask state >states
for line in 'result finished -' 'result-2 finished result' 'result-3 finished result-2' 'result-4 finished result'; do
  grep -qxF "$line" states || fail "not in the state of the next session: $line: $(cat states)"
done
grep -qE '^result-(5|9|1|02|\+3|2147483647) ' states && fail "a folder that is none of its results is shown: $(cat states)"
mkdir result-8
expect_answer '202 {"name":"result-10"}' refine result-3 erase 0
expect_answer 'result-10 finished ' wait
run 1 serve result --port "$(echo "$address" | cut -d: -f3 | cut -d/ -f1)"
expect_word "cannot listen"
end_server 0
echo "ok the next session"

# Another user of the machine is not even heard, with the right address. (The shell speaks, as nobody may have no Python.)
speak() { # COMMAND...: prints the first word of the answer
  local port=${address#*0.0.1:}
  port=${port%%/*}
  (cd / && "$@" bash -c "exec 3<>/dev/tcp/127.0.0.1/$port && printf 'GET /$(basename "$address")/state HTTP/1.0\r\nHost: localhost\r\n\r\n' >&3 &&
    timeout 20 head -c 12 <&3" 2>/dev/null)
}
if ((EUID == 0)) && command -v setpriv >/dev/null; then
  start_server result
  [[ $(speak env) == "HTTP/1.1 200" ]] || fail "the user is not heard: $(speak env)"
  [[ -z $(speak setpriv --reuid=65534 --regid=65534 --clear-groups) ]] || fail "another user is heard"
  end_server 0
  echo "ok other users"
fi

# What was stopped goes on by the command that the page shows, to the same pieces. It is held while it improves.
run 0 collage job.toml --out long --quiet --set stop.pieces=0 --set improve.trials=60
start_server long
expect_answer '202 {"name":"long-2"}' refine long erase 0,1,2,3
for ((tries = 0; tries < 2000; ++tries)); do [[ -e long-2/manifest.json ]] && break; sleep 0.01; done
pid=$(child)
kill -STOP "$pid"
ask stop
kill -CONT "$pid"
expect_answer 'long-2 stopped tessera refine long --out long-2 --marks long-2/marks.json --early --resume=auto goes on' wait
end_server 0
run 0 refine long --out long-2 --marks long-2/marks.json --early --resume=auto --quiet
run 0 refine long --out long_once --marks long-2/marks.json --quiet
cmp long-2/pieces.geojson long_once/pieces.geojson || fail "a stopped refinement has other pieces than one that was not stopped"
echo "ok what was stopped goes on"

# Where others may read stdout, the address stands in a file of its own.
for mode in 640 604; do
  : >open.txt
  chmod "$mode" open.txt
  "$tessera" serve result >>open.txt 2>told.txt &
  server=$!
  for ((tries = 0; tries < 600; ++tries)); do grep -q Ctrl-C open.txt && break; sleep 0.05; done
  grep -q 'http://127' open.txt && fail "the address stands in a file for others"
  [[ $(stat -c %a result/serve_address.txt) == 600 ]] || fail "the file of the address is not private"
  address=$(cat result/serve_address.txt)
  ask state >states
  end_server 0
  [[ ! -e result/serve_address.txt ]] || fail "the file of the address stays"
done
timeout 60 "$tessera" serve result >/dev/full 2>errors && fail "it serves although nobody can know where"
[[ ! -e result/serve_address.txt ]] || fail "the file of the address stays"
echo "ok output that others may read"

for name in -x 'a b' '50%#?&' Größe "it's \"so\""; do
  cp -r before "./$name"
  start_server -- "$name"
  expect_answer '202 *' refine "./$name" erase 0
  end_server 0
done
newline=$'two\nlines'
cp -r before "$newline"
run 2 serve "$newline"
expect_word "cannot stand in an address"
run 2 serve drawings
run 2 serve nowhere
echo "ok names"
