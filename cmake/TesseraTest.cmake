# Tests: one program a room, one ctest entry a file. RapidCheck runs with a fixed seed, so that a red test is red again; a
# failure prints it.
include_directories(${PROJECT_SOURCE_DIR}/tests)

# Of a test without a longer one of its own. Instrumented programs take five times as long.
set(TESSERA_TEST_TIMEOUT_S 300)
if(TESSERA_SANITIZE)
  set(TESSERA_TEST_TIMEOUT_S 1500)
endif()

# Half of a build is tests, each built once and run once: this takes a quarter less time than -O3.
set(TESSERA_TEST_OPTIONS "")
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  set(TESSERA_TEST_OPTIONS -O1)
endif()

# main() of all of them: --file=test_pad runs the tests of that file alone.
add_library(tessera_test_main STATIC ${PROJECT_SOURCE_DIR}/tests/support/test_main.cpp)
target_link_libraries(tessera_test_main PUBLIC tessera_options GTest::gtest rapidcheck)

# tessera_test_program(NAME SOURCES ... LINK ...)
function(tessera_test_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_compile_options(${name} PRIVATE ${TESSERA_TEST_OPTIONS})
  target_compile_definitions(${name} PRIVATE TESSERA_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${name} PRIVATE ${ARG_LINK} tessera_test_main)
  tessera_batches(${name})
endfunction()

# tessera_test_entry(NAME [LABELS ...] COMMAND ...): a ctest entry with what every test needs.
function(tessera_test_entry name)
  cmake_parse_arguments(ARG "" "" "LABELS;COMMAND" ${ARGN})
  add_test(NAME ${name} COMMAND ${ARG_COMMAND})
  # Tests do not lie beside the program that reads drawings.
  set_tests_properties(${name} PROPERTIES
    LABELS "${ARG_LABELS}" TIMEOUT ${TESSERA_TEST_TIMEOUT_S} ENVIRONMENT RC_PARAMS=seed=2016
    ENVIRONMENT_MODIFICATION "TESSERA_DRAWER=set:${PROJECT_BINARY_DIR}/src/cli/tessera-drawer")
endfunction()

# tessera_tests(NAME LINK <target>... [LABELS ...] [EXCEPT <file>...] [SUITES <header>...]): the program NAME of the
# *.cpp of the calling folder and of the folders in it, and an entry for each test_*.cpp, named like it. A new file needs
# no line here. SUITES: headers that hold tests, without ".h"; each is an entry, too. The program refuses to run where
# another header holds tests.
function(tessera_tests name)
  cmake_parse_arguments(ARG "" "" "LINK;LABELS;EXCEPT;SUITES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp */*.cpp)
  list(REMOVE_ITEM sources ${ARG_EXCEPT})
  tessera_test_program(${name} SOURCES ${sources} LINK ${ARG_LINK})
  list(JOIN ARG_SUITES "," suites)
  foreach(suite IN LISTS ARG_SUITES)
    tessera_test_entry(${name}.${suite} LABELS ${ARG_LABELS} COMMAND ${name} --file=${suite} --suites=${suites})
  endforeach()
  foreach(source IN LISTS sources)
    get_filename_component(file ${source} NAME_WE)
    if(file MATCHES "^test_")
      tessera_test_entry(${file} LABELS ${ARG_LABELS} COMMAND ${name} --file=${file} --suites=${suites})
    endif()
  endforeach()
endfunction()
