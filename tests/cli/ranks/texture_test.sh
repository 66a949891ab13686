#!/usr/bin/env bash
# texture_test.sh TESSERA MPIRUN NEW_FOLDER: tessera texture, from a photo to a larger texture without seams.
set -uo pipefail
tessera=$1
# shellcheck disable=SC2034 # support/ranks.sh
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"

new_folder
jobs=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../../../jobs")
cp "$jobs/photos/tiles.jpg" .

# the_same A B: the two results are of the same bytes.
the_same() {
  local file
  for file in pieces.geojson collage.png; do cmp "$1/$file" "$2/$file" || fail "another $file on other ranks"; done
}

run 0 texture tiles.jpg --element-px 160 --size 800,600 --set quality=draft
grep -qx 'tiles.jpg: 40 elements' output || fail "does not say what it found: $(cat output)"
grep -qE '^tiles_texture_layout.geojson: [0-9]+ pieces on 800 x 600 px$' output || fail "does not say what it laid"
for file in tiles_texture.toml tiles_texture.h5 tiles_texture_layout.geojson tiles_texture_ground.png \
  out/tiles_texture/collage.png; do
  [[ -s $file ]] || fail "no $file"
done
grep -qx 'background = "photo"  # what lies round each element in the photo' tiles_texture.toml || fail "another ground"
grep -qx 'seamless = "both"' tiles_texture.toml || fail "has seams"
[[ $(od -An -tu4 --endian=big -j16 -N8 out/tiles_texture/collage.png | xargs) == '800 600' ]] || fail "another size"
cp -r out/tiles_texture one_rank
cp tiles_texture.toml first.toml
run_on_ranks 3 0 texture tiles.jpg --element-px 160 --size 800,600 --set quality=draft --restart
the_same one_rank out/tiles_texture
cmp first.toml tiles_texture.toml || fail "another job on three ranks"
run 0 collage tiles_texture.toml --set quality=draft --out by_job
the_same one_rank by_job
echo "ok ranks"

run 2 texture tiles.jpg --element-px 160 --size 700,600 --set pieces.uses=none
cmp first.toml tiles_texture.toml || fail "a mistake in --set changes the job"

echo '# mine' >>tiles_texture.toml
run 0 texture tiles.jpg --element-px 160 --size 800,600 --job-only
grep -qx 'tiles_texture.toml: you have changed it, so it is kept; --job FILE.toml writes another one' output ||
  fail "does not say that a changed job is kept"
grep -qx 'next: tessera collage tiles_texture.toml' output || fail "does not say what to type next"
grep -qx '# mine' tiles_texture.toml || fail "a changed job is replaced"
run 2 texture tiles.jpg --element-px 160 --size 640,600 --job-only
expect_word 'tiles_texture.toml: you have changed it, and its canvas.size_px is [800, 600], with this --size it is [640, 600]'
sed -i 's/size_px = .*/size_px = [400, 300]/' tiles_texture.toml
run 0 texture tiles.jpg --element-px 160 --job-only
grep -qE '^tiles_texture_layout.geojson: [0-9]+ pieces on 400 x 300 px$' output || fail "not laid on the canvas of the job"
run 0 texture tiles.jpg --element-px 160 --size 200,100 --job-only --job small.toml --quiet
[[ ! -s output ]] || fail "--quiet prints"
[[ -s small.toml && -s small.h5 && ! -e out/small ]] || fail "--job names no files, or --job-only runs"
echo "ok job"

cp "$jobs/wall.toml" other.toml
run 2 texture tiles.jpg --job other.toml
expect_word 'other.toml: exists and was not made by tessera texture; give another name with --job'
cmp other.toml "$jobs/wall.toml" || fail "another's job is replaced"
cp small.h5 foreign.h5
run 2 texture tiles.jpg --job foreign.toml
expect_word 'foreign.h5: exists and was not made by tessera texture; give another name with --job'
run 2 texture none.jpg
expect_word 'none.jpg: '
run 2 texture tiles.jpg --size 63,100
expect_word '--size'
run 2 texture tiles.jpg --size 20000,10000
expect_word '--size: found 20000,10000, allowed: at most 100 million px'
run 2 texture tiles.jpg --element-px 160 --size 200,100 --job wrong.toml --set pieces.uses=none
[[ ! -e wrong.toml ]] || fail "a mistake in --set leaves a job"
rsvg-convert -w 100 -h 100 <<<"<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>" -b '#fff' -o empty.png
run 2 texture empty.png
expect_word 'empty.png: found no'
[[ ! -e empty_texture.toml ]] || fail "a photo without elements leaves a job"
echo "ok errors"

# Discs of one colour keep it: no palette of silhouettes.
echo "<svg xmlns='http://www.w3.org/2000/svg' width='200' height='160'><rect width='200' height='160' fill='#e8e8e8'/>
  <circle cx='60' cy='60' r='30' fill='#783c1e'/><circle cx='140' cy='100' r='30' fill='#783c1e'/></svg>" |
  rsvg-convert -o discs.png
run 0 texture discs.png --size 400,320
grep -qx 'pieces = "artwork"  # also where all elements have one colour' discs_texture.toml || fail "may recolour"
grep -q '"colours"' out/discs_texture/manifest.json && fail "elements of one colour are recoloured"
echo "ok colours"

# Elements of few pixels are enlarged, with and without a search, but not beyond the largest canvas.
rsvg-convert -w 50 -h 40 -b '#e8e8e8' -o few.png <<<"<svg xmlns='http://www.w3.org/2000/svg' width='50' height='40'>
  <circle cx='15' cy='15' r='7' fill='#783c1e'/><circle cx='35' cy='25' r='7' fill='#783c1e'/></svg>"
run 0 texture few.png --job-only
grep -qx 'few.png: 2 elements, enlarged 4 times' output || fail "not enlarged: $(cat output)"
rsvg-convert -w 50 -h 40 -b '#000' -f pdf -o few.pdf <<<"<svg xmlns='http://www.w3.org/2000/svg' width='50' height='40'>
  <circle cx='15' cy='15' r='7' fill='#111'/><circle cx='35' cy='25' r='7' fill='#222'/></svg>"
pdftocairo -png -gray -antialias none -singlefile -r 72 -scale-to-x 50 -scale-to-y 40 few.pdf few_labels
run 0 texture few.png --labels few_labels.png --job few_labels.toml --job-only
grep -qx 'few.png: 2 elements, enlarged 4 times' output || fail "not enlarged with labels: $(cat output)"
run 2 texture few.png --job wide.toml --size 20000,64 --job-only
expect_word 'few.png: found no whole element'
echo "ok enlarged"

# Pieces of drawings that were not cut out of a photo have no photo round them.
echo "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><circle cx='4' cy='4' r='4'/></svg>" >disc.svg
run 0 library build disc.svg -o disc.h5
printf '[library]\nfile = "disc.h5"\n[canvas]\nsize_px = [100, 100]\n[pieces]\nscale_px = 30\n' >disc.toml
run 2 collage disc.toml --set output.background=photo --set quality=draft
expect_word 'output.background: found "photo", but no drawing in'
[[ ! -e out/disc/pieces.geojson ]] || fail "finds out only after the run"
echo "ok others"
