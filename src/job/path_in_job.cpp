#include "job/path_in_job.h"

#include <filesystem>

#include "core/base/error.h"
#include "text/utf8_text.h"

namespace tessera {

std::string path_in_job(const std::string& path, const std::string& job) {
  namespace fs = std::filesystem;
  if (!is_utf8(path))
    throw InputError(printable_utf8(path) + ": found a name that is not UTF-8, as a job's text must be");
  const fs::path given(path);
  if (given.is_absolute()) return path;
  const fs::path from = fs::absolute(job).lexically_normal().parent_path();
  return fs::absolute(given).lexically_normal().lexically_relative(from).string();
}

std::string path_beside_job(const std::string& job, const std::string& ending) {
  const std::filesystem::path path(job);
  return (path.parent_path() / (path.stem().string() + ending)).string();
}

}  // namespace tessera
