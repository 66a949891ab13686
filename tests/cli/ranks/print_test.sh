#!/usr/bin/env bash
# print_test.sh TESSERA MPIRUN NEW_FOLDER: output for printing: sizes in mm, pieces without overlap, and backgrounds of regions. Also the
# same collage in other colours, beside the result or in its place.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"

# digest FOLDER: a digest of all files of a result
digest() { find "$1" -type f -print0 | sort -z | xargs -0 sha256sum | sha256sum; }

enter_folder
cat >in_mm.toml <<'END'
quality = 'draft'
[library]
file = 'own.h5'
[stop]
pieces = 12
[canvas]
size_mm = [60, 45]
size_px = [120, 90]
END
cp in_mm.toml in_px.toml
printf '[pieces]\nscale_mm = [7, 20]\noverlap_px = 0\n[output]\ndpi = 150\n' >>in_mm.toml
printf '[pieces]\nscale_px = [14, 40]\noverlap_px = 0\n[output]\ndpi = 150\n' >>in_px.toml
same_on_3_ranks in_mm collage in_mm.toml --quiet
run 0 collage in_px.toml --out in_px --quiet
run 0 collage in_mm/job.toml --out again --quiet
for other in in_px in_mm_on_3 again; do
  for name in pieces.geojson job.toml collage.svg collage.png; do
    cmp "in_mm/$name" "$other/$name" || fail "$other/$name is another one than in mm"
  done
done
grep -q 'width="60.000mm" height="45.000mm"' in_mm/collage.svg || fail "collage.svg is not as large as the canvas"
grep -q '"width_px":354,"width_mm":60.0,"dpi":150.0' in_mm/manifest.json ||
  fail "collage.png is not as large as the canvas"
run 0 draw in_mm --svg --width 300 --quiet
grep -q 'width="300" height="225"' in_mm/collage.svg || fail "--width gives no px"
run 0 draw in_mm --svg --set output.width_mm=30 --quiet
grep -q 'width="30.000mm"' in_mm/collage.svg || fail "output.width_mm does not win"
run 0 draw in_mm --svg --set output.dpi=600 --quiet
[[ ! -s errors ]] || fail "a warning of a dpi that counts"
run 2 collage in_px.toml --out none --set 'canvas.size_mm=[0, 0]' --set pieces.scale_mm=3
grep -q 'pieces.scale_mm: found 3; needed: canvas.size_mm' errors || fail "another message without size_mm"
grep -q '"overlap_fraction": *\(0.000000\|0.0[,}]\|0[,}]\)' in_mm/card.json || fail "pieces overlap"
# expect_paper FOLDER WIDTH_MM HEIGHT_MM: the pictures have this size on paper, to 0.001 mm if the format can say it.
expect_paper() {
  local size
  size="width=\"$2mm\" height=\"$3mm\""
  grep -qF "$size" "$1/collage.svg" || fail "$1/collage.svg has not the $size"
  python3 - "$@" <<'PYTHON' || fail "a picture of $1 is not as large on paper as was asked"
import re, struct, sys
folder, width_mm, height_mm = sys.argv[1], float(sys.argv[2]), float(sys.argv[3])
box = re.search(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", open(folder + "/collage.pdf", "rb").read())
for found, want in zip(box.groups(), (width_mm, height_mm)):
    assert abs(float(found) * 25.4 / 72 - want) < 0.001, box.groups()
png = open(folder + "/collage.png", "rb").read()
size = struct.unpack(">II", png[16:24])
at = png.index(b"pHYs") + 4
for px, per_metre, want in zip(size, struct.unpack(">II", png[at:at + 8]), (width_mm, height_mm)):
    assert abs(px / per_metre * 1000 - want) < want * 0.5 / per_metre + 1e-9, (px, per_metre)
tiff = open(folder + "/collage.tiff", "rb").read()
directory = struct.unpack("<I", tiff[4:8])[0]
entries = struct.unpack("<H", tiff[directory:directory + 2])[0]
fields = {}
for i in range(entries):
    tag, kind, count, value = struct.unpack("<HHII", tiff[directory + 2 + 12 * i:directory + 14 + 12 * i])
    fields[tag] = struct.unpack("<II", tiff[value:value + 8]) if kind == 5 else value
for px, tag, want in zip(size, (282, 283), (width_mm, height_mm)):
    assert abs(px * 25.4 * fields[tag][1] / fields[tag][0] - want) < 0.001, fields[tag]
PYTHON
}

# At this scale 141 px alone would be only 20.94 mm.
run 0 collage in_px.toml --out a4 --quiet --set 'canvas.size_mm=[21, 29.7]' --set 'canvas.size_px=[141, 200]' --set output.dpi=300
run 0 draw a4 --svg --pdf --png --tiff --quiet
grep -q 'viewBox="0 0 141.414 200"' a4/collage.svg || fail "collage.svg is not A4 by ten"
expect_paper a4 21.000 29.700
# A page of the box' own aspect fills the box. A page of another aspect has the mm of the side that fits.
echo '<svg xmlns="http://www.w3.org/2000/svg" width="420mm" height="297mm" viewBox="0 0 420 297">' \
  '<ellipse cx="210" cy="148" rx="208" ry="146"/></svg>' >page.svg
printf "quality = 'draft'\n[library]\nfile = 'own.h5'\n[canvas]\nfile = 'page.svg'\nsize_px = [200, 141]\n" >page.toml
printf "[pieces]\nscale_px = [30, 60]\n[stop]\npieces = 4\n[output]\ndpi = 60\n" >>page.toml
run 0 collage page.toml --out page --quiet --set 'canvas.size_mm=[420, 297]'
run 0 draw page --svg --pdf --png --tiff --quiet
grep -q 'viewBox="0 0 200 141.429"' page/collage.svg || fail "the canvas does not fill its box"
expect_paper page 420.000 297.000
run 0 collage page.toml --out upright --quiet --set 'canvas.size_mm=[297, 420]' --set 'canvas.size_px=[141, 200]'
run 0 draw upright --svg --pdf --png --tiff --quiet
expect_paper upright 297.000 210.021
echo "ok millimetres"

printf "quality = 'draft'\n[library]\nfile = 'own.h5'\n[stop]\npieces = 2\n[canvas]\nsize_px = [120, 90]\n[pieces]\nscale_px = [14, 40]\n" >plain.toml
run 0 collage plain.toml --out plain --quiet --set output.dpi=600 --set pieces.padding_px=2 --set pieces.overlap_px=1
grep -q 'warning: output.dpi (now 600) means nothing .*; pieces.overlap_px (now 1) does not count beside' errors ||
  fail "keys that mean nothing are not told"
grep -q 'output.dpi (now 600) means nothing' plain/run.log || fail "nor in the log"
run 0 draw plain --svg --quiet
[[ ! -s errors ]] || fail "what was told is told again"
run 0 draw plain --svg --set output.dpi=500 --quiet
grep -q 'warning: output.dpi (now 500) means nothing' errors || fail "tessera draw does not tell"
echo "ok keys that mean nothing"

run 0 collage in_px.toml --out dusk --quiet --set colour.pieces=palette
cp dusk/collage.png dusk.png
before=$(digest dusk)
run 0 draw dusk --palette ink --to ink --quiet
[[ $(digest dusk) == "$before" ]] || fail "--to changes the result"
[[ $(ls ink) == $'collage.png\ncollage.svg\nrun.log' ]] || fail "other files than pictures: $(ls ink)"
cmp -s ink/collage.png dusk/collage.png && fail "the palette is not seen"
run 0 draw dusk --palette dusk --to same --quiet
cmp same/collage.png dusk.png || fail "the job's own palette gives another picture"
run 0 draw dusk --palette '#102030,#AABBCC' --quiet
grep -q '"palette":\["#102030","#aabbcc"\]' dusk/manifest.json || fail "the manifest does not tell the palette"
cmp -s dusk/collage.png dusk.png && fail "colours that are given are not seen"
run 0 draw dusk --quiet
cmp dusk/collage.png dusk.png || fail "the result has lost its own colours"
grep -q '"palette"' dusk/manifest.json && fail "the manifest tells a palette that is not drawn"
run 0 draw dusk --set colour.pieces=artwork --to artwork --quiet
run 0 collage in_px.toml --out drawn --quiet --set colour.pieces=artwork
cmp artwork/collage.png drawn/collage.png || fail "the artwork is drawn otherwise"
printf '#ff0000\n' >red.txt
run 0 draw drawn --palette red.txt --to red --quiet
grep -q 'fill="#ff0000"' red/collage.svg || fail "a palette's file is not seen"
run 0 collage in_px.toml --out reds --quiet --set colour.pieces=palette --set colour.palette=red.txt
mv red.txt gone.txt
run 0 draw reds --svg --set output.outline_colour=#123456 --set output.outline_px=1 --quiet
grep -q 'fill="#ff0000"' reds/collage.svg || fail "a line's colour takes those of the pieces"
run 2 draw drawn --palette none.gpl
grep -q -- '--palette none.gpl: .*none.gpl.*allowed: dusk' errors || fail "another message for no palette"
run 2 draw drawn --palette '#12'
grep -q -- '--palette: found #12, allowed: dusk, ' errors || fail "another message for no colour"
run 2 draw drawn --to dusk
grep -q -- '--to dusk: found a result there, allowed: a folder without one' errors || fail "another message for a result"
for name in checkpoint.h5 checkpoint.previous.h5; do
  mkdir killed && touch "killed/$name"
  run 2 draw drawn --to killed
  grep -q -- '--to killed: found the checkpoint of an interrupted run there' errors || fail "another message for $name"
  [[ $(ls killed) == "$name" ]] || fail "pictures beside $name: $(ls killed)"
  rm -r killed
done
printf 'host elsewhere\npid 7\nboot another\n' >drawn/run.lock
run 2 draw drawn --to elsewhere
grep -q 'drawn: another run may still be at work here: process 7 on elsewhere' errors || fail "a run into RESULT is not seen"
rm drawn/run.lock
mkdir drawn/run.lock
run 1 draw drawn --quiet
run 0 draw drawn --to elsewhere --quiet
rmdir drawn/run.lock
run 0 draw drawn --to elsewhere --quiet
[[ ! -e drawn/run.lock && ! -e elsewhere/run.lock ]] || fail "a lock is left"
run 2 draw drawn --set pieces.uses=1
run 1 draw drawn --to /proc/none
# Another user may read the result.
if as_stranger=$(command -v setpriv) && [[ $(id -u) == 0 ]]; then
  as_stranger+=' --reuid=65534 --regid=65534 --clear-groups'
  mkdir -m 777 strangers
  if $as_stranger test -x "$tessera" -a -w strangers; then
    $as_stranger "$tessera" draw drawn --svg --to strangers --quiet >output 2>errors || fail "a result of another user"
    cmp strangers/collage.svg drawn/collage.svg || fail "a stranger gets another picture"
  fi
fi
echo "ok other colours"

cat >regions.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="120" height="90">
<path fill="#ff0000" d="M10 10H110V45H10Z"/><path fill="#0000ff" d="M10 45H110V80H10Z"/>
</svg>
SVG
cat >regions.toml <<'TOML'
quality = 'draft'
[library]
file = "own.h5"
[canvas]
file = "regions.svg"
size_px = [120, 90]
[pieces]
scale_px = [14, 30]
[stop]
pieces = 3
[[regions]]
name = "upper"
colour = "#ff0000"
background = "#123456"
[[regions]]
name = "lower"
colour = "#0000ff"
[output]
width_px = 240
TOML
run 0 collage regions.toml --out regions --quiet
grep -q '<path fill="#123456"' regions/collage.svg || fail "no background of a region"
before=$(sha256sum <regions/pieces.geojson)
sed -i 's/#123456/#654321/' regions.toml
run 0 collage regions.toml --out regions --quiet
grep -q 'the finished result of another job' errors || fail "another background makes the same result"
grep -q '<path fill="#654321"' regions/collage.svg || fail "the background before"
[[ $(sha256sum <regions/pieces.geojson) == "$before" ]] || fail "a background changes pieces"
sed -i 's/#654321/654321/' regions.toml
run 2 collage regions.toml --out regions --quiet
grep -q 'regions.toml:.*: \[\[regions\]\] background: found "654321", allowed: "#rrggbb"' errors ||
  fail "another message for a background"
echo "ok regions"
