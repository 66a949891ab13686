// Writes a result once its canvas is filled, before trials improve it: for somebody who waits (tessera serve).
#pragma once

#include "master/checkpoint_keeper.h"
#include "result/folder/run_record.h"
#include "run/collage_checkpoints.h"
#include "run/collage_input.h"

namespace tessera {

/// Keeps the checkpoints of a run. With the first one after filling it writes the files of an unfinished result, too.
class EarlyResult : public master::CheckpointKeeper {
 public:
  EarlyResult(const CollageInput& input, const RunRecord& record, CollageCheckpoints& checkpoints)
      : input_(input),
        record_(record),
        checkpoints_(checkpoints) {}

  bool due(LoopPhase phase) override;
  /// Keeps the checkpoint. The run goes on, too, where the early result cannot be written.
  void keep(const CheckpointState& state) override;

 private:
  const CollageInput& input_;
  RunRecord record_;
  CollageCheckpoints& checkpoints_;
  bool is_written_ = false;
};

}  // namespace tessera
