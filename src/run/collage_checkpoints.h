// The checkpoints of a run of tessera collage: where it starts from, when they are written, and what is left at the
// end.
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
  fresh,            // there must be no checkpoint
  resume,           // from checkpoint.h5, or from a finished result
  resume_previous,  // from checkpoint.previous.h5
  restart,          // as if there were no checkpoint
};

/// What --resume=auto means for this folder: `resume` where there is a checkpoint or a finished result,
/// `resume_previous` where only that checkpoint is left, or `fresh`.
Start automatic_start(const EarlierResult& earlier);

/// The checkpoints in the result's folder. Before anything costs time: throws InputError where `start` does not go with
/// what is there.
CheckpointFolder checked_start(const EarlierResult& earlier, Start start);

/// What the run starts from, if not from an empty canvas. Throws InputError that says what is wrong and what to do
/// where the checkpoint is damaged or belongs to others.
std::optional<CheckpointState> starting_state(const CheckpointFolder& folder, Start start,
                                              const CheckpointOrigin& origin);

class CollageCheckpoints : public master::CheckpointKeeper {
 public:
  /// One is due every `every_s`, s; 0: none is.
  CollageCheckpoints(const CheckpointFolder& folder, const CheckpointOrigin& origin, double every_s);

  bool due() override;
  /// Where the state cannot be written, says so on stderr, once.
  void keep(const CheckpointState& state) override;

  /// What keep() said on stderr; empty where it said nothing.
  std::string warning() const;

  /// To be called after the files of a finished run were written, when there is nothing to go on with.
  void remove() const { folder_.remove(); }
  /// To be called after those of an unfinished run were written. Throws EnvironmentError where there is no checkpoint
  /// at all.
  void require_one() const;

 private:
  CheckpointFolder folder_;
  CheckpointOrigin origin_;
  double every_s_;
  Stopwatch since_latest_;
  std::string failure_;
};

}  // namespace tessera
