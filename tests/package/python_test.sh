#!/usr/bin/env bash
# python_test.sh CMAKE BUILD_FOLDER NEW_FOLDER PYTHON: installs the module tessera, moves it elsewhere, and runs its tests and the programs
# of examples/python.
set -uo pipefail
cmake=$1
build=$2
folder=$3
python=$4
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../cli/command_fixture.sh"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source_folder=$(cd "$here/../.." && pwd)
unset TESSERA_DRAWER

new_folder
"$cmake" --install "$build" --prefix "$folder/first" >output 2>errors || fail "cmake --install"
mkdir elsewhere
mv first elsewhere/tessera
prefix=$folder/elsewhere/tessera
tessera=$prefix/bin/tessera
make_drawings drawings
run 0 library build drawings -o own.h5
write_job '120, 90' '14, 60' 120
run 0 collage job.toml --out result --quiet

export PYTHONPATH=$prefix/lib/python3/dist-packages PYTHONDONTWRITEBYTECODE=1 MPLCONFIGDIR=$folder
TESSERA_DUCKS=$source_folder/docs/matching TESSERA_LIBRARY=own.h5 TESSERA_RESULT=result \
  "$python" "$here/python_module_test.py" >output 2>&1 || fail "the module's tests: $(tail -c 3000 output)"
grep -q '^OK$' output || fail "skipped tests: $(tail -3 output)"
echo "ok the module"

examples=$prefix/share/tessera/examples/python
shown=$(awk '/^```python$/ { on = 1; next } /^```$/ && on { exit } on' "$prefix/share/tessera/docs/library.md")
[[ -n $shown && $(<"$examples/match_drawings.py") == *"$shown"* ]] ||
  fail "docs/library.md shows something else than match_drawings.py"
ducks=$source_folder/docs/matching
"$python" "$examples/match_drawings.py" "$ducks/duck.svg" "$ducks/duck-4.svg" >output 2>errors || fail "match_drawings.py"
head -1 output | grep -qE '^score 0\.65[0-9]: 67\.[0-9] % of A, scale 1\.11[0-9], turned by -1\.39[0-9] rad$' ||
  fail "another match: $(cat output)"
"$python" "$examples/draw_pads.py" "$ducks/duck.svg" "$ducks/duck-4.svg" pads.png >output 2>errors || fail "draw_pads.py"
grep -q '^pads.png: 48 PADs' output || fail "another word of the picture: $(cat output)"
"$python" -c 'import sys, numpy, PIL.Image
picture = numpy.asarray(PIL.Image.open("pads.png").convert("L"))
sys.exit(0 if picture.shape == (900, 1100) and 10 < picture.std() < 120 else 1)' || fail "pads.png is no such picture"
echo "ok the examples"
