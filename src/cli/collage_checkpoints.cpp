#include "cli/collage_checkpoints.h"

#include <unistd.h>

#include <cstdio>

#include "core/error.h"

namespace tessera::cli {
namespace {

constexpr const char* kStartAgain = "--restart removes it and starts again";

/// Throws InputError.
CheckpointState read_matching(const std::string& path, const io::CheckpointOrigin& origin) {
  const io::Checkpoint checkpoint = io::read_checkpoint(path);
  io::check_origin(checkpoint, origin);
  return checkpoint.state;
}

bool is_good(const std::string& path, const io::CheckpointOrigin& origin) {
  try {
    read_matching(path, origin);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// What to do about a checkpoint that cannot be used.
std::string ways_out(const io::CheckpointFolder& folder, Start start, const io::CheckpointOrigin& origin) {
  std::string text;
  if (start == Start::resume && is_good(folder.previous(), origin)) {
    text = "; " + folder.previous() + " is good: --resume=previous goes on from it";
  }
  if (start == Start::resume_previous && is_good(folder.latest(), origin)) {
    text = "; " + folder.latest() + " is good: --resume goes on from it";
  }
  return text + "; " + kStartAgain;
}

}  // namespace

void check_start(const io::CheckpointFolder& folder, Start start) {
  if (start == Start::fresh && (folder.has_latest() || folder.has_previous())) {
    throw InputError((folder.has_latest() ? folder.latest() : folder.previous()) + ": unfinished work; " +
                     (folder.has_latest() ? "--resume" : "--resume=previous") + " goes on with it, " + kStartAgain);
  }
  if (start == Start::resume && !folder.has_latest()) {
    throw InputError(folder.latest() + ": no such file, nothing to go on with (a finished run removes it)" +
                     (folder.has_previous() ? "; " + folder.previous() + " is there: --resume=previous goes on from it"
                                            : "; leave --resume out to start"));
  }
  if (start == Start::resume_previous && !folder.has_previous()) {
    throw InputError(folder.previous() + ": no such file" +
                     (folder.has_latest()
                          ? "; " + folder.latest() + " is there: --resume goes on from it"
                          : ", nothing to go on with (a finished run removes it); leave --resume out to "
                            "start"));
  }
}

std::optional<CheckpointState> starting_state(const io::CheckpointFolder& folder, Start start,
                                              const io::CheckpointOrigin& origin) {
  if (start == Start::fresh || start == Start::restart) return {};
  try {
    return read_matching(start == Start::resume ? folder.latest() : folder.previous(), origin);
  } catch (const InputError& error) {
    throw InputError(error.what() + ways_out(folder, start, origin));
  }
}

CollageCheckpoints::CollageCheckpoints(const io::CheckpointFolder& folder, const io::CheckpointOrigin& origin)
    : folder_(folder),
      origin_(origin) {}

bool CollageCheckpoints::due() {
  const double every_s = origin_.job->checkpoint.every_s;
  return every_s > 0 && since_latest_.seconds() >= every_s;
}

void CollageCheckpoints::keep(const CheckpointState& state) {
  try {
    folder_.keep(io::checkpoint_bytes(io::make_checkpoint(origin_, state)));
  } catch (const EnvironmentError& error) {
    if (failure_.empty()) {
      const bool after_bar = isatty(STDERR_FILENO) == 1;
      std::fprintf(stderr, "%stessera: warning: no checkpoint: %s; going on without\n", after_bar ? "\n" : "",
                   error.what());
    }
    failure_ = error.what();
  }
  since_latest_.lap();
}

void CollageCheckpoints::require_one() const {
  if (!folder_.has_latest()) throw EnvironmentError("unfinished, and without a checkpoint: " + failure_);
}

}  // namespace tessera::cli
