#!/usr/bin/env bash
# Runs every job of jobs/ and makes docs/gallery anew: a picture of each, and README.md with what its card says;
# of a seamless one four copies side by side.
#   scripts/gallery.sh [JOB...]    only these, by name: scripts/gallery.sh hero once
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly tessera=build/release/src/cli/tessera
readonly library=out/animals.h5
readonly gallery=docs/gallery
readonly side_px=1000

scripts/install-packages.sh
scripts/build.sh tessera
mkdir -p out/gallery
if [[ ! $library -nt $tessera ]]; then
  "$tessera" library build "$(dpkg -L openclipart-svg | grep -x '.*/svg/animals')" -o "$library"
fi

# four_copies FOLDER: what is seamless is seen where copies meet; prints the name of a PDF.
four_copies() {
  local width height x y
  read -r width height < <(sed -n 's/.*<svg [^>]*viewBox="0 0 \([0-9]*\) \([0-9]*\)".*/\1 \2/p' "$1/collage.svg" | head -1)
  {
    echo "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 $((2 * width)) $((2 * height))'" \
      "width='$((2 * width))' height='$((2 * height))'>"
    for x in 0 "$width"; do
      for y in 0 "$height"; do
        echo "<image href='collage.png' x='$x' y='$y' width='$width' height='$height'/>"
      done
    done
    echo "</svg>"
  } >"$1/copies.svg"
  rsvg-convert -f pdf -o "$1/copies.pdf" "$1/copies.svg"
  echo "$1/copies.pdf"
}

mapfile -t names < <(basename -s .toml jobs/*.toml)
[[ $# -eq 0 ]] || names=("$@")
for name in "${names[@]}"; do
  echo "== $name"
  "$tessera" collage "jobs/$name.toml" --out "out/gallery/$name" --quiet
  "$tessera" draw "out/gallery/$name" --pdf --quiet
  # By way of the PDF: poppler is here for the tests anyway.
  page=out/gallery/$name/collage.pdf
  if grep -q '^seamless' "jobs/$name.toml"; then page=$(four_copies "out/gallery/$name"); fi
  pdftocairo -jpeg -jpegopt quality=88 -singlefile -scale-to "$side_px" "$page" "$gallery/$name"
done

# value CARD LABEL: what stands behind the label on a line of card.txt
value() { sed -n "s/^  $2  *//p" "$1" | head -1; }

{
  echo "# Gallery"
  echo "Every job of [jobs](../../jobs), made by \`scripts/gallery.sh\` with Debian's openclipart (public domain). The numbers are"
  echo "those of each card; the times are of one run without MPI on the machine that made the gallery."
  for job in jobs/*.toml; do
    name=$(basename -s .toml "$job")
    card=out/gallery/$name/card.txt
    [[ -e $card && -e $gallery/$name.jpg ]] || continue
    echo
    echo "## [$name](../../$job)"
    sed -n '/^#/!q; /mpirun/q; s/^# \{0,1\}//; /./p' "$job"
    echo
    echo "![$name]($name.jpg)"
    echo
    echo "$(value "$card" coverage) covered, overlap $(value "$card" overlap), $(value "$card" pieces)," \
      "$(value "$card" "total time"), stopped by $(value "$card" "stopped by")"
  done
} >"$gallery/README.md.new"
mv "$gallery/README.md.new" "$gallery/README.md"
