#!/usr/bin/env bash
# printing_test.sh TESSERA NEW_FOLDER: the output arrives, or the command fails. It covers readers that leave early, names with terminal
# commands or spreadsheet formulas, and options that take the next one for their value.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

enter_folder
write_job '80, 60' '10, 20' 80
run 0 collage job.toml --out result --quiet

# Each command prints something, and removes nothing that a later one needs.
printing=(
  "--help"
  "--version"
  "library info --help"
  "devices"
  "plan job.toml"
  "library info own.h5"
  "library info own.h5 --names"
  "library info own.h5 --sheet sheet.png"
  "library styles own.h5"
  "library styles own.h5 --names"
  "library build drawings -o again.h5"
  "library subset own.h5 --include * -o some.h5"
  "card result"
  "card result --json"
  "campaign job.toml --seeds 1-2 --list"
  "rank result"
  "draw result --svg"
  "collage job.toml --out result --resume=auto"
)
set -f # tessera itself expands the patterns
for command in "${printing[@]}"; do
  # shellcheck disable=SC2086
  timeout "$most_s" "$tessera" $command >/dev/full 2>errors
  code=$?
  [[ $code == 1 ]] || fail "exit code $code of $command onto a full disk"
  grep -qx 'tessera: standard output cannot be written: No space left on device; .*' errors || fail "$command: not told"
done
for command in "library info own.h5 --names" "card result --json" "draw result --svg --quiet"; do
  # shellcheck disable=SC2086
  timeout "$most_s" "$tessera" $command --help >&- 2>errors
  code=$?
  [[ $code == 1 ]] || fail "exit code $code of $command without stdout"
  grep -qx 'tessera: standard output cannot be written: it is closed; .*' errors || fail "$command: not told"
  # The program `true` reads nothing and ends before anything is printed.
  # shellcheck disable=SC2086
  timeout "$most_s" "$tessera" $command 2>errors | true
  code=${PIPESTATUS[0]}
  [[ $code == 0 ]] || fail "exit code $code of $command where nobody reads"
  [[ ! -s errors ]] || fail "$command complains of a reader that left"
done
set +f
echo "ok lost output"

# An input error stays an input error. With --quiet nothing is printed, so nothing is lost.
timeout "$most_s" "$tessera" card >/dev/full 2>errors
[[ $? == 2 ]] || fail "an input error and a full disk"
timeout "$most_s" "$tessera" draw result --svg --quiet >/dev/full 2>errors || fail "nothing was to be printed"
timeout "$most_s" "$tessera" draw result --svg --quiet <&- >&- 2>&- || fail "quiet, with nothing open"
timeout "$most_s" "$tessera" library subset own.h5 --include 'star' -o closed.h5 <&- >&- 2>&-
run 0 library info closed.h5 --names
[[ $(cat output) == star ]] || fail "a library was printed into"
echo "ok nothing to lose"

# If the reader of stderr leaves, the collage is made all the same.
unread() { timeout "$most_s" "$tessera" collage job.toml --out unread --set 'pieces.scale_px=[8, 20]' 2>&1; }
{ unread; echo "$?" >code; } | true
[[ $(cat code) == 0 && -s unread/manifest.json ]] || fail "a collage ended as its log was not read"
echo "ok log that nobody reads"

# Names that clear the screen, begin a new line or begin a formula.
evil=$'=x\e[2J\nrank 1\u009b2J\u202e'
cp -r result "$evil"
run 0 rank . --out ranking
LC_ALL=C grep -q $'\e' output && fail "rank printed ESC"
[[ $(wc -l <output) == 7 ]] || fail "rank: a name broke the table"
LC_ALL=C grep -q $'\xc2\x9b\|\xe2\x80\xae' output && fail "rank printed a C1 or bidirectional control"
run 0 rank "$evil" result --out ranking
grep -q "^[0-9],'=x_\[2J_rank 1__2J___,[0-9-]" ranking/ranking.csv ||
  fail "ranking.csv: $(cat ranking/ranking.csv)"
for command in "card" "draw" "library info" "rank" "collage" "plan" "nest" "extract" "refine" "puzzle solve"; do
  # shellcheck disable=SC2086
  timeout "$most_s" "$tessera" $command "$evil/none" "--$evil" >output 2>errors
  [[ $(wc -l <errors) == 1 ]] || fail "$command: more than a line of error"
  LC_ALL=C grep -q $'\e' errors && fail "$command printed ESC"
done
run 2 collage job.toml --set "pieces.uses=$evil" --out none
[[ $(wc -l <errors) == 1 ]] || fail "a value broke the message"
run 0 campaign job.toml --seeds 1-2 --out "$evil" --list
LC_ALL=C grep -q $'\e' output && fail "campaign --list printed ESC"
# Programs read the folder's path, whatever bytes its name has: bash in the list of a campaign, others in ranking.json.
odd=$'odd \xe4\xff\e\n\'\u00ad\u200e\U000e0041 \u00e9'
for folder_of_list in "$odd" "a b'c" "\$'x" plain; do
  run 0 campaign job.toml --seeds 1-2 --out "$folder_of_list" --list
  [[ $(wc -l <output) == 2 ]] || fail "campaign --list: a name broke the line"
  iconv -f utf-8 output >/dev/null || fail "campaign --list: no UTF-8"
  IFS=$'\t' read -r state cell seed <output
  [[ $state == open && $seed == seed=1 ]] || fail "campaign --list: another state or value: $state $seed"
  [[ $cell != "\$'"* ]] || eval "cell=$cell"
  [[ $cell == "$folder_of_list/seed_1" ]] || fail "campaign --list: another folder: $cell"
done
cp -r result "$odd"
run 0 rank "$odd" result --out ranking
python3 - "$odd" <<'PYTHON' || fail "ranking.json: another folder"
import json, sys
folders = [each["folder"] for each in json.load(open("ranking/ranking.json"))["ranking"]]
assert sorted(folders) == sorted([sys.argv[1], "result"]), folders
PYTHON
LC_ALL=C grep -q $'\xc2\xad\|\xe2\x80\x8e\|\xf3\xa0\x81\x81\|\xe4\|\xff' output ranking/ranking.csv ranking/ranking.json &&
  fail "rank printed what is not seen"
echo "ok names"

# One argument is one value: no option takes the next option for its value.
refused() { # TEXT COMMAND...
  run 2 "${@:2}"
  grep -qF -- "$1" errors || fail "another message than: $1"
}
refused '--scale-px: found 20, allowed: MIN,MAX' bench alternatives --library own.h5 --scale-px 20 --out x.json
refused '--size: found 100, allowed: W,H' card result/pieces.geojson --size 100 --json
refused '--size: found 100, allowed: W,H' puzzle solve own.h5 --size 100 --job-only
refused '--sheet: found 100, allowed: W,H' nest own.h5 --sheet 100 --quiet
refused '--box: found 1,2,3, allowed: X,Y,W,H' refine result --box 1,2,3 --quiet
refused '--angles: found 0,x, allowed: DEG,...' nest --angles 0,x own.h5
refused 'none.svg' nest --angles 0,90 none.svg --strip 60
refused 'none.h5' library subset --include star none.h5 -o some.h5
refused 'none.h5' bench library --sizes 10 --library none.h5 --out x.json
refused '--palette nonsense: ' draw result --palette nonsense
refused '--palette: found #zz,#112233, allowed: ' draw result --palette '#zz,#112233'
refused 'not expected: leaf' library subset own.h5 --include star leaf -o some.h5
refused '--out: found the option --quiet, allowed: a value; for a value that begins like an option: --out=--quiet' \
  collage job.toml --out --quiet
refused '--strip: found the option --out, allowed: a value' nest own.h5 --strip --out X
refused '--seed: found the option --quiet, allowed: a value' nest own.h5 --strip 60 --seed --quiet
refused '--spacing: found the option --quiet, allowed: a value' nest own.h5 --strip 60 --spacing --quiet
refused '--pieces: found the option --cut, allowed: a value' puzzle make sheet.png --pieces --cut
refused '--seeds: found the option --out, allowed: a value' campaign job.toml --seeds --out X
refused '--include: found the option --exclude, allowed: a value' library subset own.h5 --include --exclude x -o some.h5
refused '--strip: found wide, allowed: a number' nest own.h5 --strip wide --out X
refused '--seed: found 1.5, allowed: a whole number' nest own.h5 --strip 60 --seed 1.5 --out X
[[ ! -e X ]] || fail "a refused command wrote something"
refused '--devices x: "x" is no index' bench pairs --devices x --out x.json
[[ ! -e --quiet && ! -e x.json ]] || fail "an option became a file"
echo "ok options"
