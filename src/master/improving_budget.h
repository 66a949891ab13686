// The budget of improving in trials or in time. Each region of the canvas gets its part by area.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/field/canvas.h"
#include "core/settings/settings.h"

namespace tessera::master {

class ImprovingBudget {
 public:
  /// Both arguments outlive it.
  ImprovingBudget(const Canvas& canvas, const CollageSettings& settings) : canvas_(canvas), settings_(settings) {}

  double area_px2(std::uint32_t region) const;
  /// The number of the region's first trial.
  std::uint64_t first_trial(std::uint32_t region) const { return trials_below(region); }
  /// Whether the region may have another trial, after `trials` trials and `improve_s` seconds in all regions together.
  bool may_go_on(std::uint32_t region, std::uint64_t trials, double improve_s) const;

  /// The progress of a phase of replacement trials.
  struct Replaced {
    std::uint64_t trials = 0;
    double improve_s = 0;  // seconds of improving until now
    double total_s = 0;    // seconds of the run until now
  };
  /// The number of replacement trials that the region's phase has in all. Where only time is limited, it estimates how many fit into
  /// their part of the time, from the trials so far. `pieces`: the number of pieces that may be replaced.
  std::uint64_t replacements(std::uint32_t region, std::size_t pieces, const Replaced& so_far) const;

 private:
  std::uint64_t trials_below(std::uint32_t end) const;
  std::uint64_t share_below(std::uint32_t end) const;
  double part_below(std::uint32_t end) const;

  const Canvas& canvas_;
  const CollageSettings& settings_;
};

}  // namespace tessera::master
