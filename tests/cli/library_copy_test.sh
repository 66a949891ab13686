#!/usr/bin/env bash
# library_copy_test.sh TESSERA NEW_FOLDER: tessera library merge and subset, their messages, and the files that they never replace.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

new_folder
make_drawings drawings
mkdir more
cp drawings/star.svg more/star_again.svg
sed 's/teal/crimson/' drawings/star.svg >more/star_red.svg
cp drawings/bean.svg more/bean_again.svg
draw_svg more/leaf 'M10 10 H90 V90 H50 V50 H10Z'
run 0 library build drawings -o a.h5
run 0 library build more -o b.h5

run 0 library merge a.h5 b.h5 -o all.h5
grep -q '^merged 2 with the same silhouette and colour:$' output || fail "twins that are not counted"
grep -qx '  star_again = star' output || fail "a twin that is not told"
grep -qE '^all.h5, .* MB, 7 shapes$' output || fail "another number of shapes"
grep -qF $'merged\tb.h5/bean_again\tthe silhouette and colour of bean' all.left_out.txt || fail "another list"
run 0 library info all.h5 --names
[[ $(tr '\n' , <output) == 'bean,corner,drop,leaf,star,leaf (more),star_red,' ]] || fail "other names"
run 0 library info all.h5
grep -qx 'silhouettes     6 (1 in other colours)' output || fail "no variants"
echo "ok merge"

run 0 library subset all.h5 --include '*e*' --include 'star*' --exclude '*d*' -o some.h5
run 0 library info some.h5 --names
[[ $(tr '\n' , <output) == 'bean,corner,leaf,star,leaf (more),' ]] || fail "another choice"
run 2 library subset all.h5 --include 'Star' -o none.h5
grep -qF 'include: no shape of all.h5 has a name like "Star"; near it are: star, star_red' errors ||
  fail "no near names"
run 2 library subset all.h5 -o none.h5
grep -qF 'nothing is chosen; needed: --include, --exclude or --style-like' errors || fail "a choice of nothing"
[[ ! -e none.h5 && ! -e none.left_out.txt ]] || fail "a library of nothing"
echo "ok subset"

cp a.h5 a_before.h5
ln a.h5 same.h5
for output in a.h5 ./a.h5 same.h5; do
  run 2 library merge a.h5 b.h5 -o "$output"
  grep -qF -- "--output: found $output, which is read" errors || fail "another message for $output"
done
cmp a.h5 a_before.h5 || fail "what is read was replaced"
run 2 library merge a.h5 b.h5 -o drawings/bean.svg
grep -qF 'drawings/bean.svg: is there and is no library' errors || fail "another message for a drawing"
run 2 library merge a.h5 none.h5 -o new.h5
run 2 library merge a.h5 drawings/bean.svg -o new.h5
run 1 library merge a.h5 b.h5 -o /proc/new.h5
run 0 library build more --pad-levels 4 -o other.h5
run 2 library merge a.h5 other.h5 -o new.h5
grep -qF 'other.h5: built with --pad-levels 4 --delta-tau 0.200000, but a.h5 with --pad-levels 5' errors ||
  fail "another message for libraries that differ"
[[ ! -e new.h5 && ! -e new.h5.lock ]] || fail "a library of bad ones"
run 0 library subset all.h5 --include leaf -o all_but.h5
run 0 library subset a.h5 --include leaf -o all_but.h5 # replaces an existing library
echo "ok errors"

# collage NAME OPTION...: makes and draws a collage, and prints the digest of its pieces
collage() {
  local name=$1
  shift
  run 0 collage job.toml --out "$name" --quiet "$@"
  grep -o '"library":.*"digest":"[0-9a-f]*"},"canvas"' "$name/manifest.json" | grep -o '[0-9a-f]\{16\}'
}
cat >job.toml <<'END'
quality = 'draft'
[library]
files = ["a.h5", "b.h5"]
[canvas]
size_px = [120, 90]
[pieces]
scale_px = [15, 40]
[stop]
pieces = 6
[output]
width_px = 240
END
joined=$(collage joined) || exit 1
merged=$(collage merged --set library.files= --set library.file=all.h5) || exit 1
[[ -n $joined && $joined == "$merged" ]] || fail "files of a job are another library than their merger: $joined $merged"
cmp joined/pieces.geojson merged/pieces.geojson || fail "files of a job give other pieces than their merger"
cmp joined/collage.png merged/collage.png || fail "files of a job give another picture than their merger"
grep -q '"colours"' joined/manifest.json && fail "a palette for a library of two colours"
collage teal --set library.files=a.h5 >/dev/null
grep -q '"colours":\["#' teal/manifest.json || fail "teal drawings alone are not told apart by colours"
collage as_drawn --set library.files=a.h5 --set colour.pieces=artwork >/dev/null
grep -q '"colours"' as_drawn/manifest.json && fail "colours of artwork"
cmp -s as_drawn/collage.png teal/collage.png && fail "the palette is not seen"
cmp as_drawn/pieces.geojson teal/pieces.geojson || fail "colours change pieces"
printf '#aa0000\n#00aa00\n' >two.txt
collage two --set colour.pieces=palette --set colour.palette=two.txt >/dev/null
grep -q '"colours":\["#\(aa0000\|00aa00\)"' two/manifest.json || fail "another palette than that of the file"
cp two/collage.png two.png
rm two.txt
"$tessera" draw two --quiet 2>errors && cmp two/collage.png two.png || fail "tessera draw needs the palette's file"
"$tessera" collage job.toml --set colour.palette=two.txt --out three 2>errors && fail "a palette that is not there"
grep -q 'job.toml: colour.palette: .*two.txt.*allowed: dusk' errors || fail "another message for a palette"
collage chosen --set 'library.include=["l*", "star*"]' --set library.exclude=*red >/dev/null
grep -o '"shape":"[^"]*"' chosen/pieces.geojson | sort -u | grep -vE '"(leaf|star|leaf \(more\))"' &&
  fail "a shape that is not chosen"
cp joined/collage.png before.png
mkdir moved && mv a.h5 moved/a.h5 && mv b.h5 moved/b.h5
"$tessera" draw joined --png --quiet 2>errors && fail "draws without its libraries"
grep -q 'library.files: .*a.h5: no such file.*--library FILE of tessera draw says' errors ||
  fail "another message of draw"
"$tessera" draw --library moved/a.h5 --library moved/b.h5 joined --png --quiet || fail "draw --library --library"
cmp joined/collage.png before.png || fail "drawn otherwise from libraries that were moved"
"$tessera" draw joined --library all.h5 --png --quiet || fail "draw with the merger"
"$tessera" draw joined --library moved/a.h5 --png --quiet 2>errors && fail "draws with another library"
grep -q 'moved/a.h5: not the library that the collage was made from.*, then in .*a.h5, .*b.h5; the collage' errors ||
  fail "another message for another library"
"$tessera" collage job.toml --set 'library.files=["moved/a.h5", "moved/b.h5"]' --set 'library.include=bea' --out new \
  2>errors &&
  fail "a choice of nothing"
grep -q 'job.toml: library.include: no shape of .* has a name like "bea"; near it are: bean' errors ||
  fail "no near names"
echo "ok jobs"
