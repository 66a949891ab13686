#include "files/new_folder.h"

#include <filesystem>
#include <system_error>
#include <vector>

#include "core/base/error.h"
#include "core/base/stop.h"
#include "files/atomic_file.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

bool holds_something(const std::string& folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
    if (at->path() != folder_lock_path(folder)) return true;
  }
  return false;
}

/// Removes the paths that were added, unless finish() was called.
class RemovedUnlessFinished {
 public:
  ~RemovedUnlessFinished() {
    std::error_code ignored;
    for (auto path = paths_.rbegin(); path != paths_.rend(); ++path) fs::remove(*path, ignored);
  }
  void add(const fs::path& path) { paths_.push_back(path); }
  void finish() { paths_.clear(); }

 private:
  std::vector<fs::path> paths_;  // folders before their content
};

}  // namespace

NewFolder::NewFolder(const std::string& folder)
    : folder_(folder),
      made_(folder),
      lock_(folder_lock_path(folder), folder) {
  if (holds_something(folder))
    throw InputError(folder + ": exists already and is not empty; allowed: a new or an empty folder (--out DIR)");
}

void NewFolder::write(const std::vector<NewFile>& files, const StopCheck& check_stop) {
  RemovedUnlessFinished unfinished;
  for (const NewFile& file : files) {
    check_stop();
    const fs::path path = fs::path(folder_) / file.name;
    std::error_code error;
    if (fs::create_directory(path.parent_path(), error)) unfinished.add(path.parent_path());
    if (error) throw EnvironmentError("cannot make the folder " + path.parent_path().string() + ": " + error.message());
    unfinished.add(path);
    write_file_atomically(path.string(), file.bytes);
  }
  unfinished.finish();
}

}  // namespace tessera
