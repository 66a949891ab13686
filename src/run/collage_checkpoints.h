// The checkpoints of a run of tessera collage: where the run starts, when checkpoints are written, and which are left at
// the end.
#pragma once

#include <optional>
#include <string>

#include "checkpoint/checkpoint_folder.h"
#include "checkpoint/checkpoint_origin.h"
#include "core/base/stopwatch.h"
#include "master/checkpoint_keeper.h"
#include "result/folder/finished_result.h"

namespace tessera {

enum class Start {
  fresh,            // refused where there is a checkpoint
  resume,           // from checkpoint.h5, or from a finished result
  resume_previous,  // from checkpoint.previous.h5
  restart,          // ignores and removes checkpoints
};

/// The meaning of --resume=auto for this folder: `resume` where there is a checkpoint or a finished result,
/// `resume_previous` where only the previous checkpoint is left, otherwise `fresh`.
Start automatic_start(const EarlierResult& earlier);

/// The checkpoints in the result's folder. To be called before anything costs time: throws InputError where `start` does
/// not fit them.
CheckpointFolder checked_start(const EarlierResult& earlier, Start start);

/// The state from which the run starts; empty: it starts with an empty canvas. Throws InputError where the checkpoint is
/// damaged or belongs to another job; the message says what is wrong and what to do.
std::optional<CheckpointState> starting_state(const CheckpointFolder& folder, Start start,
                                              const CheckpointOrigin& origin);

class CollageCheckpoints : public master::CheckpointKeeper {
 public:
  /// A checkpoint is due every `every_s` seconds; 0: never.
  CollageCheckpoints(const CheckpointFolder& folder, const CheckpointOrigin& origin, double every_s);

  bool due(LoopPhase phase) override;
  /// Writes the state. Where that fails, it says so on stderr, but only once.
  void keep(const CheckpointState& state) override;

  /// The message that keep() wrote to stderr; empty where there was none.
  std::string warning() const;

  /// Removes the checkpoints of a finished run. To be called after its files were written.
  void remove() const { folder_.remove(); }
  /// Throws EnvironmentError where there is no checkpoint at all. To be called after the files of an unfinished run were
  /// written.
  void require_one() const;

 private:
  CheckpointFolder folder_;
  CheckpointOrigin origin_;
  double every_s_;
  Stopwatch since_latest_;
  std::string failure_;
};

}  // namespace tessera
