#!/usr/bin/env bash
# scripts/install-packages.sh [SECTION...]: installs the missing packages of these sections of scripts/packages.txt: program (the default),
# tests, long-tests, docs. If none is missing, it does nothing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly list=scripts/packages.txt
readonly log=build/install-packages.log

fail() {
  echo "install-packages: $1" >&2
  exit 1
}

# section_lines SECTION: prints the lines of the section's packages.
section_lines() {
  awk -v heading="[$1]" '/^\[/ { inside = $0 == heading; next } inside && NF && $1 !~ /^#/' "$list"
}

# missing_packages SECTION...: prints the packages of the sections that are not installed, one a line.
missing_packages() {
  local wanted installed
  wanted=$(for section; do section_lines "$section"; done | awk '{ print $1 }')
  # dpkg-query fails if it does not know one of them, but still answers for the others.
  # shellcheck disable=SC2086  # one argument a package
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null) || true
  installed=$(sed -n 's/^installed //p' <<<"$installed")
  # Another package of Node.js than Debian's has npm in it, and cannot be installed together with Debian's npm.
  if command -v npm >/dev/null; then installed+=$'\nnpm'; fi
  grep -vxF -f <(echo "$installed") <<<"$wanted" || true
}

# Runs apt-get as root, with its long output in the log. On a fresh machine automatic upgrades may hold dpkg's lock.
apt_as_root() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -yq -o DPkg::Lock::Timeout=120 "$@" >>"$log" 2>&1
}

command -v dpkg-query >/dev/null || fail "no dpkg-query: not a Debian machine. Install by other means what $list names
  in the section [program], then run scripts/build.sh --without-tests."

sections=("$@")
[[ $# -gt 0 ]] || sections=(program)
for section in "${sections[@]}"; do
  if ! grep -qxF "[$section]" "$list"; then
    echo "install-packages: $section: no such section, allowed:" \
      "$(sed -n 's/^\[\(.*\)\]$/\1/p' "$list" | paste -sd ' ')" >&2
    exit 2
  fi
done

mapfile -t missing < <(missing_packages "${sections[@]}")
[[ ${#missing[@]} -gt 0 ]] || exit 0

echo "Installing ${#missing[@]} Debian packages that Tessera needs:"
for package in "${missing[@]}"; do
  awk -v package="$package" '$1 == package { print "  " $0 }' "$list"
done

as_root=()
if [[ $EUID -ne 0 ]]; then
  command -v sudo >/dev/null || fail "neither root nor sudo. Ask an administrator to run
  apt-get install --no-install-recommends ${missing[*]}"
  as_root=(sudo)
fi

mkdir -p "$(dirname "$log")"
echo "On a bare machine these are 340 MB (program) to 660 MB (all), and take minutes. The details go to $log."
: >"$log"
started=$SECONDS
# An additional source that cannot be reached must not stop the installation. The next line shows whether Debian's lists suffice.
apt_as_root update || echo "Warning: apt-get update failed, see $log; going on with the lists that are there." >&2
if ! apt_as_root install --no-install-recommends "${missing[@]}"; then
  tail -n 15 "$log" >&2
  fail "apt-get install failed; the lines above are the end of $log"
fi
echo "Packages installed in $((SECONDS - started)) s."
