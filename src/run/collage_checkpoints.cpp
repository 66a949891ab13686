#include "run/collage_checkpoints.h"

#include <unistd.h>

#include <cstdio>

#include "core/base/error.h"
#include "terminal/terminal.h"

namespace tessera {
namespace {

constexpr const char* kStartAgain = "--restart removes it and starts again";

/// Reads a checkpoint of this job. Throws InputError where it is damaged or belongs to another job.
CheckpointState read_matching(const std::string& path, const CheckpointOrigin& origin) {
  const Checkpoint checkpoint = read_checkpoint(path);
  check_origin(checkpoint, origin);
  return checkpoint.state;
}

bool is_good(const std::string& path, const CheckpointOrigin& origin) {
  try {
    read_matching(path, origin);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// What the user can do about a checkpoint that cannot be used.
std::string recovery_text(const CheckpointFolder& folder, Start start, const CheckpointOrigin& origin) {
  std::string text;
  if (start == Start::resume && is_good(folder.previous(), origin)) {
    text = "; " + folder.previous() + " is good: --resume=previous goes on from it";
  }
  if (start == Start::resume_previous && is_good(folder.latest(), origin)) {
    text = "; " + folder.latest() + " is good: --resume goes on from it";
  }
  return text + "; " + kStartAgain;
}

struct Found {
  std::string path;
  std::string option;  // the option that goes on from it
  bool there;
};

/// Throws InputError where the wanted checkpoint is not there. `damage`: what is wrong with the result in the folder.
void require(const Found& wanted, const Found& other, const std::string& damage) {
  if (wanted.there) return;
  throw InputError(wanted.path + ": no such file" +
                   (other.there ? "; " + other.path + " is there: " + other.option + " goes on from it"
                                : ", nothing to go on with (a finished run removes it); leave --resume out to start") +
                   (damage.empty() ? "" : "; the result in its folder is not whole: " + damage));
}

/// Throws InputError where a fresh run is wanted and there is a checkpoint.
void require_nothing(const CheckpointFolder& folder, const CheckpointOrigin& origin) {
  if (!folder.has_any()) return;
  const bool latest = folder.has_latest();
  const std::string& path = latest ? folder.latest() : folder.previous();
  try {
    read_matching(path, origin);
  } catch (const InputError& error) {
    throw InputError(error.what() + recovery_text(folder, latest ? Start::resume : Start::resume_previous, origin));
  }
  throw InputError(path + ": unfinished work; " + (latest ? "--resume" : "--resume=previous") + " goes on with it, " +
                   kStartAgain);
}

}  // namespace

Start automatic_start(const EarlierResult& earlier) {
  const CheckpointFolder folder(earlier.folder);
  if (folder.has_latest() || earlier.finished()) return Start::resume;
  return folder.has_previous() ? Start::resume_previous : Start::fresh;
}

CheckpointFolder checked_start(const EarlierResult& earlier, Start start) {
  CheckpointFolder folder(earlier.folder);
  const Found latest{folder.latest(), "--resume", folder.has_latest()};
  const Found previous{folder.previous(), "--resume=previous", folder.has_previous()};
  if (start == Start::resume && !earlier.finished()) require(latest, previous, earlier.damage);
  if (start == Start::resume_previous) require(previous, latest, earlier.damage);
  return folder;
}

std::optional<CheckpointState> starting_state(const CheckpointFolder& folder, Start start,
                                              const CheckpointOrigin& origin) {
  if (start == Start::fresh) require_nothing(folder, origin);
  if (start == Start::fresh || start == Start::restart) return {};
  try {
    return read_matching(start == Start::resume ? folder.latest() : folder.previous(), origin);
  } catch (const InputError& error) {
    throw InputError(error.what() + recovery_text(folder, start, origin));
  }
}

CollageCheckpoints::CollageCheckpoints(const CheckpointFolder& folder, const CheckpointOrigin& origin, double every_s)
    : folder_(folder),
      origin_(origin),
      every_s_(every_s) {}

bool CollageCheckpoints::due(LoopPhase /*phase*/) { return every_s_ > 0 && since_latest_.seconds() >= every_s_; }

void CollageCheckpoints::keep(const CheckpointState& state) {
  try {
    folder_.keep(checkpoint_bytes(make_checkpoint(origin_, state)));
  } catch (const EnvironmentError& error) {
    if (failure_.empty()) {
      const bool after_bar = isatty(STDERR_FILENO) == 1;
      if (after_bar) std::fputc('\n', stderr);
      print_message(std::string("warning: no checkpoint: ") + error.what() + "; the run continues without one");
    }
    failure_ = error.what();
  }
  since_latest_.lap();
}

std::string CollageCheckpoints::warning() const { return failure_.empty() ? "" : "no checkpoint: " + failure_; }

void CollageCheckpoints::require_one() const {
  if (!folder_.has_latest()) throw EnvironmentError("unfinished, and without a checkpoint: " + failure_);
}

}  // namespace tessera
