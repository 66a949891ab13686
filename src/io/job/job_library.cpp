#include "io/job/job_library.h"

#include "core/base/error.h"

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

}  // namespace tessera::io
