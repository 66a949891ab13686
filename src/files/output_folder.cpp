#include "files/output_folder.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <functional>
#include <system_error>

#include "core/base/error.h"
#include "files/atomic_file.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAdvice = "; give another output";

std::string cannot_write_into(const std::string& folder) { return "cannot write into the folder " + folder + ": "; }

/// Throws the error. `part`: the part of the path that could not become a folder; empty: the whole path exists.
[[noreturn]] void fail(const std::string& folder, const fs::path& part, int reason) {
  std::error_code error;
  if (fs::exists(part, error)) throw InputError(cannot_write_into(folder) + part.string() + " is a file" + kAdvice);
  throw EnvironmentError(cannot_write_into(folder) + std::generic_category().message(reason) + kAdvice);
}

/// Makes missing folders of the path and calls `made` with each of them.
void make_folders(const std::string& folder, const std::function<void(const std::string&)>& made) {
  fs::path part;
  for (const fs::path& name : fs::path(folder)) {
    part /= name;
    if (::mkdir(part.c_str(), 0777) == 0) {
      made(part.string());
      continue;
    }
    const int reason = errno;  // EROFS and EACCES also come where the folder exists
    std::error_code error;
    if (!fs::is_directory(part, error)) fail(folder, part, reason);
  }
}

}  // namespace

void check_takes_files(const std::string& folder) {
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(folder, {}, errno);
  try {
    TemporaryFile probe((fs::path(folder) / ".tessera-write-test").string());
    probe.write(std::array<std::uint8_t, 1>{});  // a full disk still creates files, but takes no bytes
    probe.flush();
  } catch (const EnvironmentError& error) {
    throw EnvironmentError(error.what() + std::string(kAdvice));
  }
}

void make_folder(const std::string& folder) {
  make_folders(folder, [](const std::string&) {});
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
  make_folders(folder, [this](const std::string& part) {
    made_.push_back(part);
    leftovers_.emplace_back(made_.back());
  });
}

}  // namespace tessera
