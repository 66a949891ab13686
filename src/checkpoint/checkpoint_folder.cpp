#include "checkpoint/checkpoint_folder.h"

#include <filesystem>
#include <system_error>

#include "core/base/error.h"
#include "files/atomic_file.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

}  // namespace

CheckpointFolder::CheckpointFolder(const std::string& folder)
    : latest_(fs::path(folder) / "checkpoint.h5"),
      previous_(fs::path(folder) / "checkpoint.previous.h5") {}

bool CheckpointFolder::has_latest() const { return exists(latest_); }
bool CheckpointFolder::has_previous() const { return exists(previous_); }

void CheckpointFolder::keep(std::span<const std::uint8_t> bytes) const {
  TemporaryFile latest(latest_);
  latest.write(bytes);
  latest.flush();
  if (has_latest()) keep_as_previous();
  latest.commit();
}

/// Gives the latest checkpoint a second name (a hard link), so that it keeps its own name until it is replaced. Where
/// the file system has no hard links the file is renamed: for a moment only the previous checkpoint exists.
void CheckpointFolder::keep_as_previous() const {
  if (link_atomically(latest_, previous_)) return;
  std::error_code error;
  fs::rename(latest_, previous_, error);
  if (error) throw EnvironmentError("cannot write " + previous_ + ": " + error.message());
}

void CheckpointFolder::remove() const {
  std::error_code error;
  for (const std::string& leftover : {temporary_path(latest_), temporary_path(previous_)}) fs::remove(leftover, error);
  // The latest checkpoint is removed last: after an interruption it is still there.
  for (const std::string& path : {previous_, latest_}) {
    fs::remove(path, error);
    if (error) throw EnvironmentError("cannot remove " + path + ": " + error.message());
  }
}

}  // namespace tessera
