// Beyond greedy, which the paper names as its limit (section 6). A trial of ruin and recreate takes a few small pieces
// beside a gap out and fills the hole again; now and then all pieces move, turn and grow together instead. The result
// is kept where more of the canvas is covered, and not by dwarfs or by copies of a few drawings alone.
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
  /// `area_px2`: of what the collage fills. All but the settings outlive it.
  Improving(Collage& collage, Filling& filling, const CollageSettings& settings, double area_px2, ShapeSource& shapes);

  /// Trial number `trial`, of which `earlier` were before the region was begun: its outcome follows from these numbers
  /// and the placements alone. `check_stop` is called before every piece and while pieces move. Where it or the matcher
  /// throws Interrupted, the trial leaves the placements as they were and throws it on.
  Trial try_once(std::uint32_t trial, const StopCheck& check_stop, std::uint32_t earlier = 0);

  /// A trial that takes these placements instead of those that stand, and lets their pieces come to rest: they may lie
  /// in each other.
  Trial come_to_rest(const std::vector<Placement>& placements, std::uint32_t trial, const StopCheck& check_stop);

 private:
  std::vector<std::size_t> pieces_near(Vec2 gap_px) const;
  /// The placements without a few beside a gap; all of them where there is no gap, or no small piece.
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
  double dwarf_loss_;  // of a dwarf's area
  OffColour off_colour_;
  RepetitionCosts repetition_;  // none where pieces are never exchanged
  std::uint64_t seed_;
  float most_scale_px_;
  std::size_t most_pieces_;
};

}  // namespace tessera::master
