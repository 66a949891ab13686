# Compiler settings that every target shares.
option(TESSERA_BUILD_TESTS "Build the tests" ON)
option(TESSERA_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(CCACHE ccache)
if(CCACHE)
  # The cache uses paths relative to the source, so that other clones on the same machine share it.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} ${CCACHE})
endif()

option(TESSERA_BATCHES "Compile files in batches: TesseraRooms.cmake" ON)

# The rooms are linked into libtessera-matching.so, too. Functions may still be inlined, as no other library replaces them.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

add_library(tessera_options INTERFACE)
target_compile_options(tessera_options INTERFACE -fno-semantic-interposition)
target_compile_options(tessera_options INTERFACE -pthread)
target_include_directories(tessera_options INTERFACE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/kernels)
# -ffp-contract=off: the same job must give the same bytes on the host and on every device. A fused multiply-add rounds once where the
# kernels round twice.
target_compile_options(tessera_options INTERFACE -Wall -Wextra -Wpedantic -Werror -ffp-contract=off
  # g++ 12 gives false warnings about std::string's operator+ (GCC bug 105651).
  -Wno-restrict)
if(TESSERA_SANITIZE)
  target_compile_options(tessera_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
    # In instrumented code g++ 12 gives false warnings about overflows and uninitialised values; the other builds stay strict.
    -Wno-error -Wno-maybe-uninitialized -Wno-stringop-overflow)
  target_link_options(tessera_options INTERFACE -fsanitize=address,undefined)
endif()
