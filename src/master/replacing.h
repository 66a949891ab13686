// Pieces are replaced while their neighbours make room (core/replacing), in many windows of the canvas at a time: all
// ranks work on one batch, which begins where the last one ended.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "core/base/stop.h"
#include "core/collage/placement.h"
#include "core/field/free_field.h"
#include "core/matching/stances.h"
#include "core/replacing/replacer.h"
#include "core/settings/settings.h"
#include "core/shape/shape_source.h"

namespace tessera::master {

/// Where pieces move together, and no exchange decides over others: by uses or distances that are kept, by colours of
/// neighbours, by the number of pieces, or by growth outward.
bool pays_to_replace(const CollageSettings& settings);

/// How many drawings may stand: mirror images and other colours are one.
std::size_t drawings_of(const StanceTable& stances, const ShapeSource& shapes);
/// On `area_px2` of canvas. An even share is what each drawing would cover if all covered alike, no less than a piece of
/// the middle size. Copies reach each other half as far as they would lie apart if all drawings took turns: as many of
/// few drawings lie near each other wherever they lie.
RepetitionCosts repetition_costs(const CollageSettings& settings, std::size_t drawings, double area_px2);

/// Of all trials of improving this part are replacements, so many for one: they take about as long, on two cores.
inline constexpr double kPartReplaced = 5.0 / 6;
/// Of a question, for each that works on them: enough to share them out evenly.
inline constexpr std::size_t kWindowsAtATime = 8;
inline constexpr std::uint64_t kReplacementsPerTrial = 8;

/// How wide and high a window of this job is at least.
float least_window_px(const PieceSettings& pieces);

/// Of how many a phase consists, as it cools down.
struct ReplacementProgress {
  std::uint64_t done = 0;  // trials
  std::uint64_t all = 0;
};

class Replacing {
 public:
  using PosesOf = std::function<PoseRange(const Placement&)>;

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
  /// A piece as it lies, and the box of its outline, nearly.
  struct Lying {
    WindowPiece piece;
    Box box;
  };
  struct Cut {
    ReplacementWindow window;
    std::vector<std::size_t> moving;  // the placements that move in it
  };

  std::vector<Lying> lying(const std::vector<Placement>& placements, const StopCheck& check_stop) const;
  std::vector<Cut> cut_all(const std::vector<Lying>& all, std::size_t given, std::uint64_t key,
                           const StopCheck& check_stop) const;
  Cut cut(const Box& box, const std::vector<Lying>& all, std::size_t given) const;
  std::vector<PlacedDrawing> copies_around(const Box& box, const std::vector<Lying>& all,
                                           const std::vector<std::size_t>& but) const;
  void complete(ReplacementWindow& window) const;
  std::vector<ReplacementOutcome> asked(std::vector<Cut>& cuts, const std::vector<Lying>& all,
                                        const std::vector<IncomingShape>& incoming, const StopCheck& check_stop);
  EdgeField edge_around(const Box& box) const;
  std::vector<IncomingShape> drawn_shapes(std::uint64_t random) const;
  std::vector<IncomingShape> let_into(const Box& box, const std::vector<IncomingShape>& incoming) const;
  std::vector<DrawingArea> drawn_in(const ReplacementWindow& window, const std::map<ShapeId, double>& all_px2) const;
  void plan(std::vector<Cut>& cuts, ReplacementProgress& progress) const;
  std::vector<Placement> joined(const std::vector<Placement>& placements, const std::vector<Cut>& cuts,
                                const std::vector<ReplacementOutcome>& outcomes) const;

  const FreeField& free_;
  const StanceTable& stances_;
  CollageSettings settings_;
  RepetitionCosts repetition_;
  ShapeSource& shapes_;
  PosesOf poses_of_;
  Replacer& replacer_;
};

}  // namespace tessera::master
