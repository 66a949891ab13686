// How many trials improving has, or how much time: of the canvas' regions each its part by area.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/field/canvas.h"
#include "core/settings/settings.h"

namespace tessera::master {

class ImprovingBudget {
 public:
  /// Both outlive it.
  ImprovingBudget(const Canvas& canvas, const CollageSettings& settings) : canvas_(canvas), settings_(settings) {}

  double area_px2(std::uint32_t region) const;
  /// The number of the region's first trial.
  std::uint64_t first_trial(std::uint32_t region) const { return trials_below(region); }
  /// Whether there may be another trial in this region after so many, and so long, in all of them.
  bool may_go_on(std::uint32_t region, std::uint64_t trials, double improve_s) const;

  /// Of a phase of replacement trials, what it has done so far.
  struct Replaced {
    std::uint64_t trials = 0;
    double improve_s = 0;  // that improving took until now
    double total_s = 0;    // that the run took until now
  };
  /// How many replacement trials the region's phase has in all. Where only time is limited that is as many as their part
  /// of the time is enough for, as far as is known by now; `pieces`: those that may be replaced.
  std::uint64_t replacements(std::uint32_t region, std::size_t pieces, const Replaced& so_far) const;

 private:
  std::uint64_t trials_below(std::uint32_t end) const;
  std::uint64_t share_below(std::uint32_t end) const;
  double part_below(std::uint32_t end) const;

  const Canvas& canvas_;
  const CollageSettings& settings_;
};

}  // namespace tessera::master
