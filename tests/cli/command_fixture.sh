# shellcheck shell=bash disable=SC2154
# Tests that give the program several commands in turn source this file. A command's output goes to the files output and errors.
# It needs $tessera and $folder (new), and $mpirun for tests on several ranks.
# shellcheck source=tests/support/drawings.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/drawings.sh"
# shellcheck source=tests/support/ranks.sh
source "$(dirname "${BASH_SOURCE[0]}")/../support/ranks.sh"
unset SLURM_JOB_END_TIME

# Background processes of a test end with it.
fail() {
  echo "FAILED $*"
  # shellcheck disable=SC2046
  kill $(jobs -p) 2>/dev/null
  head -c 2000 output errors ./*.left_out.txt 2>/dev/null
  exit 1
}

# run CODES COMMAND...: tessera ends within $most_s seconds, and its exit $code is one of CODES.
most_s=120
run() { run_program "$1" "$tessera" "${@:2}"; }
run_on_ranks() { run_program "$2" "${on_ranks[@]}" "$1" "$tessera" "${@:3}"; } # RANKS CODES COMMAND...
run_program() { # CODES PROGRAM ARGUMENT...
  timeout "$most_s" "${@:2}" >output 2>errors
  code=$?
  without_launcher_warnings errors
  [[ " $1 " == *" $code "* ]] || fail "exit code $code, not $1: ${*:2}"
}

# same_on_3_ranks OUT COMMAND...: runs it on one rank into OUT and on three into OUT_on_3, and compares the pieces.
# The files output and errors are those of the run on one rank.
same_on_3_ranks() {
  run_on_ranks 3 0 "${@:2}" --out "$1_on_3"
  run 0 "${@:2}" --out "$1"
  cmp "$1/pieces.geojson" "$1_on_3/pieces.geojson" || fail "other pieces on three ranks: ${*:2}"
}

expect_silence() { [[ ! -s errors ]] || fail "$1"; }
expect_word() { grep -qF -- "$1" errors || fail "not on stderr: $1"; }

# Makes the new folder and enters it.
new_folder() {
  rm -rf "$folder"
  mkdir -p "$folder"
  cd "$folder" || exit 1
}

# Enters the new folder, with a library of five drawings in own.h5.
enter_folder() {
  new_folder
  make_drawings drawings
  run 0 library build drawings -o own.h5
}

# Writes job.toml: a job of two pieces from the library.
write_job() { # CANVAS_PX SCALES_PX WIDTH_PX
  cat >job.toml <<END_OF_JOB
quality = 'draft'
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
