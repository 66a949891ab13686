#!/usr/bin/env bash
# kept_inputs_test.sh TESSERA NEW_FOLDER: an input is never removed or replaced.
# This holds even if its name is that of an output, of a temporary file, or of the list beside a library.
# Neither is any other file of the user with such a name.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

enter_folder
# An ellipse in a frame, which can be cut into pieces.
echo "<svg xmlns='http://www.w3.org/2000/svg' width='160' height='120'><rect width='160' height='120' fill='#48c'/>
  <circle cx='60' cy='50' r='40' fill='#fc4'/><path d='M40 60q40 40 80 0' stroke='#000' stroke-width='9'/></svg>" >sun.svg
rsvg-convert sun.svg -o sun.png
drawing=(drawings/*.svg)

# kept FILE COMMAND...: the command ends with an error, and FILE is unchanged.
kept() {
  local before
  before=$(sha256sum "$1") || fail "no file $1"
  run '1 2' "${@:2}"
  [[ $(sha256sum "$1") == "$before" ]] || fail "$1 is gone, or another file: ${*:2}"
  grep -qF "$(basename "$1" .tmp)" errors || fail "does not name $1: ${*:2}"
}

cp own.h5 x.h5.tmp
kept x.h5.tmp library subset x.h5.tmp --include '*' -o x.h5
kept x.h5.tmp library merge own.h5 x.h5.tmp -o x.h5
cp own.h5 list.left_out.txt
kept list.left_out.txt library subset list.left_out.txt --include '*' -o list.h5
kept list.left_out.txt library merge own.h5 list.left_out.txt -o list.h5
cp "${drawing[0]}" built.h5.tmp
kept built.h5.tmp library build built.h5.tmp -o built.h5
echo mine >notes.left_out.txt
kept notes.left_out.txt library build drawings -o notes.h5
cp own.h5 sheet.png.tmp
kept sheet.png.tmp library info sheet.png.tmp --sheet sheet.png
cp sun.png photo.h5.tmp
kept photo.h5.tmp library extract photo.h5.tmp --element-px 60 -o photo.h5
cp sun.png ground.png.tmp
kept ground.png.tmp library extract ground.png.tmp --element-px 60 -o new.h5 --ground ground.png
cp sun.png mosaic.toml.tmp
kept mosaic.toml.tmp mosaic mosaic.toml.tmp own.h5 --job mosaic.toml --job-only
kept mosaic.toml.tmp mosaic sun.png own.h5 --salient mosaic.toml.tmp --job mosaic.toml --job-only
cp own.h5 pairs.json.tmp
kept pairs.json.tmp bench pairs --quick --library pairs.json.tmp --out pairs.json
kept own.h5 bench pairs --quick --library own.h5 --out own.h5
kept sun.png bench pairs --quick --out sun.png

write_job '120, 90' '14, 40' 120
mkdir result
cp sun.svg result/collage.svg.tmp
cp own.h5 result/job.toml.tmp
kept result/collage.svg.tmp collage job.toml --out result --set 'canvas.file=result/collage.svg.tmp'
rm result/collage.svg.tmp
kept result/job.toml.tmp collage job.toml --out result --set 'library.file=result/job.toml.tmp'
cp sun.svg layout.svg.tmp
mkdir layout && mv layout.svg.tmp layout
kept layout/layout.svg.tmp nest layout/layout.svg.tmp --sheet 300,300 --effort draft --out layout
echo "ok what is read is kept"

# Two jobs need files of the same name beside them: the second is refused.
run 0 puzzle make sun.png --pieces 6 --out cut
run 0 library build cut/pieces -o cut.h5 --puzzle
python3 - "$tessera" <<'PYTHON' || fail "two jobs of one name were written at a time"
import fcntl, subprocess, sys, struct
held = open("twin_pieces.geojson.lock", "w")
fcntl.lockf(held, fcntl.LOCK_EX)
ended = subprocess.run([sys.argv[1], "puzzle", "solve", "cut.h5", "--size", "160,120", "--job", "twin.job", "--job-only"],
                       capture_output=True, text=True)
sys.exit(not (ended.returncode == 2 and "twin_pieces.geojson: another run is at work here" in ended.stderr))
PYTHON
echo "ok one run at a time writes the files beside a job"
