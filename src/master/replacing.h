// Batches of replacement trials (core/replacing): pieces are replaced while their neighbours make room, in many windows
// of the canvas at a time. All ranks work on one batch; the next one begins where it ended.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "core/base/stop.h"
#include "core/collage/placement.h"
#include "core/field/free_field.h"
#include "core/matching/stances.h"
#include "core/replacing/canvas_windows.h"
#include "core/replacing/replacer.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"

namespace tessera::master {

/// Where pieces move together, and no exchange decides over others: by uses or distances that are kept, by colours of
/// neighbours, by the number of pieces, or by growth outward.
bool pays_to_replace(const CollageSettings& settings);

/// Of all trials of improving this part are replacements, so many for one: they take about as long, on two cores.
inline constexpr double kPartReplaced = 5.0 / 6;
/// Of a question, for each that works on them: enough to share them out evenly.
inline constexpr std::size_t kWindowsAtATime = 8;
inline constexpr std::uint64_t kReplacementsPerTrial = 8;

/// Of how many a phase consists, as it cools down.
struct ReplacementProgress {
  std::uint64_t done = 0;  // trials
  std::uint64_t all = 0;
};

class Replacing {
 public:
  /// On the canvas of `free`, whatever lies in it. `stances`: of what may come in; `area_px2`: of what is to be filled.
  /// All but the settings outlive it.
  Replacing(const FreeField& free, const StanceTable& stances, const CollageSettings& settings, double area_px2,
            ShapeSource& shapes, PosesOf poses_of, Replacer& replacer);

  /// `placements` after one more batch of trials, about two for each piece; all but the first `given` may be gone. Adds
  /// to `progress.done`. What follows from the arguments and the settings is the same whoever works on it.
  /// `check_stop` is called now and then while this rank computes; what it throws leaves nothing changed.
  std::vector<Placement> batch(const std::vector<Placement>& placements, std::size_t given,
                               ReplacementProgress& progress, const StopCheck& check_stop = never_stop);

 private:
  void plan(std::vector<CutWindow>& cuts, ReplacementProgress& progress) const;
  std::vector<ReplacementOutcome> asked(std::vector<CutWindow>& cuts, const std::vector<PosedPiece>& all,
                                        const std::vector<IncomingShape>& incoming, const StopCheck& check_stop);
  std::vector<Placement> joined(const std::vector<Placement>& placements, const std::vector<CutWindow>& cuts,
                                const std::vector<ReplacementOutcome>& outcomes) const;

  Period period_;
  CanvasWindows windows_;
  const StanceTable& stances_;
  CollageSettings settings_;
  ShapeSource& shapes_;
  PosesOf poses_of_;
  Replacer& replacer_;
};

}  // namespace tessera::master
