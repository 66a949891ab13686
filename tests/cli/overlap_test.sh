#!/usr/bin/env bash
# overlap_test.sh TESSERA NEW_FOLDER: checks the statement of docs/job-format.md about `pieces.overlap_px`: the total overlap as a share of
# the canvas, by the size of the smallest pieces.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

clipart=$(dpkg -L openclipart-svg 2>/dev/null | grep -x '.*/animals/bugs')
[[ -n $clipart ]] || fail "no openclipart-svg: scripts/install-packages.sh"
document=$(dirname "${BASH_SOURCE[0]}")/../../docs/job-format.md
document=$(tr '\n' ' ' <"$document")
new_folder
run 0 library build "$clipart" -o bugs.h5

# expect_overlap SMALLEST_PX LEAST MOST: bounds in percent of the canvas
expect_overlap() {
  printf "quality = 'draft'\n[library]\nfile = 'bugs.h5'\n[canvas]\nsize_px = [%d, %d]\n[pieces]\nscale_px = [%d, %d]\n" \
    $((30 * $1)) $((25 * $1)) "$1" $((8 * $1)) >job.toml
  run 0 collage job.toml --out "of_$1" --quiet
  python3 - "of_$1/card.json" "$2" "$3" <<'PYTHON' || fail "pieces from $1 px overlap by more or less than $2 to $3 %"
import json, re, sys
fraction = float(re.search(r'"overlap_fraction": *([0-9.e-]+)', open(sys.argv[1]).read())[1])
print(fraction)
sys.exit(not float(sys.argv[2]) <= 100 * fraction <= float(sys.argv[3]))
PYTHON
}

[[ $document == *'In all that is 0.15 to 0.5 % of the canvas with pieces of 20 px and more.'* ]] || fail "another sentence"
expect_overlap 20 0.15 0.5
[[ $document == *'about 0.8 % with pieces from 8 px, 1 to 2 % from 4 px'* ]] || fail "another sentence"
expect_overlap 8 0.6 1
expect_overlap 4 1 2.2
echo "ok overlap by size"
