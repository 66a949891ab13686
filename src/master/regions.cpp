#include "master/regions.h"

#include <optional>
#include <utility>

#include "core/matching/sized_settings.h"

namespace tessera::master {
namespace {

Canvas region_of(const Canvas& canvas, std::uint32_t region) {
  return {.width_px = canvas.width_px,
          .height_px = canvas.height_px,
          .distance = canvas.regions.empty() ? canvas.distance : canvas.regions[region].distance,
          .area_px2 = canvas.area_px2,
          .keep_out = canvas.keep_out,
          .period = canvas.period};
}

}  // namespace

RegionFill::RegionFill(const Canvas& region, const CollageSettings& settings, const MatchingContext& context,
                       float size_factor, Matcher& matcher, ShapeSource& shapes, RunStatistics& statistics,
                       StopCheck check_stop)
    : sized(with_sizes_times(double(size_factor), settings)),
      collage(region, sized, context, shapes, size_factor),
      filling(collage, context, sized, matcher, statistics, std::move(check_stop)) {}

Regions::Regions(const Canvas& canvas, const CollageSettings& settings, Matcher& matcher, ShapeSource& shapes,
                 RunStatistics& statistics, StopCheck check_stop)
    : canvas_(canvas),
      settings_(settings),
      matcher_(matcher),
      shapes_(shapes),
      statistics_(statistics),
      check_stop_(std::move(check_stop)),
      context_(make_matching_context(settings, matcher.shapes().end)),
      sizes_(settings.pieces),
      given_(canvas, settings.wishes, shapes) {}

void Regions::begin(std::uint32_t region, StandingPieces standing, const SizeAttempts& sizes) {
  const Canvas part = region_of(canvas_, region);
  current_ = std::make_unique<RegionFill>(part, settings_, context_, sizes.factor(), matcher_, shapes_, statistics_,
                                          check_stop_);
  Collage& collage = current_->collage;
  if (settings_.start.grow_outward) {
    collage.grow_by(OutwardGrowth(part, current_->sized.pieces, standing.pieces, shapes_));
  }
  collage.begin(std::move(standing.pieces), standing.given, region);
}

void Regions::begin_first() { begin(0, given_.at_first(), sizes_); }

/// Gives all pieces that stand to the next region as fixed ones, but for the pieces that may move there.
bool Regions::begin_next() {
  const std::uint32_t next = region() + 1;
  if (next >= canvas_.regions.size()) return false;
  begin(next, given_.when_begun(next, current_->collage.placements()), sizes_);
  return true;
}

/// Begins the region with the pieces that stood when it was begun: the first `given` of `placements`. In the first region
/// these are all pieces that the job gives.
void Regions::begin_again(std::uint32_t region, std::vector<Placement> placements, std::size_t given,
                          const SizeAttempts& sizes) {
  placements.resize(given);
  begin(region, region == 0 ? given_.at_first() : given_.when_begun_with(region, std::move(placements)), sizes);
}

/// Where the matcher interrupts this function or one of the next two, nothing has changed yet.
bool Regions::begin_other_sizes() {
  if (sizes_.over()) return false;
  const Collage& collage = current_->collage;
  SizeAttempts next = sizes_;
  next.end_attempt(collage.open_shapes().shortage(), collage.placements());
  if (next.over()) return go_back_to_best(std::move(next));
  begin_again(region(), collage.placements(), collage.open_shapes().given(), next);
  sizes_ = std::move(next);
  return true;
}

void Regions::keep_best() {
  if (sizes_.over()) return;
  SizeAttempts ended = sizes_;
  ended.give_up(current_->collage.open_shapes().shortage(), current_->collage.placements());
  go_back_to_best(std::move(ended));
}

/// Places the pieces of the best attempt again. False where that is the last attempt. No other sizes are tried afterwards.
bool Regions::go_back_to_best(SizeAttempts sizes) {
  const std::optional<std::vector<Placement>> best = sizes.take_best();
  if (best) {
    begin_again(region(), *best, current_->collage.open_shapes().given(), sizes);
    Collage& collage = current_->collage;
    collage.replace_placements(*best);
    collage.schedule().mark(collage.free().field().value.bounds());
  }
  sizes_ = std::move(sizes);
  return best.has_value();
}

}  // namespace tessera::master
