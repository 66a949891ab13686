#!/usr/bin/env bash
# browser_test.sh TESSERA NEW_FOLDER smoke|long: pages of small results, opened in Chromium without a window and without a network.
set -euo pipefail
tessera=$1
folder=$2
part=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=tests/web/npm_fixture.sh
source "$here/npm_fixture.sh"
# shellcheck source=tests/support/drawings.sh
source "$here/../support/drawings.sh"
chromium=$(command -v chromium || command -v chromium-browser) || skip "chromium is missing, in which the pages are tested"
need node "runs the tests"
need npm "installs playwright-core and axe-core"

rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
cp "$here"/package*.json "$here"/*.mjs .
install_packages

# Says what failed, with what the program printed.
run() {
  timeout 120 "$tessera" "$@" >output 2>errors || {
    echo "FAILED exit code $?: tessera $*"
    cat output errors
    exit 1
  }
}

make_job() { # LIBRARY
  cat <<END_OF_JOB
quality = 'draft'
[library]
file = '$1'
[canvas]
size_px = [300, 200]
[pieces]
scale_px = [14, 60]
[stop]
pieces = 40
[output]
width_px = 900
END_OF_JOB
}

make_drawings drawings
run library build drawings -o own.h5
make_job own.h5 >job.toml
run collage job.toml --out result --quiet
run collage job.toml --out other --quiet --set seed=2
run report result -o result.html
run report result other -o both.html

# Names from the wild: markup, quotes, marks of direction, separators of lines. A folder's name ends in the middle of "</script>".
wild="wild/<"
mkdir -p "$wild"
cp drawings/bean.svg "$wild/script><img src=x onerror=window.__hacked=1>.svg"
cp drawings/star.svg "$wild/<script>window.__hacked=2<.svg"
cp drawings/corner.svg "$wild/\"'\`\$(touch hacked)&lt;b&gt;!--><svg onload=window.__hacked=3>.svg"
cp drawings/leaf.svg "$wild/"$'\u202egnp.exe\u2066 \u2028\u2029 line\u200f.svg'
cp drawings/drop.svg "$wild/<!--<script>{{constructor.constructor(\"window.__hacked=4\")()}}.svg"
run library build wild -o wild.h5
make_job wild.h5 >wild.toml
hostile="it's <img src=x onerror=window.__hacked=5> & \$(touch hacked)"
run collage wild.toml --out "$hostile" --quiet
run report "$hostile" -o hostile.html
run report "$hostile" result -o hostile_both.html

export TESSERA=$tessera CHROMIUM=$chromium SHOTS=$here/shots
# Files run one after the other: a browser of each would share the cores.
exec timeout "$([[ $part == long ]] && echo 1200 || echo 300)" node --test --test-reporter=spec --test-concurrency=1 "$part"*.test.mjs
