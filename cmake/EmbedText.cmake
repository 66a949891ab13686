# embed_text(OUTPUT.cpp FILE HEADER FUNCTION): makes a C++ file that defines `std::string_view tessera::FUNCTION()`, the text of FILE.
# This file is also the script that the build runs: a changed file is embedded again without configuring.
if(CMAKE_SCRIPT_MODE_FILE)
  # Bytes as numbers: CMake's own lists and escapes do not change them, and no delimiter can stand in the text.
  file(READ "${FILE}" bytes HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
  string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
  file(WRITE "${OUTPUT}" "// Made from ${FILE} by cmake/EmbedText.cmake.
#include \"${HEADER}\"

namespace tessera {
namespace {

constexpr unsigned char kBytes[] = {
${bytes}};

}  // namespace

std::string_view ${FUNCTION}() { return {reinterpret_cast<const char*>(kBytes), sizeof kBytes}; }

}  // namespace tessera
")
  return()
endif()

set(EMBED_TEXT_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(embed_text output file header function)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DFILE=${file} -DHEADER=${header} -DFUNCTION=${function} -P ${EMBED_TEXT_SCRIPT}
    DEPENDS ${file} ${EMBED_TEXT_SCRIPT}
    COMMENT "Embedding ${file}"
    VERBATIM)
endfunction()
