#!/usr/bin/env bash
# scripts/emoji_glyphs.py on Debian's emoji: it writes a picture for each glyph, named after its characters.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly font=/usr/share/fonts/truetype/noto/NotoColorEmoji.ttf
sandbox=$(mktemp -d)
trap 'rm -rf "$sandbox"' EXIT
fail() {
  echo "FAILED $1"
  exit 1
}
[[ -e $font ]] || fail "no $font: scripts/install-packages.sh long-tests"

said=$(/usr/bin/python3 scripts/emoji_glyphs.py "$font" "$sandbox/emoji")
count=$(find "$sandbox/emoji" -name '*.png' | wc -l)
[[ $said == "$count pictures in $sandbox/emoji" && $count -gt 3000 ]] || fail "$count pictures, and it says: $said"
[[ $(head -c 4 "$sandbox/emoji/grinning_face.png" | tail -c 3) == PNG ]] || fail "no picture of one character"
[[ -e $sandbox/emoji/ear_of_rice_adult.png ]] || fail "no name of several characters"
[[ -e $sandbox/emoji/waving_hand_sign_skin-3.png ]] || fail "no name of a skin tone"
if /usr/bin/python3 scripts/emoji_glyphs.py "$font" 2>/dev/null; then fail "takes one argument"; fi
echo "$count pictures"
