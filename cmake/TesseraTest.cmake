# tessera_test(NAME SOURCES ... LINK ... [RANKS 1 2 4] [LABELS ...])
# A GoogleTest binary of that name. With RANKS it is started by mpirun once for each number of ranks; without, it is
# registered as one ctest entry. RapidCheck runs with a fixed seed, so that a red test is red again; a failure prints it.
find_package(GTest REQUIRED)

include_directories(${PROJECT_SOURCE_DIR}/tests)

# Of a test without a longer one of its own. Instrumented programs take five times as long.
set(TESSERA_TEST_TIMEOUT_S 300)
if(TESSERA_SANITIZE)
  set(TESSERA_TEST_TIMEOUT_S 1500)
endif()

function(tessera_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;RANKS;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
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
