#!/usr/bin/env bash
# scripts/renew-golden.sh "WHY": run it after a change that is meant to change results.
# It builds, stores the new digests of the small jobs in tests/golden, and adds the date and WHY, one line, to tests/golden/renewals.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

why=${1-}
if [[ $# -ne 1 || ${#why} -lt 10 || $why == *$'\n'* ]]; then
  echo 'scripts/renew-golden.sh "WHY": one line that says why the result changed, 10 characters or more' >&2
  exit 2
fi

scripts/build.sh tessera golden_inputs
tests/golden/golden_test.sh --renew "$PWD/build/release/src/cli/tessera" "$PWD/build/release/tests/golden/golden_inputs" \
  "$PWD/build/release/tests/golden/renewed"
echo "- $(date -u +%F): $why" >>tests/golden/renewals.md
git --no-pager diff --stat -- tests/golden 2>/dev/null || true
cat tests/golden/digests.txt
