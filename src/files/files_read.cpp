#include "files/files_read.h"

#include <mutex>
#include <set>
#include <tuple>

namespace tessera {
namespace {

/// Identifies a file. The inode number of a deleted file may be given to a new one: the time tells them apart.
using Identity = std::tuple<dev_t, ino_t, time_t, long>;

Identity identity_of(const struct stat& status) {
  return {status.st_dev, status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

std::mutex mutex;
std::set<Identity>& files() {
  static std::set<Identity> all;
  return all;
}

}  // namespace

void note_as_read(const struct stat& status) {
  const std::scoped_lock lock(mutex);
  files().insert(identity_of(status));
}

bool was_read(const struct stat& status) {
  const std::scoped_lock lock(mutex);
  return files().contains(identity_of(status));
}

}  // namespace tessera
