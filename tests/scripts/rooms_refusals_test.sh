#!/usr/bin/env bash
# rooms_refusals_test.sh: rooms_test.sh refuses an include of a later room, a room without a line, and a line without a room.
set -euo pipefail
rooms_test=$(dirname "${BASH_SOURCE[0]}")/rooms_test.sh
src=$(mktemp -d)
trap 'rm -rf "$src"' EXIT
mkdir -p "$src"/low "$src"/high
echo '#include "low/a.h"' >"$src"/high/b.h
touch "$src"/low/a.h
printf 'low  what is below\nhigh  what is above\n' >"$src"/rooms.txt

# refused WORDS: rooms_test.sh fails with a message that contains WORDS
refused() {
  local said
  if said=$("$rooms_test" "$src" 2>&1); then
    echo "nothing was refused; expected: $1" >&2
    exit 1
  fi
  [[ $said == *"$1"* ]] || { echo "found: $said; expected: $1" >&2; exit 1; }
}

"$rooms_test" "$src"
echo '#include "high/b.h"' >"$src"/low/a.h
refused "low/a.h includes a header of high, which stands after low"
: >"$src"/low/a.h
mkdir "$src"/new
touch "$src"/new/c.cpp
refused "does not name new"
rm -r "$src"/new
echo "gone  nothing" >>"$src"/rooms.txt
refused "names gone, which holds no files"
