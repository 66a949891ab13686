#!/usr/bin/env bash
# rooms_test.sh [FOLDER]: every folder of src/ with C++ files is listed in src/rooms.txt. A file includes only rooms up to its own in that
# list, and no room is too large.
# FOLDER: another src/, for the test of this test.
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../../src}"
most_files=40

declare -A place
number=0
while read -r room _; do
  [[ -z $room || $room == \#* ]] || place[$room]=$((++number))
done <rooms.txt

failed=0
fail() { echo "$1" >&2; failed=1; }

while read -r room; do
  [[ -n ${place[$room]-} ]] || fail "src/rooms.txt does not name $room"
done < <(find . -name '*.cpp' -printf '%h\n' -o -name '*.h' -printf '%h\n' | sed 's|^\./||' | sort -u)

for room in "${!place[@]}"; do
  files=$(find . -path "./$room/*" ! -path "./$room/*/*" \( -name '*.cpp' -o -name '*.h' \) | wc -l)
  ((files > 0)) || fail "src/rooms.txt names $room, which holds no files"
  ((files <= most_files)) || fail "$room holds $files files; allowed: $most_files or fewer"
done

# Each line of the input is an include of another room: "core/field/room.cpp core/base".
while read -r file included; do
  own=${file%/*}
  [[ -n ${place[$included]-} && -n ${place[$own]-} ]] || continue
  ((place[$included] <= place[$own])) ||
    fail "$file includes a header of $included, which stands after $own in src/rooms.txt"
done < <(grep -roP --include='*.cpp' --include='*.h' '^#include "\K[^"]+(?=/[^/"]+")' . | sed 's|^\./||; s|:| |')

exit "$failed"
