#!/usr/bin/env bash
# style_labels_test.sh TESSERA NEW_FOLDER ["nearest"]: groups of like style agree with labels that a person gave 142 drawings of Debian's
# clip art (style_labels.csv).
# With the word "nearest" it also prints how often the nearest drawing has the same label.
set -uo pipefail
tessera=$1
folder=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tests/cli/command_fixture.sh
source "$here/command_fixture.sh"

new_folder
clip_art=/usr/share/openclipart/svg
[[ -d $clip_art ]] || fail "no openclipart-svg: scripts/install-packages.sh"
mapfile -t files < <(sed -n 's/^[a-z_]*,\(.*\),[a-z]*$/\1/p' "$here/style_labels.csv")
mkdir labelled
for i in "${!files[@]}"; do cp "$clip_art/${files[i]}" "labelled/$(printf %03d "$i").svg"; done
most_s=600
run 0 library build labelled --keep-rectangles -o labelled.h5
label=$(sed -n 's/^\([a-z_]*\),.*,[a-z]*$/\1/p' "$here/style_labels.csv") # the labels by number

# The percentage of drawings whose label is the most frequent one of their group.
run 0 library styles labelled.h5 --groups 12 --names
agree=$(awk -F'\t' 'NR == FNR { label[sprintf("%03d", NR - 1)] = $1; next }
  { ++count[$1 FS label[$3]]; ++all; groups[$1]; labels[label[$3]] }
  END { for (g in groups) { most = 0; for (l in labels) if (count[g FS l] > most) most = count[g FS l]; sum += most }
    print int(100 * sum / all) }' <(echo "$label") output)
echo "groups agree with the eye for $agree % of $(wc -l <output) drawings"
((agree >= 65)) || fail "groups agree with the eye for $agree % of the drawings only"

[[ ${3-} == nearest ]] || exit 0
run 0 library info labelled.h5 --names
mapfile -t names <output
mapfile -t labels <<<"$label"
same=0
for name in "${names[@]}"; do
  run 0 library subset labelled.h5 --style-like "$name" --exclude "$name" --closest 1 -o nearest.h5
  run 0 library info nearest.h5 --names
  near=$(cat output)
  if [[ ${labels[10#$name]} == "${labels[10#$near]}" ]]; then ((++same)); fi
done
echo "the nearest drawing has the same label for $same of ${#names[@]}"
