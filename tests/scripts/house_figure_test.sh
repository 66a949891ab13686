#!/usr/bin/env bash
# house_figure_test.sh: docs/house.svg shows the rooms of src/ and their present includes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
figure=$(mktemp)
trap 'rm -f "$figure"' EXIT
scripts/house_figure.py "$figure"
cmp "$figure" docs/house.svg || { echo "FAILED docs/house.svg is outdated: scripts/house_figure.py draws it again"; exit 1; }
