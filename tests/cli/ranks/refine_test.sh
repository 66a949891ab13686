#!/usr/bin/env bash
# refine_test.sh TESSERA MPIRUN NEW_FOLDER: the pieces of finished results relax. They cover more, locked pieces stay, and the earlier
# result is unchanged.
# The new result is the same on one rank and on three. Folders without a result to refine are refused.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"

enter_folder
cat >job.toml <<'END'
quality = 'draft'
[library]
file = 'own.h5'
[canvas]
size_px = [240, 180]
[pieces]
scale_px = [20, 80]
mirrored = 'also'
[[given]]
shape = 'star'
at_px = [100.12345, 90]
scale_px = 50.33333
rotation_deg = 20.12345
[output]
width_px = 120
END
features() { grep '"type":"Feature",' "$1/pieces.geojson"; }
count() { features "$1" | wc -l; }
locked() { features "$1" | grep '"locked":true' | sed 's/,$//'; }
digest() { (cd "$1" && find . -type f -exec sha256sum {} + | sort); }
covered() { sed -n 's/.*"coverage_fraction": \(.*\),/\1/p' "$1/card.json"; }
expect_more_covered() { # BEFORE AFTER
  [[ $(printf '%s\n' "$(covered "$1")" "$(covered "$2")" | sort -g | tail -1) == "$(covered "$2")" &&
    $(covered "$1") != "$(covered "$2")" ]] || fail "$2 covers $(covered "$2"), $1 $(covered "$1")"
}

run 0 collage job.toml --out first --quiet
digest first >before
same_on_3_ranks relaxed refine first --relax --quiet
expect_silence "a result relaxes"
digest first | cmp - before || fail "the result has changed"
expect_more_covered first relaxed
[[ $(locked first | wc -l) == 1 ]] || fail "locked: $(locked first)"
cmp <(locked first) <(locked relaxed) || fail "the given piece has moved"
grep -q '"mirrored":true' relaxed/pieces.geojson || fail "nothing is mirrored"
echo "ok relaxed"

# Pieces that start.pieces locked stay, too. A result with a limit of [stop] gets no more pieces.
sed -n '1p;3,6p' first/pieces.geojson | sed '$s/,$/]}/' >some.geojson
run 0 collage job.toml --set start.pieces=some.geojson --set stop.pieces=8 --out few --quiet
run 0 refine few/ --relax --quiet
expect_more_covered few few-relaxed
[[ $(locked few | wc -l) == 5 && $(count few-relaxed) == 8 ]] || fail "$(locked few | wc -l), $(count few-relaxed)"
cmp <(locked few) <(locked few-relaxed) || fail "locked pieces have moved"
run 0 refine few-relaxed --relax --trials 3 --out again --quiet --set 'pieces.scale_px=[14, 90]'
expect_word "warning: the pieces are not relaxed, as their sizes differ too much, 14 to 90 px"
cmp <(locked few) <(locked again) || fail "locked pieces have moved the second time"
echo "ok limits"

cat >parts.svg <<'END'
<svg xmlns="http://www.w3.org/2000/svg" width="240" height="120">
<rect width="90" height="120" fill="#ff0000"/><rect x="90" width="150" height="120" fill="#0000ff"/></svg>
END
cat >parts.toml <<'END'
quality = 'draft'
[library]
file = 'own.h5'
[canvas]
size_px = [240, 120]
file = 'parts.svg'
[pieces]
scale_px = [20, 80]
[[regions]]
name = 'left'
colour = '#ff0000'
[[regions]]
name = 'right'
colour = '#0000ff'
[output]
width_px = 120
END
run 0 collage parts.toml --out parts --quiet
run 0 refine parts --relax --quiet
expect_more_covered parts parts-relaxed
[[ $(features parts-relaxed | grep -cFf <(features parts | sed 's/.*\("scale":.*"y_px":[^,]*\),.*/\1/')) -le 1 ]] ||
  fail "pieces of a region have not moved"
echo "ok regions"

# refused MESSAGE ARGUMENT...: the message is one line
refused() {
  run 2 refine "${@:2}"
  expect_word "$1"
  [[ $(wc -l <errors) == 1 ]] || fail "not one line: $1"
}
mkdir empty
refused 'empty/manifest.json: not found; allowed: the folder of a result' empty --relax
refused '--out: found ./first/, the result itself' first --relax --out ./first/
refused '--set start.keep=locked: the pieces come from RESULT; allowed: start.grow' first --relax \
  --set start.keep=locked
refused '--trials: found 1, allowed: 2 or more, one for each of the [[regions]]' parts --relax --trials 1
refused 'first: made from other input; canvas.size_px: then [240, 180], now [400, 300]' first --relax \
  --set 'canvas.size_px=[400, 300]'
"$tessera" collage job.toml --set improve.trials=1000000 --out busy --quiet >output 2>errors &
started=$!
until [[ -s busy/run.lock ]] || ! kill -0 "$started" 2>/dev/null; do sleep 0.01; done
refused "busy: no whole result is there yet: a run is at work here: process $started on" busy --relax
run 2 draw busy
expect_word "busy: no whole result is there yet: a run is at work here: process $started on"
run 2 collage job.toml --set start.pieces=busy --out from_busy
expect_word "busy: found a folder without pieces.geojson; a run is at work here: process $started on"
kill -s INT "$started"
wait "$started"
cp -r first unfinished
touch unfinished/checkpoint.h5
refused 'unfinished: found unfinished work, allowed: a finished result; the command that made it finishes it with' \
  unfinished --relax
cp -r first damaged
sed -i '3s/"x_px":/"x_px":1/' damaged/pieces.geojson
refused 'damaged/pieces.geojson: ' damaged --relax
mv own.h5 moved.h5
refused "own.h5: no such file" first --relax
run 0 refine first --relax --quiet --set library.file=moved.h5 --out moved
cmp relaxed/pieces.geojson moved/pieces.geojson || fail "other pieces from a library that has moved"
draw_svg drawings/bean "M10 50 C10 10 90 10 90 50Z"
run 0 library build drawings -o own.h5
refused "first: made from other input; library.file: another content: " first --relax
digest first | cmp - before || fail "the result has changed"
echo "ok errors"
