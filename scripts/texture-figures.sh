#!/usr/bin/env bash
# scripts/texture-figures.sh RESULT LIB.h5: compares the pieces of a result with the elements of the library it was made from.
# It prints the Kolmogorov-Smirnov distances of sizes (square root of the area) and of elongations (ratio of the axes of the area's second
# moments).
# Each element of the library counts once. It also prints the covered share of the canvas.
set -euo pipefail
readonly result=$1 library=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# data DATA_SET prints a data set of the library, numbers DATA_SET its numbers, one a line.
data() { h5dump -w 0 -y -d "$1" "$library" | sed '0,/DATA {/d; /^ *}/,$d'; }
numbers() { data "$1" | tr ',' '\n' | tr -d ' ' | grep .; }

numbers /shapes/drawn_scale >"$work/sizes"
data /shapes/name | grep -oE '"[^"]*"' | sed 's/"//g; s/\\000.*//' >"$work/names"
numbers /outline/first_curve >"$work/curves"
numbers /outline/first_point >"$work/points_of_curves"
numbers /outline/points | paste -d ' ' - - >"$work/points"

# For the outer curve of each shape: the minor axis divided by the major one.
awk -v work="$work" '
  BEGIN {
    while ((getline line < (work "/points_of_curves")) > 0) first_point[points_of_curves++] = line
    while ((getline line < (work "/points")) > 0) { split(line, p, " "); x[n] = p[1]; y[n++] = p[2] }
  }
  FNR > 1 {
    xx = yy = xy = 0
    begin = first_point[curve]; end = first_point[curve + 1]
    for (i = begin; i < end; ++i) {
      j = i + 1 < end ? i + 1 : begin
      cross = x[i] * y[j] - x[j] * y[i]
      xx += cross * (x[i] * x[i] + x[i] * x[j] + x[j] * x[j])
      yy += cross * (y[i] * y[i] + y[i] * y[j] + y[j] * y[j])
      xy += cross * (x[i] * y[j] + 2 * x[i] * y[i] + 2 * x[j] * y[j] + x[j] * y[i]) / 2
    }
    middle = (xx + yy) / 2; spread = sqrt((xx - yy) ^ 2 / 4 + xy * xy)
    printf "%.6f\n", sqrt((middle - spread) / (middle + spread))
  }
  { curve = $1 }' "$work/curves" >"$work/elongations"

sed -n 's/.*"shape":"\([^"]*\)".*"scale":\([0-9.]*\).*/\1\t\2/p' "$result/pieces.geojson" >"$work/pieces"
cut -f 2 "$work/pieces" >"$work/placed_sizes"
awk -F '\t' 'FNR == NR { elongation[$1] = $2; next } { print elongation[$1] }' \
  <(paste "$work/names" "$work/elongations") "$work/pieces" >"$work/placed_elongations"

# ks A B: prints the largest difference of the two cumulative distributions. Sizes of pieces are rounded to 0.001 px.
ks() {
  awk '
    FNR == NR { a[n++] = $1; next }
    { b[m++] = $1 }
    END {
      while (i < n && j < m) {
        at = (a[i] < b[j] ? a[i] : b[j]) + 0.002 * (a[n - 1] > 2)
        while (i < n && a[i] <= at) ++i
        while (j < m && b[j] <= at) ++j
        d = i / n - j / m; if (d < 0) d = -d
        if (d > most) most = d
      }
      printf "%.3f\n", most
    }' <(sort -g "$1") <(sort -g "$2")
}
echo "pieces            $(wc -l <"$work/pieces") of $(wc -l <"$work/names") elements"
echo "KS of sizes       $(ks "$work/sizes" "$work/placed_sizes")"
echo "KS of elongations $(ks "$work/elongations" "$work/placed_elongations")"
sed -n 's/^ *coverage  */covered           /p' "$result/card.txt"
