#include "bench/segments/timed_collage.h"

#include <cmath>
#include <limits>

#include "core/base/processor_time.h"
#include "core/base/stopwatch.h"

namespace tessera::bench {
namespace {

/// Sizes over one octave: large enough for the 1.5 px by which fields blur, small enough for a fast field.
constexpr float kLeastScale_px = 50;
constexpr float kMostScale_px = 100;
/// Area of the square canvas divided by the area of all shapes at their largest. With less, some shapes find no place
/// at the rim.
constexpr double kRoom = 1.5;

/// Records pieces over processor time, and ends the loop when the time is over.
class Timer : public master::Observer {
 public:
  explicit Timer(double limit_s) : limit_s_(limit_s) {}

  void start() { start_s_ = processor_time_s(); }
  double processor_s() const { return processor_time_s() - start_s_; }
  std::vector<std::pair<double, std::size_t>> take_pieces() { return std::move(pieces_at_s_); }

  void progressed(const master::Progress& progress) override {
    const std::size_t pieces = progress.pieces - 1;  // without the seed
    if (pieces_at_s_.empty() || pieces_at_s_.back().second != pieces) pieces_at_s_.emplace_back(processor_s(), pieces);
  }
  std::optional<StopReason> stop_requested() override {
    if (processor_s() < limit_s_) return std::nullopt;
    return StopReason::time_limit;
  }

 private:
  double limit_s_;
  double start_s_ = std::numeric_limits<double>::infinity();  // infinite until the loop starts
  std::vector<std::pair<double, std::size_t>> pieces_at_s_;
};

}  // namespace

SeededCollage make_seeded_collage(std::size_t shapes) {
  const int side_px = int(std::ceil(double(kMostScale_px) * std::sqrt(kRoom * double(shapes))));
  SeededCollage collage{make_rectangle_canvas(side_px, side_px), {}};
  CollageSettings& settings = collage.settings;
  settings.pieces.min_scale_px = kLeastScale_px;
  settings.pieces.max_scale_px = kMostScale_px;
  settings.pieces.uses = 1;
  settings.start.grow_outward = true;
  settings.match.tangent_dockings = 0;
  const float middle_px = 0.5f * float(side_px);
  settings.wishes.given.push_back({ShapeId{0}, {kMostScale_px, 0, middle_px, middle_px}});
  return collage;
}

TimedCollage make_timed_collage(const SeededCollage& collage, const CollageSettings& asked, GivenShapes& shapes,
                                const CollageLimits& limits, const MakeMatcher& make) {
  CollageSettings settings = asked;
  settings.stop.pieces = limits.pieces > 0 ? limits.pieces + 1 : 0;  // the seed is one of them
  Timer timer(limits.processor_s);
  const double before_s = processor_time_s();
  TimedCollage timed;
  timed.matcher = make([&timer] { return timer.stop_requested(); });
  timed.preparation_s = processor_time_s() - before_s;

  const Stopwatch watch;
  timer.start();
  master::CollageResult made = master::make_collage(collage.canvas, settings, *timed.matcher, shapes, timer);
  timed.processor_s = timer.processor_s();
  timed.wall_s = watch.seconds();
  timed.pieces_at_s = timer.take_pieces();
  timed.placements = std::move(made.placements);
  timed.statistics = made.statistics;
  return timed;
}

}  // namespace tessera::bench
