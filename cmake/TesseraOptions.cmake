# Compiler settings that every target shares.
option(TESSERA_BUILD_TESTS "Build the tests" ON)
option(TESSERA_SANITIZE "Build with the address and undefined-behaviour sanitizers" OFF)

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

add_library(tessera_options INTERFACE)
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

# tessera_library(NAME SOURCES ... LINK ...): one folder of src/ as a static library.
function(tessera_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC tessera_options ${ARG_LINK})
endfunction()
