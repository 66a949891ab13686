#!/usr/bin/env bash
# scripts/silhouette_twins.py: twins are a turned and enlarged copy, and a mirror image of a mirrored silhouette; another shape or another
# class is no twin.
# Exit code 77 (skipped) without Debian's python3-numpy and python3-pil.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

/usr/bin/python3 -c 'import numpy, PIL' 2>/dev/null || exit 77
sandbox=$(mktemp -d)
trap 'rm -rf "$sandbox"' EXIT
fail() {
  echo "FAILED $1"
  exit 1
}

mkdir "$sandbox/masks"
/usr/bin/python3 - "$sandbox/masks" <<'END'
import math, sys
from PIL import Image, ImageDraw

HOOK = [(-50, -40), (50, -40), (50, -10), (-10, -10), (-10, 50), (-50, 50)]

def draw(name, points, angle=0.0, scale=2.0):
    image = Image.new("L", (400, 400))
    cos, sin = math.cos(angle) * scale, math.sin(angle) * scale
    ImageDraw.Draw(image).polygon([(200 + cos * x - sin * y, 200 + sin * x + cos * y) for x, y in points], fill=255)
    image.save(f"{sys.argv[1]}/{name}.png")

draw("hook-1", HOOK)
draw("hook-2", HOOK, 0.7, 2.6)
draw("hook-3", [(-x, y) for x, y in HOOK], 0.2)
draw("hook-4", [(-50, -50), (50, -50), (50, 50), (-50, 50)])
draw("crook-1", HOOK, 0.4)
END
/usr/bin/python3 scripts/silhouette_twins.py "$sandbox/masks" "$sandbox/twins.txt"
wanted="hook-1 hook-2
hook-1 ~hook-3
hook-2 ~hook-3
hook-4 ~hook-4"
[[ $(cut -d ' ' -f 1,2 "$sandbox/twins.txt") == "$wanted" ]] || fail "twins: $(<"$sandbox/twins.txt")"
if /usr/bin/python3 scripts/silhouette_twins.py "$sandbox/masks" 2>/dev/null; then fail "takes one argument"; fi
echo "ok"
