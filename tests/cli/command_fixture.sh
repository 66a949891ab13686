# shellcheck shell=bash disable=SC2154
# For the tests that give the program one command after the other, which source it: what a command says goes to the files
# output and errors. Needs: $tessera, $folder (new).
# shellcheck source=tests/support/drawings.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/drawings.sh"
unset SLURM_JOB_END_TIME

fail() {
  echo "FAILED $*"
  head -c 2000 output errors 2>/dev/null
  exit 1
}

# run CODES COMMAND...: tessera ends within $most_s, and its exit $code is one of CODES.
most_s=120
run() {
  local expected=$1
  shift
  timeout "$most_s" "$tessera" "$@" >output 2>errors
  code=$?
  [[ " $expected " == *" $code "* ]] || fail "exit code $code, not $expected: $*"
}
expect_silence() { [[ ! -s errors ]] || fail "$1"; }
expect_word() { grep -qF -- "$1" errors || fail "not on stderr: $1"; }

# The new folder, entered, with a library of five drawings in own.h5.
enter_folder() {
  rm -rf "$folder"
  mkdir -p "$folder"
  cd "$folder" || exit 1
  make_drawings drawings
  run 0 library build drawings -o own.h5
}

# A job of two pieces of the library in job.toml.
write_job() { # CANVAS_PX SCALES_PX WIDTH_PX
  cat >job.toml <<END_OF_JOB
[library]
file = 'own.h5'
[canvas]
size_px = [$1]
[pieces]
scale_px = [$2]
[stop]
pieces = 2
[output]
width_px = $3
END_OF_JOB
}
