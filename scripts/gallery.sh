#!/usr/bin/env bash
# Runs every job of jobs/ and makes docs/gallery anew: a picture of each, and README.md with what its card says;
# of a seamless one four copies side by side, of one with pieces of an earlier collage these alone beside it.
#   scripts/gallery.sh [JOB...]    only these, by name: scripts/gallery.sh hero once
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly tessera=build/release/src/cli/tessera
readonly library=out/animals.h5
readonly gallery=docs/gallery
readonly side_px=960  # pictures of usual aspects, two side by side, meet between two px

scripts/install-packages.sh
scripts/build.sh tessera
mkdir -p out/gallery
if [[ ! $library -nt $tessera ]]; then
  "$tessera" library build "$(dpkg -L openclipart-svg | grep -x '.*/svg/animals')" -o "$library"
fi

# viewbox_size SVG: prints width and height.
viewbox_size() { sed -n 's/.*<svg [^>]*viewBox="0 0 \([0-9]*\) \([0-9]*\)".*/\1 \2/p' "$1" | head -1; }

# page FOLDER COLUMNS ROWS PNG...: pictures of that result's size side by side, row by row; prints the name of a PDF.
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

# What is seamless is seen where copies meet.
four_copies() { page "$1" 2 2 collage.png collage.png collage.png collage.png; }

# What was filled is seen beside what stood first.
before_and_after() {
  "$tessera" collage "$2" --set stop.pieces=1 --out "$1.before" --quiet
  cp "$1.before/collage.png" "$1/before.png"
  page "$1" 1 2 before.png collage.png
}

mapfile -t names < <(basename -s .toml jobs/*.toml)
[[ $# -eq 0 ]] || names=("$@")
for name in "${names[@]}"; do
  echo "== $name"
  # Where it has a library of its own, the job says with which command, whose last word is the file.
  read -ra make < <(sed -n "s,^#  *tessera \(library .*\),$tessera \1,p; s,^#  *\(scripts/.*\),\1,p" \
    "jobs/$name.toml") || true
  if [[ ${#make[@]} -gt 0 && ! ${make[-1]} -nt $tessera ]]; then "${make[@]}"; fi
  "$tessera" collage "jobs/$name.toml" --out "out/gallery/$name" --quiet
  shifted=false  # tones and hues, which a PDF does not show
  if grep -qE '^(shift = [1-9]|harmony = )' "jobs/$name.toml"; then shifted=true; fi
  $shifted || "$tessera" draw "out/gallery/$name" --pdf --quiet
  # By way of the PDF: poppler is here for the tests anyway.
  shown=out/gallery/$name/collage.pdf
  if $shifted; then shown=$(page "out/gallery/$name" 1 1 collage.png); fi
  if grep -q '^seamless' "jobs/$name.toml"; then shown=$(four_copies "out/gallery/$name"); fi
  if grep -q '^pieces = "pieces/' "jobs/$name.toml"; then
    shown=$(before_and_after "out/gallery/$name" "jobs/$name.toml")
  fi
  pdftocairo -jpeg -jpegopt quality=88 -singlefile -scale-to "$side_px" "$shown" "$gallery/$name"
done

# value CARD LABEL: what stands behind the label on a line of card.txt
value() { sed -n "s/^  $2  *//p" "$1" | head -1; }

# old_section JOB: what the README says of a job that did not run here.
old_section() {
  echo
  awk -v title="## [$1](" 'index($0, "## [") == 1 { on = index($0, title) == 1 } on { lines = lines $0 "\n" }
    END { sub(/\n+$/, "", lines); print lines }' "$gallery/README.md"
}

{
  echo "# Gallery"
  echo "Every job of [jobs](../../jobs), made by \`scripts/gallery.sh\` with Debian's openclipart (public domain) and photos."
  echo "The numbers are those of each card; the times are of one run without MPI on the machine that made the gallery."
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
} >"$gallery/README.md.new"
mv "$gallery/README.md.new" "$gallery/README.md"
