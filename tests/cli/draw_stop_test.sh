#!/usr/bin/env bash
# draw_stop_test.sh TESSERA NEW_FOLDER: tessera draw is stopped while it draws a canvas that takes long. It also works if the program that
# started it ignores SIGCHLD, which children inherit.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/restart_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/restart_fixture.sh"

make_job 0
square="<rect x='10' y='10' width='80' height='80'"
echo "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>$square/></svg>" >canvas.svg
sed -i "s/^size_px.*/file = 'canvas.svg'\nsize_px = [120, 120]/" job.toml
start 1 result --set stop.pieces=2
expect_end 0 "the collage"

# Blurs that take librsvg minutes.
{
  echo "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'><filter id='f'>"
  for ((i = 0; i < 20000; ++i)); do echo "<feGaussianBlur stdDeviation='50'/>"; done
  echo "</filter>$square filter='url(#f)'/></svg>"
} >canvas.svg
for signal in INT TERM USR2; do
  "$tessera" draw result >output 2>errors &
  started=$!
  until [[ $(pgrep -c -P "$started" tessera-drawer) -gt 0 ]] || ! kill -0 "$started" 2>/dev/null; do sleep 0.01; done
  sleep 0.5
  began_ms=$(date +%s%3N)
  kill -s "$signal" "$started"
  expect_end 75 "$signal while the canvas is drawn"
  (($(date +%s%3N) - began_ms < 2000)) || fail "$signal: took $(($(date +%s%3N) - began_ms)) ms"
  grep -q 'drawing interrupted: the same command goes on' errors || fail "$signal: does not say how to go on"
done
echo "ok a stop while the canvas is drawn"

# A process that ignores SIGCHLD cannot learn how its children ended: neither the child that tries a library, nor a drawer.
rm -rf result
sed -i "s/^file = 'canvas.svg'//" job.toml
env --ignore-signal=CHLD "$tessera" library build drawings -o again.h5 >output 2>errors || fail "library build"
cmp own.h5 again.h5 || fail "another library"
env --ignore-signal=CHLD "$tessera" collage job.toml --out result --quiet --set stop.pieces=2 >output 2>errors ||
  fail "collage"
[[ -s result/collage.png ]] || fail "no picture"
echo "ok an ignored SIGCHLD"
