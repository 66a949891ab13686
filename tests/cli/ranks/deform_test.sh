#!/usr/bin/env bash
# deform_test.sh TESSERA MPIRUN NEW_FOLDER: a job's pieces are deformed, the same on one rank and on three.
# The poses are those of the job without deformation. tessera refine deforms a finished result to the same bytes.
# Pictures show it, and are made again from the files alone. Some shapes may not be deformed, and impossible requests are refused.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"

enter_folder
cat >plain.toml <<'END'
[library]
file = 'own.h5'
[canvas]
size_px = [240, 180]
[pieces]
scale_px = [20, 80]
[improve]
trials = 20
[output]
width_px = 240
END
cat plain.toml - >job.toml <<'END'
[deform]
kind = 'capped'
END
poses() { grep -o '"canvas_from_shape":[^]]*' "$1/pieces.geojson"; }
value() { sed -n "s/.*\"$2\": \([0-9.]*\).*/\1/p" "$1/card.json" | head -1; }
less() { awk "BEGIN {exit !($1 < $2)}"; }

run 0 collage plain.toml --out plain --quiet
same_on_3_ranks deformed collage job.toml --quiet
expect_silence "a deformed collage"
cmp <(poses plain) <(poses deformed) || fail "deforming changes where pieces lie"
cmp -s plain/pieces.geojson deformed/pieces.geojson && fail "nothing was deformed"
grep -q '"deformed":true' deformed/manifest.json || fail "the manifest does not say it"
less "$(value plain coverage_fraction)" "$(value deformed coverage_fraction)" || fail "it does not cover more"
[[ $(value deformed coverage_before_fraction) == "$(value plain coverage_fraction)" ]] || fail "another coverage before"
less 0.2 "$(value deformed least_jacobian)" || fail "a drawing is folded: $(value deformed least_jacobian)"
echo "ok job"

run 0 refine plain --deform --quiet
cmp deformed/pieces.geojson plain-deformed/pieces.geojson || fail "refine deforms to something else"
run 0 refine plain --deform=voronoi --quiet
mv plain-voronoi full
less "$(value deformed coverage_fraction)" "$(value full coverage_fraction)" || fail "voronoi fills no more"
run 0 collage plain-deformed/job.toml --out again --quiet
cmp deformed/pieces.geojson again/pieces.geojson || fail "job.toml of a deformed result makes something else"
# Warnings do not repeat: none about relaxing, which was not asked for though the sizes differ too much; and none about the job that came
# before.
run 0 collage plain.toml --set 'pieces.scale_px=[14, 80]' --set improve.trials=0 --set output.dpi=600 --out told --quiet
expect_word 'output.dpi (now 600) means nothing'
run 0 refine told --deform --quiet
expect_silence "deforming warns: $(cat errors)"
run 0 refine told --relax --quiet
[[ $(cat errors) == *'the pieces are not relaxed, as their sizes differ too much, 14 to 80 px'* && $(wc -l <errors) == 1 ]] ||
  fail "relaxing warns: $(cat errors)"
echo "ok refine"

# An interrupted run is not deformed; it goes on to the same bytes.
long=(collage job.toml --set improve.trials=120 --set checkpoint.every_s=0.01 --quiet)
run 0 "${long[@]}" --out whole
"$tessera" "${long[@]}" --out broken >output 2>errors &
started=$!
until [[ -s broken/checkpoint.h5 ]] || ! kill -0 "$started" 2>/dev/null; do sleep 0.01; done
kill -s INT "$started" 2>/dev/null
wait "$started"
code=$?
[[ $code == 75 ]] || fail "exit code $code of an interrupted run, not 75"
grep -q '"deformed":true' broken/manifest.json && fail "what is unfinished is deformed"
run 0 "${long[@]}" --out broken --resume
cmp whole/pieces.geojson broken/pieces.geojson || fail "other pieces after an interruption"
echo "ok interrupted"

# Deformation across seams, of mirrored pieces, and with the wished distance.
run 0 collage job.toml --set canvas.seamless=both --set pieces.mirrored=also --set pieces.padding_px=2 --out pattern --quiet
grep -q '"mirrored":true' pattern/pieces.geojson || fail "no mirrored pieces in this test"
less 1.95 "$(value pattern between_pieces_px)" || fail "pieces lie $(value pattern between_pieces_px) px apart, not 2"
less "$(value pattern coverage_before_fraction)" "$(value pattern coverage_fraction)" || fail "a pattern gains nothing"
echo "ok pattern"

# The files alone give the same bytes of the pictures, which differ from those without deformation.
sha256sum deformed/collage.png deformed/collage.svg >sums
cmp -s plain/collage.png deformed/collage.png && fail "the picture does not show it"
run 0 draw deformed --png --svg --pdf --quiet
sha256sum --quiet -c sums || fail "tessera draw makes other pictures"
[[ $(grep -c '<use ' deformed/collage.svg) -ge $(poses deformed | wc -l) ]] || fail "a piece is missing in collage.svg"
echo "ok pictures"

cat job.toml - >named.toml <<'END'
[[shapes]]
names = ['star', 'leaf']
deform = 'no'
END
run 0 collage named.toml --out named --quiet
rows() { grep '"type":"Feature",' "$1/pieces.geojson" | sed 's/,$//' | grep -E '"shape":"(star|leaf)"'; }
[[ $(rows named | wc -l) -ge 1 ]] || fail "no such pieces in this test"
cmp <(rows plain) <(rows named) || fail "shapes are deformed that were not to be"
echo "ok shapes"

# A polygon that does not belong to its shape.
cp -r deformed forged
sed -i '0,/"coordinates":\[\[\[[^]]*\],/s//"coordinates":[[/' forged/pieces.geojson
run 2 draw forged --png
expect_word "pieces.geojson"
run 2 refine plain --deform=melted
expect_word "melted"
run 2 collage job.toml --set deform.kind=melted --out none
expect_word "deform.kind"
run 2 collage job.toml --set deform.most_px=-1 --out none
expect_word "deform.most_px"
echo "ok refused"
