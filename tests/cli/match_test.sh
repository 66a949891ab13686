#!/usr/bin/env bash
# match_test.sh TESSERA NEW_FOLDER: tessera match lays drawings onto one another, and names files that it cannot read.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

docs=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../docs" && pwd)
new_folder
make_drawings .
svg() { echo "<svg xmlns='http://www.w3.org/2000/svg' width='300' height='300'>$1</svg>"; }
value() { sed -n "s/^ *\"$1\": \([^,]*\),\?$/\1/p" output | head -1; }
expect_range() { # KEY LEAST MOST
  awk -v found="$(value "$1")" -v least="$2" -v most="$3" 'BEGIN { exit !(found != "" && found >= least && found <= most) }' ||
    fail "$1: $(value "$1"), not from $2 to $3"
}

# The leaf turned by 60 degrees and twice as large; then half of it alone.
leaf='M10 90 C10 30 50 10 90 10 C90 60 60 90 10 90Z'
svg "<path transform='translate(150 40) rotate(60) scale(2)' d='$leaf'/>" >turned.svg
run 0 match turned.svg leaf.svg --json -o picture.svg
expect_silence "a word about good drawings"
expect_range score 0.97 1
expect_range scale 1.98 2.02
expect_range rotation_deg 59.5 60.5
expect_range x 148.5 151.5
grep -q '^<svg' picture.svg || fail "no picture"
svg "<clipPath id='c'><rect width='150' height='300'/></clipPath>
     <g clip-path='url(#c)'><path transform='translate(150 40) rotate(60) scale(2)' d='$leaf'/></g>" >half.svg
run 0 match leaf.svg half.svg --json
expect_range part_of_a 0.3 0.8
expect_range similarity 0.9 1
echo "ok whole and cut"

# Drawings that are less alike score lower.
run 0 match leaf.svg leaf.svg
grep -q '^1 .*100.0 %' output || fail "not the same as itself: $(cat output)"
run '0 3' match star.svg bean.svg --json
[[ $code -eq 3 ]] || expect_range score 0 0.5
run 0 match star.svg star.svg --all 3
[[ $(grep -c '^[1-3] ' output) -eq 3 ]] || fail "not three matches: $(cat output)"
echo "ok another"

# The series of docs/matching.md: its scores fall, and equal those on the page.
for number in 2 3 4 5 6; do
  run 0 match "$docs/matching/duck.svg" "$docs/matching/duck-$number.svg" --json
  told=$(sed -n "s/^| \[duck-$number\].*| \(0\.[0-9]*\) |.*/\1/p" "$docs/matching.md")
  [[ -n $told ]] || fail "no score of duck-$number in docs/matching.md"
  expect_range score "$(awk "BEGIN { print $told - 0.01 }")" "$(awk "BEGIN { print $told + 0.01 }")"
  awk "BEGIN { exit !($told < ${last:-1} - 0.1 || $number == 2) }" || fail "duck-$number scores no less than the one before"
  last=$told
done
echo "ok a series"

# Strokes: a curve among more lines, and a straight line.
stroke="fill='none' stroke='black' stroke-width='5'"
wave='M20 180 C40 20 120 20 100 100 S160 180 180 60'
svg "<path $stroke d='$wave'/><path $stroke d='M20 250 H280'/>" >lines.svg
svg "<rect width='300' height='300' fill='white'/><path $stroke transform='translate(250 20) rotate(80)' d='$wave'/>" >wave.svg
run 0 match --open lines.svg wave.svg --json
expect_range part_of_b 0.95 1
expect_range scale 0.97 1.03
expect_range rotation_deg -81 -79
svg "<path $stroke d='M20 20 V150'/>" >line.svg
run 0 match --open line.svg line.svg --all 4
[[ $(grep -c '^[1-4] ' output) -eq 2 ]] || fail "not both ways round: $(cat output)"
echo "ok strokes"

# Inputs that cannot be used.
: >empty.svg
svg "<path d='M5 5'/>" >point.svg
svg "<circle cx='150' cy='150' r='140' $stroke/>" >ring.svg
run 2 match empty.svg leaf.svg && expect_word "empty.svg: neither SVG nor"
run 2 match leaf.svg point.svg && expect_word "point.svg: found nothing that is drawn; needed:"
run 2 match --open leaf.svg point.svg && expect_word "point.svg: found no lines; needed: lines"
run 2 match none.svg leaf.svg && expect_word "none.svg"
run 2 match leaf.svg leaf.svg -o picture.png && expect_word "-o: found picture.png, allowed: a name that ends in .svg"
run 1 match leaf.svg leaf.svg -o /proc/none/picture.svg && expect_word "/proc/none/picture.svg"
run 2 match leaf.svg leaf.svg --all 0 && expect_word "--all"
run 3 match --open ring.svg line.svg -o none_picture.svg && expect_word "nothing of line.svg matches ring.svg: no picture"
[[ ! -e none_picture.svg ]] || fail "a picture of nothing"
run 3 match --open ring.svg line.svg --json
grep -q '"matches": \[\]' output || fail "no empty list: $(cat output)"
echo "ok mistakes"
