#!/usr/bin/env bash
# Installs what scripts/packages.txt names and this machine lacks. Does nothing, in no time, where all is there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

readonly list=scripts/packages.txt
readonly log=build/install-packages.log

fail() {
  echo "install-packages: $1" >&2
  exit 1
}

# Prints the packages of the list that are not installed, one a line.
missing_packages() {
  local wanted installed
  wanted=$(awk 'NF && $1 !~ /^#/ { print $1 }' "$list")
  # dpkg-query fails where it does not know one of them; it still answers for the others.
  # shellcheck disable=SC2086  # one argument a package
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null) || true
  installed=$(sed -n 's/^installed //p' <<<"$installed")
  grep -vxF -f <(echo "$installed") <<<"$wanted" || true
}

# Runs apt-get as root; its pages of output go to the log. On a fresh machine automatic upgrades may hold dpkg's lock.
apt_as_root() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -yq -o DPkg::Lock::Timeout=120 "$@" >>"$log" 2>&1
}

command -v dpkg-query >/dev/null || fail "no dpkg-query: not a Debian machine. Install what $list names by other means,
  then run scripts/build.sh."

mapfile -t missing < <(missing_packages)
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
echo "On a bare machine these are about 340 MB and take a minute or two; the details go to $log."
: >"$log"
started=$SECONDS
# A foreign source that cannot be reached must not stop us: whether Debian's lists suffice, the next line finds out.
apt_as_root update || echo "Warning: apt-get update failed, see $log; going on with the lists that are there." >&2
if ! apt_as_root install --no-install-recommends "${missing[@]}"; then
  tail -n 15 "$log" >&2
  fail "apt-get install failed; the lines above are the end of $log"
fi
echo "Packages installed in $((SECONDS - started)) s."
