#include "io/job/job_library.h"

#include "core/base/error.h"
#include "io/job/start_pieces.h"
#include "io/job/wish_resolution.h"

namespace tessera::io {

std::vector<std::string> library_paths(const Job& job) {
  return job.library_files.empty() ? std::vector{job.library} : job.library_files;
}

std::string library_text(const Job& job) {
  std::string text;
  for (const std::string& path : library_paths(job)) text += (text.empty() ? "" : ", ") + path;
  return text;
}

LibraryView open_library_of(const Job& job) {
  try {
    return LibraryView({library_paths(job), {job.library_include, job.library_exclude}});
  } catch (const NamesNotFound& error) {
    throw InputError(job.path + ": library." + error.what());
  } catch (const InputError& error) {
    const char* key = job.library_files.empty() ? ": library.file: " : ": library.files: ";
    throw InputError(job.path + key + error.what() + "; allowed: a library made by tessera library build");
  }
}

namespace {

std::vector<std::string> names_in(const ShapeLibrary& library) {
  constexpr LibraryParts kNamesOnly{.outline = false, .field = false, .levels = 0, .artwork = false};
  std::vector<std::string> names;
  for (const Shape& shape : library.read(0, library.size(), kNamesOnly)) names.push_back(shape.name);
  return names;
}

}  // namespace

void resolve_wishes(const ShapeLibrary& library, Job& job) {
  resolve_wishes(has_shape_wishes(job) ? names_in(library) : std::vector<std::string>(), job);
}

void add_start_pieces(const ShapeLibrary& library, Job& job) {
  if (!job.start.pieces.empty()) add_start_pieces(names_in(library), job);
}

}  // namespace tessera::io
