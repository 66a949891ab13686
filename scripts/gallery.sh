#!/usr/bin/env bash
# Runs every job of jobs/ and makes docs/gallery anew: a picture of each, and README.md with what its card says.
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

mapfile -t names < <(basename -s .toml jobs/*.toml)
[[ $# -eq 0 ]] || names=("$@")
for name in "${names[@]}"; do
  echo "== $name"
  "$tessera" collage "jobs/$name.toml" --out "out/gallery/$name" --quiet
  "$tessera" draw "out/gallery/$name" --pdf --quiet
  # By way of the PDF: poppler is here for the tests anyway.
  pdftocairo -jpeg -jpegopt quality=88 -singlefile -scale-to "$side_px" "out/gallery/$name/collage.pdf" "$gallery/$name"

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
