# tessera_test(NAME SOURCES ... LINK ... [RANKS 1 2 4] [LABELS ...])
# A GoogleTest binary of that name. With RANKS it is started by mpirun once for each number of ranks; without, it is
# registered as one ctest entry. RapidCheck runs with a fixed seed, so that a red test is red again; a failure prints it.
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

# One precompiled header for all tests.
if(TESSERA_PRECOMPILED_HEADERS)
  list(APPEND TESSERA_TEST_OPTIONS -fpch-preprocess)
  file(TOUCH ${PROJECT_BINARY_DIR}/test_headers.cpp)
  add_library(tessera_test_headers OBJECT ${PROJECT_BINARY_DIR}/test_headers.cpp)
  target_link_libraries(tessera_test_headers PRIVATE tessera_options tessera_opencv GTest::gtest rapidcheck)
  target_compile_options(tessera_test_headers PRIVATE ${TESSERA_TEST_OPTIONS})
  target_precompile_headers(tessera_test_headers PRIVATE ${TESSERA_STANDARD_HEADERS} <gtest/gtest.h> <rapidcheck.h>
                            <rapidcheck/gtest.h> <opencv2/imgproc.hpp>)
endif()

function(tessera_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;RANKS;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_compile_options(${name} PRIVATE ${TESSERA_TEST_OPTIONS})
  if(TESSERA_PRECOMPILED_HEADERS)
    target_precompile_headers(${name} REUSE_FROM tessera_test_headers)
  endif()
  # Tests do not lie beside the program that reads drawings.
  set(drawer_place ENVIRONMENT_MODIFICATION "TESSERA_DRAWER=set:${PROJECT_BINARY_DIR}/src/cli/tessera-drawer")
  if(ARG_RANKS)
    target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gtest rapidcheck)
    foreach(ranks IN LISTS ARG_RANKS)
      add_test(NAME ${name}.${ranks}_ranks
               COMMAND ${MPIEXEC_EXECUTABLE} --oversubscribe --allow-run-as-root --bind-to none
                       -n ${ranks} $<TARGET_FILE:${name}>)
      set_tests_properties(${name}.${ranks}_ranks PROPERTIES LABELS "mpi;${ARG_LABELS}" TIMEOUT ${TESSERA_TEST_TIMEOUT_S}
                           PROCESSORS 2 ENVIRONMENT RC_PARAMS=seed=2016 ${drawer_place})
    endforeach()
  else()
    target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gtest GTest::gtest_main rapidcheck)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${TESSERA_TEST_TIMEOUT_S} ENVIRONMENT RC_PARAMS=seed=2016
                         ${drawer_place})
  endif()
endfunction()
