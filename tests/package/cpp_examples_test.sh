#!/usr/bin/env bash
# cpp_examples_test.sh CMAKE BUILD_FOLDER NEW_FOLDER: moves the installation of cmake --install elsewhere. The programs of examples/cpp are
# built and run with nothing else.
# libtessera-matching.so exports only its public headers.
set -uo pipefail
cmake=$1
build=$2
folder=$3
# shellcheck source=tests/cli/command_fixture.sh
source "$(dirname "${BASH_SOURCE[0]}")/../cli/command_fixture.sh"
source_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
unset TESSERA_DRAWER

new_folder
"$cmake" --install "$build" --prefix "$folder/first" >output 2>errors || fail "cmake --install"
mkdir elsewhere
mv first elsewhere/tessera
prefix=$folder/elsewhere/tessera
library=$prefix/lib/libtessera-matching.so
[[ -e $library ]] || fail "no libtessera-matching.so"

headers=("$prefix"/include/tessera/matching/*.h)
# declared NAME: succeeds if a public header declares this function, class, or member of a class with TESSERA_MATCHING_API. Members of
# nested classes are not public.
declared() {
  local in_namespace=${1#tessera::matching::}
  local class=${in_namespace%%::*} member=${in_namespace#*::}
  [[ $in_namespace != "$1" ]] || return 1
  if [[ $in_namespace == *::* ]]; then
    sed -n "/^class TESSERA_MATCHING_API $class\b/,/^};/p" "${headers[@]}" | grep -qE "(^|[^A-Za-z_~:])$member\("
  else
    grep -qE "^class TESSERA_MATCHING_API $class\b|^TESSERA_MATCHING_API .*\b$class\(" "${headers[@]}"
  fi
}
# undeclared: prints the names from the output of nm -DC that no public header declares. Each line has an address, a kind, and the name with
# its version.
# The version itself is an absolute symbol.
undeclared() {
  local name
  sed -E 's/^[0-9a-f]+ . //; s/^(typeinfo for|typeinfo name for|vtable for) //; s/@@.*//; s/\[abi:[a-z0-9]+\]//; s/\(.*//' |
    sort -u | while read -r name; do
    [[ $name == TESSERA_MATCHING ]] || declared "$name" || echo "$name"
  done
}
nm -DC --defined-only "$library" >output || fail "nm"
foreign=$(undeclared <output)
[[ -z $foreign ]] || fail "exported, but of no public header: $foreign"
# The check finds a function of the program, a helper of the library, private state, and a class that is not exported.
for helper in 'tessera::matching::prepared_curves(int)' 'tessera::matching::Library::State::~State()' \
  'tessera::matching::Error::own(int)' 'typeinfo for tessera::matching::Match' 'tessera::make_shape(int)'; do
  [[ -n $(undeclared <<<"0000000000001234 T $helper@@TESSERA_MATCHING") ]] || fail "$helper would pass as public"
done
grep -q ' tessera::matching::match(' output || fail "match() is not exported"
readelf -d "$library" >output
grep -qiE 'R(UN)?PATH' output && fail "the library looks for others in fixed folders"
grep -q 'SONAME.*\[libtessera-matching\.so\.0\.1\]' output || fail "another soname"
echo "ok exports"

for header in "$prefix"/include/tessera/matching/*.h; do
  echo "#include \"tessera/matching/${header##*/}\"" >alone.cpp
  c++ -std=c++17 -Wall -Wextra -Wpedantic -Werror -fsyntax-only -I "$prefix/include" alone.cpp >output 2>errors ||
    fail "${header##*/} does not compile alone in C++17"
done
grep -hE '^#include ["<]' "$prefix"/include/tessera/matching/*.h | grep -vE '<[a-z_]+>|"tessera/matching/' &&
  fail "a public header includes something else than the standard library"
echo "ok headers"

# After a build of the program alone, the library's part of the installation looks for a missing file.
sed 's/libtessera-matching\.so/libnone.so/g' "$build/src/package/cmake_install.cmake" >not_built.cmake
"$cmake" -DCMAKE_INSTALL_PREFIX="$folder/nothing" -P not_built.cmake >output 2>errors || fail "what was not built is missed"
grep -q 'Not built, so not installed: libtessera-matching' output || fail "not a word of what was not built"
[[ ! -e nothing ]] || fail "parts of what was not built are installed"
echo "ok what was not built"

shown=$(awk '/^```cpp$/ { on = 1; next } /^```$/ && on { exit } on' "$prefix/share/tessera/docs/library.md")
[[ -n $shown && $(<"$prefix/share/tessera/examples/cpp/match_drawings.cpp") == *"$shown"* ]] ||
  fail "docs/library.md shows something else than match_drawings.cpp"
cp -r "$prefix/share/tessera/examples/cpp" cpp
"$cmake" -S cpp -B built -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_FLAGS='-Wall -Wextra -Werror' >output 2>errors ||
  fail "examples/cpp cannot be configured"
"$cmake" --build built >output 2>errors || fail "examples/cpp cannot be built"
ducks=$source_folder/docs/matching
cd / || exit 1
out=$folder/output
err=$folder/errors
"$folder/built/match_drawings" "$ducks/duck.svg" "$ducks/duck-4.svg" >"$out" 2>"$err" || fail "match_drawings"
head -1 "$out" | grep -qE '^score 0\.65[0-9]: 67\.[0-9] % of A, scale 1\.11[0-9], turned by -1\.39[0-9] rad$' ||
  fail "another match: $(cat "$out")"
"$folder/built/match_drawings" "$ducks/duck.svg" /none.svg >"$out" 2>"$err" && fail "matched a file that is not there"
grep -q '^match_drawings: .*/none.svg' "$err" || fail "the error does not name /none.svg: $(cat "$err")"
"$folder/built/match_drawings" >"$out" 2>"$err" && fail "matched nothing"
grep -qx 'match_drawings: needs two drawings' "$err" || fail "another word of no drawings: $(cat "$err")"
"$folder/built/own_descriptor" "$ducks/duck.svg" "$ducks/duck-2.svg" "$ducks/duck-6.svg" >"$out" 2>"$err" ||
  fail "own_descriptor"
[[ $(grep -c . "$out") -eq 8 ]] || fail "not two tables: $(cat "$out")"
# The second drawing is the first one, turned and scaled; the third is a boat.
awk '/^pad/ { getline; exit !($1 == 0 && $2 < 0.05 && $3 > 2 * $2) }' "$out" || fail "other distances: $(cat "$out")"
echo "ok examples"

# A library whose major or minor version differs has another interface.
cd "$folder" || exit 1
for version in 0.2 1.0; do
  sed -i -E "s/Tessera [0-9.]+ REQUIRED/Tessera $version REQUIRED/" cpp/CMakeLists.txt
  "$cmake" -S cpp -B "other_$version" -DCMAKE_PREFIX_PATH="$prefix" >output 2>errors && fail "taken for version $version"
done
echo "ok versions"

mv "$prefix/libexec/tessera/tessera-drawer" drawer
"$folder/built/match_drawings" "$ducks/duck.svg" "$ducks/duck-4.svg" >output 2>errors && fail "matched without a drawer"
grep -qF "tessera-drawer, which reads drawings, is missing: looked for $prefix/libexec/tessera/tessera-drawer" errors ||
  fail "does not say where it looked: $(cat errors)"
TESSERA_DRAWER=$PWD/drawer "$folder/built/match_drawings" "$ducks/duck.svg" "$ducks/duck-4.svg" >output 2>errors ||
  fail "TESSERA_DRAWER does not help"
echo "ok a drawer elsewhere"
