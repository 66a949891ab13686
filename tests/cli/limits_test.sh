#!/usr/bin/env bash
# limits_test.sh TESSERA NEW_FOLDER SANITIZED: refusals by the machine or the shell (file size, memory, threads, names, /proc). The program
# reports them in ordinary words, and leaves no half-written file.
# SANITIZED 1 leaves out tests that take away addresses or /proc, because the address sanitizer needs both.
set -uo pipefail
tessera=$1
folder=$2
sanitized=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/command_fixture.sh"

expect_nothing_half_written() {
  [[ -z $(find . -name '*.tmp*' -o -name '*.lock') ]] || fail "left behind: $(find . -name '*.tmp*' -o -name '*.lock')"
}
expect_ordinary_words() { ! grep -q 'internal error' output errors || fail "not in ordinary words"; }

# refused CODES WORD COMMAND...: the message contains WORD.
refused() {
  run "$1" "${@:3}"
  expect_word "$2"
  expect_ordinary_words
  rm -rf none ./none.*
}

enter_folder
rsvg-convert drawings/leaf.svg -o sun.png
write_job '64, 48' '14, 40' 400
run 0 collage job.toml --out result --quiet
cat >parts.json <<'JSON'
{"name": "parts", "strip_height": 40, "items": [
  {"id": 0, "demand": 4, "allowed_orientations": [0, 180], "shape": {"type": "simple_polygon", "data": [[0,0],[20,0],[10,15],[0,0]]}}]}
JSON

# With a limit on file sizes, SIGXFSZ would end the program. Meanwhile no output goes into a file, as the limit holds for that, too.
small_files() { # KIB COMMAND...
  (
    ulimit -f "$1"
    timeout "$most_s" "$tessera" "${@:2}" 2>&1 </dev/null
    echo "exit code $?"
  ) | cat >output
  grep -qE "tessera: .*(File too large|files of $1 KiB \(ulimit -f\))" output || fail "does not say that a file is too large: ulimit -f $*"
  grep -qx 'exit code 1' output || fail "not exit code 1: ulimit -f $*"
  expect_nothing_half_written
  expect_ordinary_words
  rm -rf none ./none.*
}
for kib in 0 1 64; do
  small_files "$kib" library build drawings --embed -o none.h5
  small_files "$kib" library subset own.h5 --include '*' -o none.h5
done
for kib in 0 1; do
  small_files "$kib" library info own.h5 --sheet none.png
  small_files "$kib" draw result --to none --png --svg --pdf --tiff --quiet
  small_files "$kib" rank result --out none
  small_files "$kib" nest parts.json --effort draft --out none --quiet
done
for kib in 0 1; do small_files "$kib" collage job.toml --out none --quiet; done
small_files 0 campaign job.toml --seeds 1 --out none
small_files 0 mosaic sun.png own.h5 --pieces 100 --job-only --job none.toml
small_files 0 library extract sun.png --element-px 75 -o none.h5 --overview none
# The OpenCL compiler ends the process if its file cannot grow.
(
  export POCL_CACHE_DIR=$PWD/kernels
  for kib in 100 400; do small_files "$kib" collage job.toml --out none --quiet; done
) || exit 1
echo "ok size of files"

# Names that no file system accepts.
for name in "$(printf 'x%.0s' {1..256})" "$(printf 'abcdefgh/%.0s' {1..600})x"; do
  for command in "plan $name" "collage $name" "library build $name -o none.h5" "library info $name" "rank $name" \
    "card $name --size 100,100" "mosaic sun.png $name --job-only --job none.toml" "puzzle make $name --out none" \
    "mosaic sun.png own.h5 --salient $name --job-only --job none.toml"; do
    # shellcheck disable=SC2086
    refused 2 "${name:0:100}" $command
  done
  for key in canvas.file library.file; do refused 2 "${name:0:100}" plan job.toml --set "$key='$name'"; done
  for command in "collage job.toml --out $name" "campaign job.toml --seeds 1 --out $name" "draw result --to $name" \
    "rank result --out $name" "library build drawings -o $name" "library info own.h5 --sheet $name.png" \
    "library subset own.h5 --include * -o $name" "mosaic sun.png own.h5 --job-only --job $name.toml" \
    "library extract sun.png --element-px 75 -o none.h5 --overview $name" "bench pairs --quick --out $name" \
    "nest parts.json --out $name" "puzzle make sun.png --out $name"; do
    # shellcheck disable=SC2086
    set -f && refused 1 'File name too long' $command
    set +f
  done
done
echo "ok names"

# Hides /proc in a mount namespace, where a user may make one.
without_proc() { unshare --mount --map-root-user sh -c 'mount -t tmpfs none /proc && exec "$@"' - "$@"; }
if [[ $sanitized == 0 ]] && without_proc true 2>/dev/null; then
  for command in "library build drawings -o none.h5" "draw result --to none --set colour.pieces=artwork"; do
    # shellcheck disable=SC2086
    without_proc "$tessera" $command >output 2>errors
    code=$?
    [[ $code == 1 ]] || fail "exit code $code without /proc: $command"
    expect_word 'cannot tell where this program lies: /proc/self/exe: No such file or directory; TESSERA_DRAWER=FILE'
    rm -rf none ./none.*
  done
  TESSERA_DRAWER=$(dirname "$tessera")/tessera-drawer without_proc "$tessera" library build drawings -o none.h5 \
    >output 2>errors || fail "no library without /proc"
  rm none.*
  without_proc "$tessera" --version >output 2>errors || fail "does not even tell its version without /proc"
  echo "ok without /proc"
fi

expect_nothing_half_written
[[ $sanitized == 0 ]] || exit 0

# limited COMMAND...: with less and less memory the command works, says what it lacks, or cannot be loaded (127).
limited() {
  local mib
  for mib in 600 400 300; do
    # shellcheck disable=SC2016
    run_program '0 1 127' bash -c 'ulimit -v "$0" && exec "$@"' $((1024 * mib)) "$tessera" "$@"
    expect_ordinary_words
    [[ $code != 1 ]] || grep -q -e memory -e thread errors || fail "does not say what it lacks: $*"
    expect_nothing_half_written
    rm -rf none ./none.*
  done
}
limited library build drawings -o none.h5
limited draw result --to none --png --tiff --quiet
limited rank result --out none
for kib in 750000 600000 550000 500000 400000; do
  # shellcheck disable=SC2016
  run_program '0 1' bash -c 'ulimit -v "$0" && exec "$@"' $kib "$tessera" collage job.toml --out none --quiet
  [[ $code != 1 ]] || grep -q 'of address space (ulimit -v)' errors || fail "does not name the limit: $kib KiB"
  expect_nothing_half_written
  rm -rf none
done
limited library info own.h5 --sheet none.png
echo "ok memory"

# If no stack fits into memory, no thread starts.
(
  ulimit -s $((8 << 20)) -v $((6 << 20))
  refused 1 'cannot start a thread: Resource temporarily unavailable; limits of this process: 6144 MiB of address space' library build drawings -o none.h5
  refused 1 'cannot start a thread: Resource temporarily unavailable; limits of this process: 6144 MiB of address space' draw result --to none --quiet
) || exit 1
echo "ok threads"
