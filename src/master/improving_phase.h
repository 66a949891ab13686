// Improves a full region by trials. Among them is a phase in which single pieces are replaced (ours; the paper is greedy).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/base/run_statistics.h"
#include "core/base/stopwatch.h"
#include "core/collage/loop_state.h"
#include "core/field/canvas.h"
#include "core/replacing/replacer.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"
#include "master/improving.h"
#include "master/improving_budget.h"
#include "master/loop_end.h"
#include "master/loop_statistics.h"
#include "master/regions.h"

namespace tessera::master {

class ImprovingPhase {
 public:
  /// The objects that the phase works with. When the phase ends or throws Interrupted, all of it stands before the next trial or batch.
  struct Parts {
    const Canvas& canvas;
    const CollageSettings& settings;
    RegionFill& region;
    ShapeSource& shapes;
    Replacer& replacer;
    LoopState& state;
    LoopEnd& end;
    LoopStatistics& statistics;
    std::function<void()> after_step;  // called after each trial and each batch
  };

  explicit ImprovingPhase(Parts parts);

  /// Goes on until the region's trials or their time are used up, or a limit of the job is reached.
  void run();

 private:
  bool goes_on();
  void step();
  void try_once();
  void begin_replacing();
  std::uint64_t replacements();
  void replace(std::uint64_t all);
  void relax_replaced_pieces();
  void count(Trial trial);
  bool may_improve() const;
  bool reached_limit();
  std::size_t free_pieces() const;
  void take_time() { parts_.state.improve_s = earlier_s_ + watch_.seconds(); }

  Parts parts_;
  LoopState& state_;
  Collage& collage_;
  ImprovingBudget budget_;
  std::uint32_t first_trial_;
  double area_px2_;
  double earlier_s_;  // seconds of improving before this phase
  Stopwatch watch_;
  Improving improving_;
};

}  // namespace tessera::master
