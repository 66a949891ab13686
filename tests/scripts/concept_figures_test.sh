#!/usr/bin/env bash
# concept_figures_test.sh PROGRAM: the figures of docs/concepts are those that the program draws today, and each page of the concepts has a
# figure.
set -euo pipefail
program=$1
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
fail() { echo "FAILED $1"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

TESSERA=$program scripts/concept-figures.sh "$work" >"$work/output" 2>&1 || fail "scripts/concept-figures.sh: $(tail -n 3 "$work/output")"
for figure in "$work"/*.svg; do
  cmp "$figure" "docs/concepts/${figure##*/}" || fail "${figure##*/} is outdated: scripts/concept-figures.sh draws it again"
done
echo "ok"
