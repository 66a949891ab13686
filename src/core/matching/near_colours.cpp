#include "core/matching/near_colours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/colour/ciede2000.h"
#include "core/settings/tuning.h"

namespace tessera {
namespace {

constexpr std::size_t kMostNearestKept = std::size_t(32) << 20;  // shapes in the lists of all points together: 128 MB

}  // namespace

void NearColours::start(const StanceTable& stances) {
  if (!wish_) return;
  if (nearest_.size() * wish_.of_shapes->size() > kMostNearestKept) nearest_.clear();
  open_.assign(stances.library_shapes(), false);
  for (std::uint32_t i = 0; i < stances.open_shapes(); ++i) open_[index_of(stances.open_shape(i))] = true;
  const std::uint32_t all = stances.open_shapes();
  const float share = 1 + (kNearColourShare - 1) * std::min(1.f, wish_.weight);
  length_ = std::min(all, std::max(kLeastNearColours, std::uint32_t(float(all) / share)));
  words_ = (stances.library_shapes() + 31) / 32;
  lists_.clear();
  shapes_.clear();
  bits_.clear();
}

NearColours::List NearColours::list_for(const TargetSample& sample) {
  if (!wish_ || length_ == 0) return kAny;
  const Vec2 inward{-sample.tangent.y, sample.tangent.x};
  const Texel there =
      wish_.target->at(wish_.target->level_for(2 * depth_px_ * kColourFootprint), sample.position + inward * depth_px_);
  if (there.weight < kLeastColourWeight) return kAny;
  const auto step = [](float value) { return int(std::floor(value / kColourStep + 0.5f)); };
  const Lab colour = there.colour();
  const Point point = {step(colour.lightness), step(colour.a), step(colour.b)};
  const auto known = lists_.find(point);
  return known != lists_.end() ? known->second : make_list(point);
}

/// All shapes, nearest to the point first; among equals, the first of the library. A drawing's own contrast counts as a
/// difference, because most places of a picture are smooth.
const std::vector<std::uint32_t>& NearColours::nearest(const Point& point) {
  const auto [known, is_new] = nearest_.try_emplace(point);
  if (!is_new) return known->second;
  const Lab colour{float(point[0]) * kColourStep, float(point[1]) * kColourStep, float(point[2]) * kColourStep};
  std::vector<std::pair<float, std::uint32_t>> order;
  order.reserve(wish_.of_shapes->size());
  for (const ShapeColour& shape : *wish_.of_shapes) {
    const float of_mean = ciede2000(colour, shape.mean);
    const float own = kOwnContrast * shape.own_contrast;
    order.emplace_back(std::sqrt(of_mean * of_mean + own * own), order.size());
  }
  std::sort(order.begin(), order.end());
  known->second.reserve(order.size());
  for (const auto& [difference, shape] : order) known->second.push_back(shape);
  return known->second;
}

NearColours::List NearColours::make_list(const Point& point) {
  const List list = List(lists_.size());
  lists_.emplace(point, list);
  bits_.resize(bits_.size() + words_, 0u);
  std::uint32_t* const bits = bits_.data() + std::size_t(list) * words_;
  std::uint32_t left = length_;
  for (const std::uint32_t shape : nearest(point)) {
    if (left == 0) break;
    if (!open_[shape]) continue;
    shapes_.push_back(shape);
    bits[shape / 32] |= 1u << (shape % 32);
    --left;
  }
  return list;
}

bool NearColours::holds(List list, ShapeId shape) const {
  if (list == kAny) return true;
  const std::uint32_t word = bits_[std::size_t(list) * words_ + index_of(shape) / 32];
  return ((word >> (index_of(shape) % 32)) & 1u) != 0;
}

}  // namespace tessera
