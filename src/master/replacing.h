// Batches of replacement trials (core/replacing): in many windows of the canvas at a time, single pieces are replaced while
// their neighbours make room. All ranks work on one batch. The next batch begins with the pieces of the last one.
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

/// Whether replacement trials are of use: pieces are relaxed, and an exchange in one window does not affect others. It
/// would where the job limits uses, distances between pieces or the number of pieces, where it wishes for colours of
/// neighbours, and where it grows outward.
bool pays_to_replace(const CollageSettings& settings);

/// The part of improving that is given to replacement trials. kReplacementsPerTrial of them count as one trial: they take
/// about as long on two cores.
inline constexpr double kPartReplaced = 5.0 / 6;
/// Windows in one question, for each core that works on it: enough to share them out evenly.
inline constexpr std::size_t kWindowsAtATime = 8;
inline constexpr std::uint64_t kReplacementsPerTrial = 8;

/// The progress of a phase of replacement trials. Its temperature falls from the first trial to the last.
struct ReplacementProgress {
  std::uint64_t done = 0;  // trials
  std::uint64_t all = 0;
};

class Replacing {
 public:
  /// Replaces pieces on the canvas of `free`; the pieces that lie in `free` do not matter. `stances`: the stances of shapes
  /// that may come in. `area_px2`: the area to be filled. All arguments but the settings outlive this object.
  Replacing(const FreeField& free, const StanceTable& stances, const CollageSettings& settings, double area_px2,
            ShapeSource& shapes, PosesOf poses_of, Replacer& replacer);

  /// `placements` after one more batch, of about two trials a piece. The first `given` stay; any other may have been
  /// replaced. Adds to `progress.done`. The outcome depends on the arguments and the settings alone, on any ranks. Calls
  /// `check_stop` regularly while this rank computes; where it throws, nothing has changed.
  std::vector<Placement> batch(const std::vector<Placement>& placements, std::size_t given,
                               ReplacementProgress& progress, const StopCheck& check_stop = never_stop);

 private:
  void plan(std::vector<CutWindow>& cuts, ReplacementProgress& progress) const;
  std::vector<ReplacementOutcome> run_windows(std::vector<CutWindow>& cuts, const std::vector<PosedPiece>& all,
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
