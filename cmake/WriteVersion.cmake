# src/core/CMakeLists.txt runs it at every build: cmake -DSOURCE=DIR -DVERSION=X.Y.Z -DOUTPUT=FILE -P WriteVersion.cmake
# It writes a C++ source with the version and the git commit of SOURCE. The commit is "unknown" if SOURCE is not its own git repository, as
# in an unpacked archive.
# An unchanged file is left alone, so that nothing is built again.
set(commit "unknown")
set(ENV{GIT_OPTIONAL_LOCKS} 0)  # must not disturb a git command at the same time
find_program(GIT git)
if(GIT AND EXISTS ${SOURCE}/.git)
  # --exclude gives the commit instead of a tag's name. "-dirty" means that files differ from it.
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
