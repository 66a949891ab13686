# cmake -DTESSERA=binary -DARGUMENTS=list -DCODE=n -DPATTERN=regex -DFOLDER=new-folder -P expect_exit.cmake
# Runs the binary in FOLDER. It must exit with CODE and print text that matches PATTERN on stdout or stderr.
# If it fails, it must say so in one line.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${TESSERA} ${ARGUMENTS} WORKING_DIRECTORY ${FOLDER}
                RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
if(NOT code STREQUAL CODE)
  message(FATAL_ERROR "exit code ${code}, expected ${CODE}\n${out}${err}")
endif()
if(NOT "${out}${err}" MATCHES "${PATTERN}")
  message(FATAL_ERROR "does not match ${PATTERN}:\n${out}${err}")
endif()
if(NOT CODE EQUAL 0 AND NOT err MATCHES "^tessera: [^\n]*\n$")
  message(FATAL_ERROR "more than one line of error:\n${err}")
endif()
file(GLOB left_behind ${FOLDER}/*)
if(left_behind)
  message(FATAL_ERROR "left behind: ${left_behind}")
endif()
