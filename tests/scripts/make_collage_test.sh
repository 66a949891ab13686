#!/usr/bin/env bash
# make_collage_test.sh: how scripts/collage.sh, used by demo.sh and gallery.sh, handles exit codes.
set -uo pipefail
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../scripts" && pwd)
# shellcheck source=scripts/collage.sh
source "$scripts/collage.sh"

# expect CODE_OF_THE_COLLAGE CODE WORDS
expect() {
  local said code=0
  said=$(make_collage bash -c "exit $1" 2>&1) || code=$?
  [[ $code == "$2" ]] || { echo "FAILED exit code $1 became $code, not $2"; exit 1; }
  [[ $said == *"$3"* && -n $3 || $said == "$3" ]] || { echo "FAILED exit code $1: said $said"; exit 1; }
}
expect 0 0 ""
expect 3 0 "done, but pieces are missing"
expect 2 2 ""
expect 75 75 ""
for script in demo gallery; do
  if grep -E '"\$tessera" collage' "$scripts/$script.sh" | grep -vq make_collage; then
    echo "FAILED $script.sh runs a collage without make_collage"
    exit 1
  fi
done
echo "ok exit codes of collages"
