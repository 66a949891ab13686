# Compiler settings that every target shares.
option(TESSERA_BUILD_TESTS "Build the tests" ON)
option(TESSERA_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(CCACHE ccache)
if(CCACHE)
  # What is cached is known by paths within the source: another clone on the same machine finds it.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} ${CCACHE})
endif()

option(TESSERA_BATCHES "Compile files in batches: TesseraRooms.cmake" ON)

# The rooms are linked into libtessera-matching.so, too. Functions may still be inlined: no other library replaces them.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

add_library(tessera_options INTERFACE)
target_compile_options(tessera_options INTERFACE -fno-semantic-interposition)
target_compile_options(tessera_options INTERFACE -pthread)
target_include_directories(tessera_options INTERFACE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/kernels)
# -ffp-contract=off: the same job gives the same bytes, on the host and on every device; a fused multiply-add rounds
# once where the kernels round twice.
target_compile_options(tessera_options INTERFACE -Wall -Wextra -Wpedantic -Werror -ffp-contract=off
  # g++ 12 warns falsely of std::string's operator+ (GCC bug 105651).
  -Wno-restrict)
if(TESSERA_SANITIZE)
  target_compile_options(tessera_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
    # Instrumented code makes g++ 12 see overflows and uninitialised values that are none; the other builds stay strict.
    -Wno-error -Wno-maybe-uninitialized -Wno-stringop-overflow)
  target_link_options(tessera_options INTERFACE -fsanitize=address,undefined)
endif()
