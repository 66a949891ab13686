#include "files/output_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "core/base/error.h"
#include "files/atomic_file.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& folder, int reason) {
  throw EnvironmentError("cannot write into the folder " + folder + ": " + std::generic_category().message(reason));
}

}  // namespace

void check_takes_files(const std::string& folder) {
  TemporaryFile probe((fs::path(folder) / ".tessera-write-test").string());
  probe.write(std::array<std::uint8_t, 1>{});  // a disk without room takes files, but no bytes
  probe.flush();
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

}  // namespace tessera
