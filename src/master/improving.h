// Improves a full collage beyond the greedy choice, which the paper names as its limit (section 6). A trial of ruin and
// recreate takes out a few small pieces beside a gap and fills the hole again. Some trials relax all pieces together
// instead: they move, turn and grow. A trial is kept where it lowers the loss: free and doubly covered area, dwarfs,
// repetition and wrong colours.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "core/base/stop.h"
#include "core/replacing/replacement.h"
#include "master/collage.h"
#include "master/filling.h"
#include "master/off_colour.h"
#include "master/relaxing.h"

namespace tessera::master {

enum class Trial { kept, put_back };

class Improving {
 public:
  /// `area_px2`: the area that the collage fills. All arguments but the settings outlive this object.
  Improving(Collage& collage, Filling& filling, const CollageSettings& settings, double area_px2, ShapeSource& shapes);

  /// Makes trial number `trial`; `earlier` is the number of the region's first trial. The outcome follows from these
  /// numbers and the placements alone. Calls `check_stop` before every piece and while pieces move. Where `check_stop` or
  /// the matcher throws Interrupted, restores the placements and throws it on.
  Trial try_once(std::uint32_t trial, const StopCheck& check_stop, std::uint32_t earlier = 0);

  /// A trial that replaces the placements by these, which may overlap, and relaxes them until their outlines are clear of
  /// each other.
  Trial relax_replaced_pieces(const std::vector<Placement>& placements, std::uint32_t trial,
                              const StopCheck& check_stop);

 private:
  std::vector<std::size_t> pieces_near(Vec2 gap_px) const;
  /// The placements without a few beside a gap. All placements where there is no gap or no small piece.
  std::vector<Placement> ruined(std::uint64_t random);
  void recreate(std::uint32_t trial, const StopCheck& check_stop);
  void relax_all(const std::vector<Placement>& from, std::span<const RelaxationSchedule> schedules, std::uint32_t trial,
                 const StopCheck& check_stop);
  Trial try_with(const std::function<void()>& change, const StopCheck& check_stop);
  void fill(const StopCheck& check_stop);
  std::int64_t loss_256ths_px2();
  std::int64_t dwarfs_256ths_px2() const;
  std::int64_t repeated_256ths_px2() const;

  Collage& collage_;
  Filling& filling_;
  ShapeSource& shapes_;
  Relaxing relaxing_;
  bool relax_;
  std::uint32_t trials_per_relaxation_;
  PieceSettings pieces_;
  double dwarf_loss_;  // part of a dwarf's area that counts as loss
  OffColour off_colour_;
  RepetitionCosts repetition_;  // all 0 where pieces are never replaced
  std::uint64_t seed_;
  float most_scale_px_;
  std::size_t most_pieces_;
};

}  // namespace tessera::master
