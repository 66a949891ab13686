#!/usr/bin/env bash
# Runs every job of jobs/ and makes docs/gallery again: a picture of each, and README.md with figures from its card.
# Some pictures have two or four parts:
# - a seamless collage: four copies side by side
# - a collage with an earlier one's pieces: these pieces
# - a puzzle: its pieces
# - a collage in one style: the same in all styles
# - a deformed collage: the collage before deformation
# scripts/gallery.sh [JOB...]    runs only these jobs, by name: scripts/gallery.sh hero once
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source=scripts/collage.sh
source scripts/collage.sh

readonly tessera=build/release/src/cli/tessera
readonly library=out/animals.h5
readonly gallery=docs/gallery
readonly side_px=960  # two pictures of usual aspects side by side then meet between two px

scripts/install-packages.sh program tests  # the tests need rsvg-convert, pdftocairo and Python, too
scripts/build.sh --without-tests tessera
mkdir -p out/gallery
if [[ ! $library -nt $tessera ]]; then
  "$tessera" library build "$(dpkg -L openclipart-svg | grep -x '.*/svg/animals')" -o "$library"
fi

# viewbox_size SVG: prints width and height.
viewbox_size() { sed -n 's/.*<svg [^>]*viewBox="0 0 \([0-9]*\) \([0-9]*\)".*/\1 \2/p' "$1" | head -1; }

# page FOLDER COLUMNS ROWS PNG...: lays pictures of that result's size side by side, row by row, and prints the name of a PDF.
page() {
  local folder=$1 columns=$2 rows=$3 width height column=0 row=0
  shift 3
  read -r width height < <(viewbox_size "$folder/collage.svg")
  {
    echo "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 $((columns * width)) $((rows * height))'" \
      "width='$((columns * width))' height='$((rows * height))'>"
    for png in "$@"; do
      echo "<image href='$png' x='$((column * width))' y='$((row * height))' width='$width' height='$height'/>"
      column=$(((column + 1) % columns))
      if ((column == 0)); then row=$((row + 1)); fi
    done
    echo "</svg>"
  } >"$folder/page.svg"
  rsvg-convert -f pdf -o "$folder/page.pdf" "$folder/page.svg"
  echo "$folder/page.pdf"
}

# Shows a seamless collage where its copies meet.
four_copies() { page "$1" 2 2 collage.png collage.png collage.png collage.png; }

# two_pictures FOLDER PNG PNG: lays two pictures side by side, or wide ones one above the other.
two_pictures() {
  local width height
  read -r width height < <(viewbox_size "$1/collage.svg")
  if ((width > height)); then page "$1" 1 2 "$2" "$3"; else page "$1" 2 1 "$2" "$3"; fi
}

# Shows a deformed collage beside the collage before deformation.
undeformed_and_deformed() {
  make_collage "$tessera" collage "$2" --set deform.kind=none --out "$1.before" --quiet
  cp "$1.before/collage.png" "$1/before.png"
  two_pictures "$1" before.png collage.png
}

# Shows a filled canvas beside its first pieces.
before_and_after() {
  make_collage "$tessera" collage "$2" --set stop.pieces=1 --out "$1.before" --quiet
  cp "$1.before/collage.png" "$1/before.png"
  two_pictures "$1" before.png collage.png
}

# Shows a solved puzzle beside its mixed pieces.
pieces_and_puzzle() { # FOLDER LIBRARY
  "$tessera" library info "$2" --sheet "$1/sheet.png" >/dev/null
  two_pictures "$1" sheet.png collage.png
}

# Shows a collage in one style beside one in all styles.
all_styles_and_one() {
  make_collage "$tessera" collage "$2" --set style.weight=0 --out "$1.all" --quiet
  cp "$1.all/collage.png" "$1/all.png"
  page "$1" 2 1 all.png collage.png
}

# style_sheet LIBRARY: draws the library's drawings, sorted by style, as styles.jpg.
style_sheet() {
  local sheet=out/gallery/styles.png width height
  "$tessera" library styles "$1" --sheet "$sheet"
  read -r width height < <(od -An -tu4 --endian=big -j16 -N8 "$sheet")
  echo "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 $width $height' width='$width' height='$height'>" \
    "<image href='styles.png' width='$width' height='$height'/></svg>" >out/gallery/styles.svg
  rsvg-convert -f pdf -o out/gallery/styles.pdf out/gallery/styles.svg
  pdftocairo -jpeg -jpegopt quality=72 -singlefile -scale-to 1280 out/gallery/styles.pdf "$gallery/styles"
}

mapfile -t names < <(basename -s .toml jobs/*.toml)
[[ $# -eq 0 ]] || names=("$@")
for name in "${names[@]}"; do
  echo "== $name"
  # If a job has its own library, its file names the command that makes the library; the last word is a file that it writes.
  read -ra make < <(sed -n "s,^#  *tessera \(\(library\|texture\) .*\),$tessera \1,p; s,^#  *\(scripts/.*\),\1,p" \
    "jobs/$name.toml") || true
  if [[ ${#make[@]} -gt 0 && ! ${make[-1]} -nt $tessera ]]; then "${make[@]}"; fi
  make_collage "$tessera" collage "jobs/$name.toml" --out "out/gallery/$name" --quiet
  # A PDF does not show turned hues, and poppler draws the thin lines of a mosaic's small pieces one pixel wide.
  by_pixels=false
  if grep -qE '^(shift = [1-9]|harmony = )' "jobs/$name.toml"; then by_pixels=true; fi
  $by_pixels || "$tessera" draw "out/gallery/$name" --pdf --quiet
  if grep -q '^#  *tessera library styles' "jobs/$name.toml"; then style_sheet "${make[-1]}"; fi
  # The picture is made from the PDF, as the tests need poppler anyway.
  shown=out/gallery/$name/collage.pdf
  if $by_pixels; then shown=$(page "out/gallery/$name" 1 1 collage.png); fi
  if grep -q '^seamless' "jobs/$name.toml"; then shown=$(four_copies "out/gallery/$name"); fi
  if grep -q '^\[deform\]' "jobs/$name.toml"; then
    shown=$(undeformed_and_deformed "out/gallery/$name" "jobs/$name.toml")
  fi
  if [[ ${make[0]-} == scripts/puzzle-library.sh ]]; then
    shown=$(pieces_and_puzzle "out/gallery/$name" "${make[-1]}")
  elif grep -q '^pieces = "pieces/' "jobs/$name.toml"; then
    shown=$(before_and_after "out/gallery/$name" "jobs/$name.toml")
  fi
  if grep -q '^like = ' "jobs/$name.toml"; then
    shown=$(all_styles_and_one "out/gallery/$name" "jobs/$name.toml")
  fi
  pdftocairo -jpeg -jpegopt quality=88 -singlefile -scale-to "$side_px" "$shown" "$gallery/$name"
done

# value CARD LABEL: prints the value after the label on a line of card.txt
value() { sed -n "s/^  $2  *//p" "$1" | head -1; }

# old_section JOB: prints the README's section about a job that did not run here.
old_section() {
  echo
  awk -v title="## [$1](" 'index($0, "## [") == 1 { on = index($0, title) == 1 } on { lines = lines $0 "\n" }
    END { sub(/\n+$/, "", lines); print lines }' "$gallery/README.md"
}

# The paper's figures, and the jobs modelled on them.
readonly figures=(
  "13|Australian animals in three sizes|australia"
  "15|growing outward|outward"
  "16|a collage without seams|seamless"
  "17|pieces keep out of letters|letters"
  "18|a puzzle of 18 pieces with straight sides|shards"
  "18|pieces that are alike: any exact cover|tangram"
  "19|a puzzle of closely packed pieces|puzzle"
  "21, 23|gaps closed by deforming|deformed"
  "22|a mosaic of stones by their greys|stones"
  "24|a place is erased and filled again|changed"
)

sections() {
  for job in jobs/*.toml; do
    name=$(basename -s .toml "$job")
    card=out/gallery/$name/card.txt
    if [[ ! -e $card && -e $gallery/$name.jpg ]]; then old_section "$name"; fi
    [[ -e $card && -e $gallery/$name.jpg ]] || continue
    echo
    echo "## [$name](../../$job)"
    sed -n '/^#/!q; /^#  *tessera\|^#  *scripts\|mpirun/q; s/^# \{0,1\}//; /./p' "$job"
    echo
    echo "![$name]($name.jpg)"
    echo
    echo "$(value "$card" coverage) covered, overlap $(value "$card" overlap), $(value "$card" pieces)," \
      "$(value "$card" "total time"), stopped by $(value "$card" "stopped by")"
  done
}

# numbers NAME: prints the last line of that section of the standard input.
numbers() {
  awk -v title="## [$1](" 'index($0, "## [") == 1 { on = index($0, title) == 1 } on && /./ { last = $0 } END { print last }'
}

{
  body=$(sections)
  echo "# Gallery"
  echo "\`scripts/gallery.sh\` runs every job of [jobs](../../jobs), with Debian's openclipart (public domain) and photos."
  echo "The numbers are those of each card. The times are of one run without MPI on the machine that made the gallery."
  echo
  echo "| the paper's figure | what it shows | here | numbers |"
  echo "|---|---|---|---|"
  for figure in "${figures[@]}"; do
    IFS='|' read -r number what name <<<"$figure"
    echo "| $number | $what | [$name](#$name) | $(numbers "$name" <<<"$body") |"
  done
  echo "$body"
} >"$gallery/README.md.new"
mv "$gallery/README.md.new" "$gallery/README.md"
