# Compiler settings that every target shares.
option(TESSERA_BUILD_TESTS "Build the tests" ON)
option(TESSERA_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(CCACHE ccache)
if(CCACHE)
  # What is cached is known by paths within the source: another clone on the same machine finds it. The sloppiness is
  # what ccache asks for where headers are precompiled; nothing here is built with the time in it.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}
      CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

# Half of a build without them is reading headers. Every file names what it includes all the same: the debug preset
# builds without.
option(TESSERA_PRECOMPILED_HEADERS "Read the standard library's headers once a target" ON)
set(TESSERA_STANDARD_HEADERS <algorithm> <array> <cmath> <cstdint> <cstdio> <filesystem> <fstream> <functional> <map>
    <memory> <mutex> <numeric> <optional> <set> <span> <sstream> <string> <string_view> <thread> <utility> <vector>)

add_library(tessera_options INTERFACE)
# -pthread everywhere: some packages ask for it, and a precompiled header must have been built as what reads it.
target_compile_options(tessera_options INTERFACE -pthread)
target_include_directories(tessera_options INTERFACE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/kernels)
# -ffp-contract=off: the same job gives the same bytes, on the host and on every device; a fused multiply-add rounds
# once where the kernels round twice.
target_compile_options(tessera_options INTERFACE -Wall -Wextra -Wpedantic -Werror -ffp-contract=off
  # g++ 12 warns falsely of std::string's operator+ (GCC bug 105651).
  -Wno-restrict)
if(TESSERA_PRECOMPILED_HEADERS)
  # Such false warnings of the same bug lie in the library's headers, where they are not told unless precompiled.
  target_compile_options(tessera_options INTERFACE -Wno-array-bounds -Wno-stringop-overflow
                         -Wno-stringop-overread)
endif()
if(TESSERA_SANITIZE)
  target_compile_options(tessera_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
    # Instrumented code makes g++ 12 see overflows and uninitialised values that are none; the other builds stay strict.
    -Wno-error -Wno-maybe-uninitialized -Wno-stringop-overflow)
  target_link_options(tessera_options INTERFACE -fsanitize=address,undefined)
endif()

# tessera_library(NAME SOURCES ... LINK ... [PRECOMPILE <header>...]): one folder of src/ as a static library. PRECOMPILE:
# what many of its files include beside the standard library.
function(tessera_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;PRECOMPILE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC tessera_options ${ARG_LINK})
  list(LENGTH ARG_SOURCES files)
  if(TESSERA_PRECOMPILED_HEADERS AND files GREATER 4)
    target_compile_options(${name} PRIVATE -fpch-preprocess)  # for ccache
    target_precompile_headers(${name} PRIVATE ${TESSERA_STANDARD_HEADERS} ${ARG_PRECOMPILE})
  endif()
endfunction()
