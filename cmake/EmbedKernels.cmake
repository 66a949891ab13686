# embed_kernels(OUTPUT.cpp FILE...): joins the files in this order into one C++ string constant, tessera::worker::kernel_source.
# Each file keeps its name and line numbers in the device compiler's messages.
# This file is also the script that the build runs: a changed kernel is embedded again without configuring.
if(CMAKE_SCRIPT_MODE_FILE)
  set(source "")
  foreach(file IN LISTS FILES)
    get_filename_component(name "${file}" NAME)
    file(READ "${file}" text)
    string(APPEND source "R\"kernel(#line 1 \"${name}\"\n${text})kernel\"\n")
  endforeach()
  file(WRITE "${OUTPUT}" "// Made from kernels/ by cmake/EmbedKernels.cmake.
namespace tessera::worker {
extern const char* const kernel_source;
const char* const kernel_source =
${source};
}  // namespace tessera::worker
")
  return()
endif()

set(EMBED_KERNELS_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(embed_kernels output)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DFILES=${ARGN}" -P ${EMBED_KERNELS_SCRIPT}
    DEPENDS ${ARGN} ${EMBED_KERNELS_SCRIPT}
    COMMENT "Embedding the OpenCL kernels"
    VERBATIM)
endfunction()
