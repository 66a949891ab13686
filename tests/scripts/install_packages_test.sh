#!/usr/bin/env bash
# scripts/install-packages.sh on a stand-in for dpkg and apt: what is missing is asked for, nothing else.
# shellcheck disable=SC2016  # the stand-ins expand their variables themselves
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

sandbox=$(mktemp -d)
trap 'rm -rf "$sandbox"' EXIT
mkdir "$sandbox/bin" "$sandbox/scripts"
cp scripts/install-packages.sh "$sandbox/scripts"
cat >"$sandbox/scripts/packages.txt" <<'END'
# a comment

here   # is installed
absent # is not
gone++ # was removed
END

stand_in() {  # NAME, script on standard input
  { echo '#!/bin/bash'; cat; } >"$sandbox/bin/$1"
  chmod +x "$sandbox/bin/$1"
}
stand_in sudo <<<'exec "$@"'
stand_in apt-get <<<'echo "$@" >>"$CALLS"; exit "${APT_STATUS:-0}"'
stand_in dpkg-query <<<'printf "%b" "$INSTALLED"; exit 1'

# Runs the script with these installed packages; its output, exit status and apt-get's arguments go to variables.
install_with() {
  : >"$sandbox/calls"
  status=0
  output=$(CALLS=$sandbox/calls INSTALLED=$1 PATH=$sandbox/bin:$PATH \
           "$sandbox/scripts/install-packages.sh" 2>&1) || status=$?
  calls=$(<"$sandbox/calls")
}

expect() {  # DESCRIPTION, then a condition
  local description=$1
  shift
  if ! "$@"; then
    printf 'FAILED: %s\nstatus %s\ncalls: %s\noutput: %s\n' "$description" "$status" "$calls" "$output" >&2
    exit 1
  fi
}

install_with 'installed here\nconfig-files gone++\n'
expect 'success' [ "$status" -eq 0 ]
expect 'installs what is missing or was removed' \
  [ "${calls##*Timeout=120 }" = 'install --no-install-recommends absent gone++' ]
expect 'says why' grep -q 'absent # is not' <<<"$output"

install_with 'installed here\ninstalled absent\ninstalled gone++\n'
expect 'success where all is there' [ "$status" -eq 0 ]
expect 'does nothing where all is there' [ -z "$calls$output" ]

APT_STATUS=100 install_with 'installed here\n'
expect 'a failing apt-get is a failure' [ "$status" -eq 1 ]
expect 'and says so' grep -q 'apt-get install failed' <<<"$output"
echo "install-packages.sh passes"
