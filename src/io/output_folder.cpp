#include "io/output_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "core/base/error.h"
#include "io/file_descriptor.h"

namespace tessera::io {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& folder, int reason) {
  throw EnvironmentError("cannot write into the folder " + folder + ": " + std::generic_category().message(reason));
}

}  // namespace

void check_takes_files(const std::string& folder) {
  std::string probe = (fs::path(folder) / ".tessera-XXXXXX").string();
  const FileDescriptor file(::mkostemp(probe.data(), O_CLOEXEC));
  if (!file.is_open()) fail(folder, errno);
  ::unlink(probe.c_str());
  // A disk without room takes files, but no bytes.
  if (::write(file.number(), "", 1) != 1 || ::fsync(file.number()) != 0) fail(folder, errno);
}

OutputFolder::OutputFolder(const std::string& folder) {
  const std::string path = folder.empty() ? "." : folder;
  try {
    make(path);
    check_takes_files(path);
  } catch (...) {
    for (auto made = made_.rbegin(); made != made_.rend(); ++made) ::rmdir(made->c_str());
    throw;
  }
}

OutputFolder::~OutputFolder() {
  for (auto made = made_.rbegin(); made != made_.rend(); ++made) ::rmdir(made->c_str());
}

void OutputFolder::make(const std::string& folder) {
  fs::path part;
  for (const fs::path& name : fs::path(folder)) {
    part /= name;
    if (::mkdir(part.c_str(), 0777) == 0) {
      made_.push_back(part.string());
      leftovers_.emplace_back(made_.back());
      continue;
    }
    const int reason = errno;  // EROFS and EACCES, too, where the folder is there
    std::error_code error;
    if (!fs::is_directory(part, error)) fail(folder, reason == EEXIST ? ENOTDIR : reason);
  }
}

}  // namespace tessera::io
