# shellcheck shell=bash
# Tests that need npm source this file. Exit code 77 is a test that cannot run here.

skip() {
  echo "SKIPPED: $*"
  exit 77
}

need() { # COMMAND PURPOSE
  command -v "$1" >/dev/null || skip "$1 is missing, which $2"
}

# Installs the exact versions of package-lock.json into the current folder, from npm's cache where they are there.
install_packages() {
  local code=0
  npm ci --prefer-offline --ignore-scripts --no-audit --no-fund --fetch-retries=1 --fetch-timeout=30000 >npm.log 2>&1 || code=$?
  ((code == 0)) && return
  if grep -qE 'ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ETIMEDOUT|ENETUNREACH|EHOSTUNREACH|ENOTCACHED|ERR_SOCKET_TIMEOUT' npm.log; then
    skip "the registry of npm cannot be reached, and its cache lacks packages of package-lock.json ($PWD/npm.log)"
  fi
  echo "FAILED npm ci in $PWD"
  tail -n 30 npm.log
  exit 1
}
