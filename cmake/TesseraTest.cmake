# Tests: one program for each room, one ctest entry for each file. RapidCheck runs with a fixed seed, so that a failed test fails again; a
# failure prints the seed.
include_directories(${PROJECT_SOURCE_DIR}/tests)

# The time limit of a test without its own. Instrumented programs take five times as long.
set(TESSERA_TEST_TIMEOUT_S 300)
if(TESSERA_SANITIZE)
  set(TESSERA_TEST_TIMEOUT_S 1500)
endif()

# Half of a build is tests, and each is built and run once. With -O1 this takes a quarter less time than with -O3.
set(TESSERA_TEST_OPTIONS "")
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  set(TESSERA_TEST_OPTIONS -O1)
endif()

# The main() of all test programs. --file=test_pad runs only the tests of that file.
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

# tessera_test_entry(NAME [LABELS ...] COMMAND ...): a ctest entry with the properties that every test needs.
function(tessera_test_entry name)
  cmake_parse_arguments(ARG "" "" "LABELS;COMMAND" ${ARGN})
  add_test(NAME ${name} COMMAND ${ARG_COMMAND})
  # The program that reads drawings does not lie beside the tests.
  set_tests_properties(${name} PROPERTIES
    LABELS "${ARG_LABELS}" TIMEOUT ${TESSERA_TEST_TIMEOUT_S} ENVIRONMENT RC_PARAMS=seed=2016
    ENVIRONMENT_MODIFICATION "TESSERA_DRAWER=set:${PROJECT_BINARY_DIR}/src/cli/tessera-drawer")
endfunction()

# tessera_tests(NAME LINK <target>... [LABELS ...] [EXCEPT <file>...] [SUITES <header>...]): builds the program NAME from the *.cpp of the
# calling folder and its subfolders.
# Each test_*.cpp gets a ctest entry of its name. A new file needs no line here.
# SUITES: the headers that hold tests, without ".h"; each is an entry, too. The program refuses to run if another header holds tests.
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
