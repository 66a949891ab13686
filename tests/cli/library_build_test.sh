#!/usr/bin/env bash
# library_build_test.sh TESSERA NEW_FOLDER: the messages of tessera library build about files that it could not use.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

build() { run "$1" library build "${@:2}" -o own.h5; } # CODE ARGUMENT...

new_folder
make_drawings drawings
cp drawings/bean.svg drawings/bean_again.svg
echo "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'/>" >drawings/nothing.svg
echo GIF89a >drawings/old.gif
reason='a format that is not read; convert it to SVG or PNG: gif'

build 2 drawings --strict
[[ ! -e own.h5 ]] || fail "--strict wrote a library"
grep -qF 'own.h5 was not written: --strict; 8 files: 5 shapes, 1 merged with these, 2 skipped; the first is' errors ||
  fail "another message of --strict"
[[ $(wc -l <own.left_out.txt) == 3 ]] || fail "another list of --strict"
build 0 drawings --edge-opacity 0.1
cp own.h5 wide.h5
build 2 drawings --edge-opacity 0.01
grep -q -e '--edge-opacity.*0.02' errors || fail "another message for an opacity out of range"
build 2 drawings --edge-opacity nan
grep -q -e '--edge-opacity: found nan' errors || fail "another message for no number"
build 0 drawings
cmp -s own.h5 wide.h5 && fail "--edge-opacity changes nothing"
grep -qE '^own.h5, .* s; of 8 files: 5 shapes, 1 merged with these, 2 skipped$' output ||
  fail "numbers that do not add up"
grep -qF "$(printf 'skipped\t%s\t%s' "$PWD/drawings/old.gif" "$reason")" own.left_out.txt ||
  fail "another reason in a folder"
cp own.left_out.txt list_before.txt
build 2 drawings/nothing.svg
cmp list_before.txt own.left_out.txt || fail "the list of a library that stays was replaced"
grep -q $'^skipped\t.*/nothing.svg\tshows nothing' output || fail "no reasons beside a library that stays"
echo "ok numbers"

rm -f own.*
build 2 drawings/old.gif drawings/nothing.svg
[[ ! -e own.h5 ]] || fail "a library of nothing"
grep -qF 'own.h5 was not written: no usable shape in 2 files: 0 shapes, 2 skipped; the first is' errors ||
  fail "another message"
grep -qF "$(printf 'skipped\t%s\t%s' "$PWD/drawings/old.gif" "$reason")" own.left_out.txt ||
  fail "another reason when named"
grep -q 'nothing.svg.*shows nothing; an image needs transparency' own.left_out.txt ||
  fail "does not say what to do"
rm own.left_out.txt
mkdir -p own.left_out.txt/kept
build 1 drawings/nothing.svg
grep -qx 'tessera: cannot write own.left_out.txt: Is a directory' errors || fail "a list that cannot be written is not named"
rm -r own.left_out.txt
echo "ok nothing usable"

cp drawings/bean.svg drawings/bean.ai
build 0 drawings/bean.ai
echo "ok a file that is named"

mkdir line_art
lens='<circle cx="50" cy="50" r="40" fill="none" stroke="black" stroke-width="8"/>'
echo "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='100'>$lens<g transform='translate(100)'>$lens</g><path d='M90 46h20v8H90z'/></svg>" >line_art/spectacles.svg
echo "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><circle cx='50' cy='50' r='40' fill='none' stroke='black' stroke-width='.5'/></svg>" >line_art/ring.svg
cp drawings/bean.svg line_art
build 0 line_art
grep -qE '1 encloses twice what it covers or more, which leaves gaps; .*: spectacles.svg$' output ||
  fail "does not say which drawings --fill-holes would help"
grep -q 'an outline with hardly any area; fill it, or let --fill-holes take what it encloses: ring.svg' output ||
  fail "another reason for thin lines"
build 0 line_art --fill-holes
grep -q 'fill-holes' output && fail "--fill-holes is advised where it was given"
grep -q '3 files: 3 shapes$' output || fail "--fill-holes leaves something out"
"$tessera" library build --help | grep -q -e '--fill-holes' || fail "no help"
echo "ok what is enclosed"

# Without fonts librsvg draws text differently each time. The program then leaves text out and says so.
mkdir fonts words
cat >fonts.conf <<END
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig><dir>$PWD/fonts</dir><cachedir>$PWD/fonts</cachedir></fontconfig>
END
bar='<circle cx="50" cy="50" r="40" fill="red"/><path d="M50 54h200v8H50z"/>'
words=''
for size in 20 40 60; do
  words+="<text x='60' y='70' font-size='$size' font-family='Arial' font-weight='bold' style='display:inline'>H a 5 %</text>"
done
page() { echo "<svg xmlns='http://www.w3.org/2000/svg' width='300' height='100'>$1</svg>"; }
page "$bar$words" >words/both.svg
page "$words" >words/only.svg
page "$bar<text x='100' y='70' font-size='60'>H</text>" >letter.svg
for library in first second; do
  FONTCONFIG_FILE=$PWD/fonts.conf run 0 library build words -o $library.h5
  grep -q '^text is not drawn, as fontconfig finds no font here, in 1: both.svg' output || fail "lost text is not told"
  grep -q $'^skipped\t.*only.svg\tits text cannot be drawn' $library.left_out.txt || fail "another reason for text alone"
done
cmp first.h5 second.h5 || fail "another library each time"
FONTCONFIG_FILE=$PWD/fonts.conf run 0 library build letter.svg -o without_font.h5
run 0 library build letter.svg -o with_font.h5
grep -q 'no font' output && fail "lost text where there are fonts"
cmp -s without_font.h5 with_font.h5 && fail "text is not drawn where there are fonts"
echo "ok no font"
