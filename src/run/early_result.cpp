#include "run/early_result.h"

#include "core/base/error.h"
#include "run/collage_publishing.h"
#include "terminal/terminal.h"

namespace tessera {

bool EarlyResult::due(LoopPhase phase) {
  return (!is_written_ && phase != LoopPhase::filling) || checkpoints_.due(phase);
}

void EarlyResult::keep(const CheckpointState& state) {
  checkpoints_.keep(state);
  if (is_written_ || state.loop.phase == LoopPhase::filling) return;
  is_written_ = true;
  master::CollageResult result{};
  result.placements = state.placements;
  result.statistics = state.statistics;
  result.unfinished = true;
  result.statistics.stopped_by = StopReason::signal;  // as if it had been interrupted here
  try {
    publish(input_, result, {}, {}, record_, checkpoints_);
  } catch (const EnvironmentError& error) {
    print_warning(std::string("no early result: ") + error.what());
  }
}

}  // namespace tessera
