#!/usr/bin/env bash
# report_test.sh TESSERA NEW_FOLDER: pages of one result and of several, and refinements by marks.
set -uo pipefail
tessera=$1
folder=$2
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

enter_folder
write_job '120, 90' '14, 60' 120
run 0 collage job.toml --out result --quiet --set output.report=true
[[ -s result/report.html ]] || fail "no page although output.report is set"

# page_value FILE EXPRESSION: prints a value of the page's data.
page_value() {
  python3 - "$1" "$2" <<'END'
import json, re, sys
text = open(sys.argv[1], encoding="utf-8").read()
data = json.loads(re.search(r'id="data">(.*?)</script>', text, re.S).group(1))
blocks = dict(re.findall(r'<script type="text/plain" id="([^"]+)">([^<]*)</script>', text))
print(eval(sys.argv[2]))
END
}
expect_value() { [[ $(page_value "$1" "$2") == "$3" ]] || fail "$2 of $1 is $(page_value "$1" "$2"), not $3"; }

expect_value result/report.html 'data["kind"], data["name"], data["finished"], len(data["pieces"]["shape"])' \
  "('result', 'result', True, 2)"
expect_value result/report.html '(data["canvas"]["width_px"], data["picture"]["full_width_px"])' "(120, 120)"
expect_value result/report.html 'sorted(blocks)' "['contact', 'outlines', 'tile-0-0-0-0']"
expect_value result/report.html 'data["card"]["quality"]["pieces"], len(data["gaps"]["x_px"]) > 0' "(2, True)"
expect_value result/report.html '(data["progress"] == {"s": data["card"]["growth"]["s"],
  "coverage": data["card"]["growth"]["coverage_fraction"]}, len(data["progress"]["s"]) > 0)' "(True, True)"
expect_value result/report.html '(data["job"] == open("result/job.toml").read(), data["pieces_digest"] ==
  json.load(open("result/manifest.json"))["pieces"]["digest"])' "(True, True)"
echo "ok output.report"

run 0 report result -o once.html
cmp once.html result/report.html || fail "the page of the run and of tessera report differ"
run 0 report result
cmp once.html result/report.html || fail "the same result gives another page"
grep -q '^written: result/report.html, 0.. MB' output || fail "does not say what was written"
rm result/report.html
run 0 collage job.toml --out result --resume --quiet
[[ ! -e result/report.html ]] || fail "a page although nobody wants it"
run 0 collage job.toml --out result --resume --quiet --set output.report=true
cmp once.html result/report.html || fail "a result that was finished before gets no page"
run 2 report result -o .
expect_word "--out .: found a folder, allowed: the name of a file"
run 2 report none
expect_word "none: no such folder"
cp -r result damaged
echo x >damaged/collage.png
run 0 report damaged
expect_word "the page has no picture: damaged/collage.png: "
expect_value damaged/report.html 'data["picture"]' None
echo "ok tessera report"

# Another job replaces a result: its page must not stay.
run 0 collage job.toml --out result --quiet --set seed=2
[[ ! -e result/report.html ]] || fail "the page of the result before is still there"
echo "ok no page of another result"

run 0 collage job.toml --out other --quiet --set seed=3
run 0 report result other -o both.html
expect_value both.html 'data["kind"], [r["rank"] for r in data["results"]], len(data["results"][0]["values"]) == len(data["measures"])' \
  "('campaign', [1, 2], True)"
expect_value both.html 'sorted(blocks)' "['tile-0-0-0-0', 'tile-1-0-0-0']"
run 0 rank result other --out ranking
expect_value ranking/ranking.html 'data["formula"][:8], data["measures"][0]["key"]' "('score = ', 'score')"
expect_value ranking/ranking.html 'max(abs(page["values"][0] - ranked["score"])
  for page, ranked in zip(data["results"], json.load(open("ranking/ranking.json"))["ranking"])) < 0.006' True
run 2 report result --weight overlap=-3
expect_word "--weight: found with one result, allowed: with several"
echo "ok several results"

digest=$(page_value ranking/ranking.html 'json.load(open("result/manifest.json"))["pieces"]["digest"]')
echo '{"format": 1, "pieces_digest": "'"$digest"'", "action": "erase", "pieces": [1], "lock": [0]}' >marks.json
run 0 refine result --marks marks.json --out refined --quiet
grep -q '"locked":true' refined/pieces.geojson || fail "no locked piece"
run 0 refine result --pieces 1 --lock 0 --out same --quiet
cmp refined/pieces.geojson same/pieces.geojson || fail "marks do something else than the options"
run 2 refine other --marks marks.json --out refused
expect_word "marks.json: pieces_digest: found \"$digest\", allowed: "
run 2 refine result --marks marks.json --pieces 1 --out refused
echo "ok marks"
