# tessera_room(NAME [FOLDERS <folder>...] [SOURCES <made file>...] LINK <target>...): the *.cpp of these folders of the
# calling folder (of itself, where none is named) as a static library. A new file needs no line here.
function(tessera_room name)
  cmake_parse_arguments(ARG "" "" "FOLDERS;SOURCES;LINK" ${ARGN})
  if(NOT ARG_FOLDERS AND NOT ARG_SOURCES)
    set(ARG_FOLDERS .)
  endif()
  foreach(folder IN LISTS ARG_FOLDERS)
    file(GLOB found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
    list(FILTER found EXCLUDE REGEX "/main\\.cpp$")  # of a program
    list(APPEND ARG_SOURCES ${found})
  endforeach()
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC tessera_options ${ARG_LINK})
  tessera_batches(${name})
endfunction()

# tessera_batches(TARGET): its files are compiled in batches (CMake's unity build), as most of what a small file costs is
# starting the compiler and reading headers. Every file includes what it uses all the same: the debug preset compiles
# each alone.
function(tessera_batches target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${TESSERA_BATCHES} UNITY_BUILD_BATCH_SIZE 12)
  if(TESSERA_BATCHES)
    # It warns of a class with members of unnamed namespaces outside the compiler's main file: no other file can see it.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# tessera_reports(TARGET): options, job files, cards and reports, where nothing takes time but compiling. It takes a fifth to a
# third less of it; in the other rooms results are computed.
function(tessera_reports target)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    target_compile_options(${target} PRIVATE -O1)
  endif()
endfunction()
