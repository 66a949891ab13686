#include "master/off_colour.h"

#include <bit>
#include <utility>

#include "core/matching/colour_fit.h"
#include "core/settings/tuning.h"

namespace tessera::master {

std::int64_t OffColour::loss_256ths_px2(const std::vector<Placement>& placements) {
  if (!wish_) return 0;
  std::map<PosedShapeKey, std::int64_t> losses;
  std::int64_t sum = 0;
  for (const Placement& p : placements) {
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    const Similarity& pose = p.canvas_from_shape;
    const PosedShapeKey key = {std::uint32_t(index_of(p.shape)), bits(pose.a), bits(pose.b), bits(pose.tx),
                               bits(pose.ty)};
    const auto known = losses_.find(key);
    const std::int64_t loss = known != losses_.end() ? known->second : loss_of(p);
    losses.emplace(key, loss);
    sum += loss;
  }
  losses_ = std::move(losses);
  return sum;
}

std::int64_t OffColour::loss_of(const Placement& p) const {
  const double scale_px = p.canvas_from_shape.scale();
  const float difference = colour_difference(shapes_.model(p.shape).colour, p.canvas_from_shape, *wish_.target);
  return std::int64_t(256 * kOffColour * double(wish_.weight) * scale_px * scale_px * double(difference));
}

}  // namespace tessera::master
