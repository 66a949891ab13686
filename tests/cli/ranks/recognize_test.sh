#!/usr/bin/env bash
# recognize_test.sh TESSERA MPIRUN NEW_FOLDER: finds a clipped and turned drawing, the same on one rank and on three.
# The exit code says that a drawing is not in the library. Files that are no queries are named.
set -uo pipefail
tessera=$1
mpirun=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../command_fixture.sh"
enter_folder

# Half of the bean, turned and enlarged; and a hand that is not in the library.
cat >torn.svg <<'END'
<svg xmlns='http://www.w3.org/2000/svg' width='300' height='300'><clipPath id='c'><rect x='0' y='0' width='60' height='100'/></clipPath>
<g transform='rotate(40 150 150) scale(2) translate(20 20)'><path clip-path='url(#c)' d='M10 50 C10 10 90 10 90 50 C90 90 70 60 50 60 C30 60 10 90 10 50Z'/></g></svg>
END
comb="M5 40 H15 V10 H20 V40 H30 V10 H35 V40 H45 V10 H50 V40 H60 V10 H65 V40 H75 V10 H80 V40 H95 V50 H5Z"
draw_svg comb "$comb"
# A whole star beside two combs: it is a small part of all outlines, but all of the star's outline.
cat >beside.svg <<END
<svg xmlns='http://www.w3.org/2000/svg' width='300' height='160'>
<path d='M50 5 L61 38 L95 38 L67 59 L78 93 L50 72 L22 93 L33 59 L5 38 L39 38Z'/>
<path transform='translate(100 0)' d='$comb'/><path transform='translate(100 60)' d='$comb'/></svg>
END

run 0 recognize torn.svg drawings/star.svg --library own.h5 --json one.json --sheet one.png
grep -qE '^bean +0\.[5-9]' output || fail "the bean is not found"
grep -qE '^star +(0\.9|1\.0).* 1\.000 ' output || fail "the star is not found at its own scale"
[[ $(head -c 8 one.png | od -An -tx1 | tr -d ' ') == 89504e470d0a1a0a ]] || fail "no sheet"
run_on_ranks 3 0 recognize torn.svg drawings/star.svg --library own.h5 --json three.json --quiet
cmp one.json three.json || fail "another answer on three ranks"
python3 - <<'END' || fail "another JSON"
import json
told = json.load(open("one.json"))
assert [q["file"] for q in told["queries"]] == ["torn.svg", "drawings/star.svg"]
best = told["queries"][0]["shapes"][0]
assert 0.5 < best["score"] < 1, best
star = told["queries"][1]["shapes"][0]
assert star["shape"] == "star" and abs(star["score"] - star["similarity"]) < 0.05, star
assert best["shape"] == "bean" and abs(best["scale"] - 2) < 0.1 and abs(best["rotation_deg"] - 40) < 3, best
END
echo "ok found"

run 0 recognize torn.svg --library own.h5 --scale 2 --top 1
[[ $(grep -cE '^(bean|star|corner|leaf|drop) ' output) == 1 ]] || fail "more than one shape of --top 1"
run 3 recognize torn.svg --library own.h5 --scale 0.2
grep -qF 'no shape of the library' output || fail "a scale that no shape has"
run 3 recognize comb.svg --library own.h5 --json comb.json
grep -qF 'no shape of the library' output || fail "what is not in the library is not told"
[[ -s comb.json ]] || fail "no JSON of an unknown query"
run 0 recognize beside.svg --library own.h5
grep -qE '^star +0\.2[0-9]* +0\.5' output || fail "the star has another similarity or score: $(cat output)"
run 3 recognize beside.svg --library own.h5 --least 0.6
grep -qF "the best shape's score is below 0.60 (--least)" output || fail "not said why"
echo "ok unknown"

echo "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>" >empty.svg
echo nonsense >bad.png
run 2 recognize empty.svg --library own.h5
expect_word empty.svg
run 2 recognize bad.png --library own.h5
expect_word bad.png
run 2 recognize none.png --library own.h5
expect_word none.png
run 3 recognize none.png torn.svg bad.png --library own.h5 --json some.json --sheet some.png
expect_word 'warning: skipped: none.png'
expect_word 'warning: skipped: bad.png'
grep -qE '^bean +0\.[5-9]' output || fail "files that cannot be read cost the answers of others"
python3 - <<'END' || fail "the JSON does not name what could not be read"
import json
told = json.load(open("some.json"))
assert [q["file"] for q in told["queries"]] == ["torn.svg"] and told["queries"][0]["shapes"][0]["shape"] == "bean"
assert [q["file"] for q in told["unread"]] == ["none.png", "bad.png"] and all(q["reason"] for q in told["unread"])
END
run 2 recognize torn.svg --library none.h5
expect_word none.h5
run 2 recognize torn.svg --library own.h5 --scale -1
expect_word --scale
for output in '--json none/a.json' '--sheet none/a.png'; do
  # shellcheck disable=SC2086
  run 1 recognize torn.svg --library own.h5 $output
  expect_word "${output#* }"
  ! grep -q bean output || fail "searched before it was known that $output cannot be written"
done
echo "ok mistakes"
