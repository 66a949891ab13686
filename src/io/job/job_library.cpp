#include "io/job/job_library.h"

#include "core/base/error.h"
#include "io/job/wish_resolution.h"

namespace tessera::io {

LibraryFile open_library_of(const Job& job) {
  try {
    return LibraryFile(job.library);
  } catch (const InputError& error) {
    throw InputError(job.path + ": library.file: " + error.what() +
                     "; allowed: a library made by tessera library build");
  }
}

void resolve_wishes(const LibraryFile& library, Job& job) {
  std::vector<std::string> names;
  if (has_shape_wishes(job)) {
    constexpr LibraryParts kNamesOnly{.outline = false, .field = false, .levels = 0, .artwork = false};
    for (const Shape& shape : library.read(0, library.size(), kNamesOnly)) names.push_back(shape.name);
  }
  resolve_wishes(names, job);
}

}  // namespace tessera::io
