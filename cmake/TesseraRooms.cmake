# tessera_room(NAME [FOLDERS <folder>...] [SOURCES <made file>...] LINK <target>...): a static library of the *.cpp in these folders of the
# calling folder (by default of the calling folder itself). A new file needs no line here.
function(tessera_room name)
  cmake_parse_arguments(ARG "" "" "FOLDERS;SOURCES;LINK" ${ARGN})
  if(NOT ARG_FOLDERS AND NOT ARG_SOURCES)
    set(ARG_FOLDERS .)
  endif()
  foreach(folder IN LISTS ARG_FOLDERS)
    file(GLOB found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
    list(FILTER found EXCLUDE REGEX "/main\\.cpp$")  # it belongs to a program
    list(APPEND ARG_SOURCES ${found})
  endforeach()
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC tessera_options ${ARG_LINK})
  tessera_batches(${name})
endfunction()

# tessera_batches(TARGET): compiles the target's files in batches (CMake's unity build). Most of the time for a small file goes into
# starting the compiler and reading headers.
# Every file must still include all that it uses: the debug preset compiles each file alone.
function(tessera_batches target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${TESSERA_BATCHES} UNITY_BUILD_BATCH_SIZE 12)
  if(TESSERA_BATCHES)
    # This warning is about classes with members of unnamed namespaces outside the compiler's main file. No other file can see these
    # classes.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# tessera_reports(TARGET): for options, job files, cards and reports, where only compiling takes time. These flags reduce that by a fifth to
# a third; other rooms compute results.
function(tessera_reports target)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(${target} PRIVATE -O1)
  endif()
endfunction()
