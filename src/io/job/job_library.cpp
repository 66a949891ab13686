#include "io/job/job_library.h"

#include "core/base/error.h"

namespace tessera::io {

LibraryFile open_library_of(const Job& job) {
  try {
    return LibraryFile(job.library);
  } catch (const InputError& error) {
    throw InputError(job.path + ": library.file: " + error.what() +
                     "; allowed: a library made by tessera library build");
  }
}

}  // namespace tessera::io
