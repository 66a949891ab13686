#!/usr/bin/env bash
# scripts/install-packages.sh with replacements of dpkg and apt: it asks for the missing packages of the named sections, and for no others.
# The test also checks the sections of scripts/packages.txt.
# shellcheck disable=SC2016  # the stand-ins expand their variables themselves
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

sandbox=$(mktemp -d)
trap 'rm -rf "$sandbox"' EXIT
mkdir "$sandbox/bin" "$sandbox/scripts"
cp scripts/install-packages.sh "$sandbox/scripts"
cat >"$sandbox/scripts/packages.txt" <<'END'
# a comment

[program]
here   # is installed
absent # is not
gone++ # was removed
[tests]
# another comment
checker # for tests
[long-tests]
browser # for long tests
END

stand_in() {  # NAME, script on standard input
  { echo '#!/bin/bash'; cat; } >"$sandbox/bin/$1"
  chmod +x "$sandbox/bin/$1"
}
stand_in sudo <<<'exec "$@"'
stand_in apt-get <<<'echo "$@" >>"$CALLS"; exit "${APT_STATUS:-0}"'
stand_in dpkg-query <<<'printf "%b" "$INSTALLED"; exit 1'

# install_with INSTALLED SECTION...: runs the script. Variables get its output, its exit status and the arguments of apt-get.
install_with() {
  : >"$sandbox/calls"
  status=0
  output=$(CALLS=$sandbox/calls INSTALLED=$1 PATH=$sandbox/bin:$PATH \
           "$sandbox/scripts/install-packages.sh" "${@:2}" 2>&1) || status=$?
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

expect_installed() { # DESCRIPTION PACKAGES
  expect "$1: success" [ "$status" -eq 0 ]
  expect "$1" [ "${calls##*Timeout=120 }" = "install --no-install-recommends $2" ]
}

install_with 'installed here\nconfig-files gone++\n'
expect_installed 'installs what is missing or was removed of the program' 'absent gone++'
expect 'says why' grep -q 'absent # is not' <<<"$output"
install_with 'installed here\n' program tests
expect_installed 'installs two sections' 'absent gone++ checker'
install_with 'installed here\n' program tests long-tests
expect_installed 'installs three sections' 'absent gone++ checker browser'
install_with '' tests
expect_installed 'installs one section' checker

stand_in npm <<<''
echo 'npm # of Debian' >>"$sandbox/scripts/packages.txt" # in the last section
install_with '' long-tests
expect_installed 'an npm of another package will do' browser

install_with 'installed here\ninstalled absent\ninstalled gone++\n'
expect 'success where all is there' [ "$status" -eq 0 ]
expect 'does nothing where all is there' [ -z "$calls$output" ]

install_with '' program test
expect 'an unknown section is refused' [ "$status" -eq 2 ]
expect 'with those that there are' grep -q 'test: no such section, allowed: program tests long-tests' <<<"$output"
expect 'before anything is installed' [ -z "$calls" ]

APT_STATUS=100 install_with 'installed here\n'
expect 'a failing apt-get is a failure' [ "$status" -eq 1 ]
expect 'and says so' grep -q 'apt-get install failed' <<<"$output"

# Checks of the list itself.
list=scripts/packages.txt
output=$(grep -vnE '^(#.*|\[[a-z-]+\]|[a-z0-9.+-]+ +# .+|)$' "$list" || true)
expect 'a line is a comment, a heading, or a package and why' [ -z "$output" ]
output=$(awk '/^\[/ { exit } NF && $1 !~ /^#/' "$list")
expect 'no package stands before the first heading' [ -z "$output" ]
output=$(awk 'NF && $1 !~ /^#/ { print $1 }' "$list" | sort | uniq -d)
expect 'no heading and no package stands twice' [ -z "$output" ]
expect 'the sections' [ "$(grep '^\[' "$list" | paste -sd ' ')" = '[program] [tests] [long-tests] [docs]' ]

# asked_of_apt ARGUMENT...: prints the packages that apt is asked for on a machine without any of them, one a line.
cp "$list" "$sandbox/scripts"
asked_of_apt() {
  install_with '' "$@"
  expect "$*: success" [ "$status" -eq 0 ]
  tr ' ' '\n' <<<"${calls##*--no-install-recommends }"
}
# sections_of SCRIPT: prints the sections that the script asks for.
sections_of() { sed -n 's/^scripts\/install-packages.sh *\([a-z -]*\).*/\1/p' "scripts/$1"; }
for_tests_alone='valgrind|libc6-dbg|slurm-wlm|munge|mesa-opencl-icd|llvm-15|libclc-15|inkscape|chromium|libgtest-dev'
read -ra arguments < <(sections_of demo.sh)
asked_of_apt "${arguments[@]}" >"$sandbox/demo"
output=$(grep -xE "$for_tests_alone" "$sandbox/demo" || true)
expect 'the demonstration installs nothing for tests' [ -z "$output" ]
expect 'but its drawings' grep -qx openclipart-svg "$sandbox/demo"
asked_of_apt program tests >"$sandbox/tests"
output=$(grep -xE 'valgrind|libc6-dbg|mesa-opencl-icd|inkscape' "$sandbox/tests" || true)
expect 'the tests install nothing for long ones' [ -z "$output" ]
for package in g++ slurm-wlm libgtest-dev chromium nodejs; do
  expect "the tests install $package" grep -qx "$package" "$sandbox/tests"
done
echo "install-packages.sh passes"
