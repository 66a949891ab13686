# Run at every build by src/core/CMakeLists.txt: cmake -DSOURCE=DIR -DVERSION=X.Y.Z -DOUTPUT=FILE -P WriteVersion.cmake
# Writes a C++ source with the version and the git commit of SOURCE; "unknown" where that is no git repository of its
# own, as in an unpacked archive. The file is left alone where nothing changed, so that nothing is built again.
set(commit "unknown")
set(ENV{GIT_OPTIONAL_LOCKS} 0)  # looking must not disturb a git command that runs at the same time
find_program(GIT git)
if(GIT AND EXISTS ${SOURCE}/.git)
  # --exclude: always the commit, never a tag's name. "-dirty" where files differ from it.
  execute_process(COMMAND ${GIT} -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
                  OUTPUT_VARIABLE described RESULT_VARIABLE status ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(status EQUAL 0)
    set(commit "${described}")
  endif()
endif()

file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[// Made by cmake/WriteVersion.cmake.
#include "core/base/version.h"

namespace tessera {

const char* program_version() { return "@VERSION@"; }
const char* program_commit() { return "@commit@"; }

}  // namespace tessera
]] @ONLY)
