#include "core/matching/near_colours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/colour/ciede2000.h"
#include "core/tuning.h"

namespace tessera {

void NearColours::start(const StanceTable& stances) {
  if (!wish_) return;
  open_.clear();
  for (std::uint32_t i = 0; i < stances.open_shapes(); ++i) open_.push_back(index_of(stances.open_shape(i)));
  const std::uint32_t all = std::uint32_t(open_.size());
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
  const std::array<int, 3> point = {step(colour.lightness), step(colour.a), step(colour.b)};
  const auto known = lists_.find(point);
  if (known != lists_.end()) return known->second;
  const List list =
      make_list({float(point[0]) * kColourStep, float(point[1]) * kColourStep, float(point[2]) * kColourStep});
  lists_.emplace(point, list);
  return list;
}

NearColours::List NearColours::make_list(const Lab& colour) {
  std::vector<std::pair<float, std::uint32_t>> order;
  order.reserve(open_.size());
  for (const std::uint32_t shape : open_) order.emplace_back(ciede2000(colour, (*wish_.of_shapes)[shape]), shape);
  std::partial_sort(order.begin(), order.begin() + length_, order.end());
  const List list = List(lists_.size());
  bits_.resize(bits_.size() + words_, 0u);
  std::uint32_t* const bits = bits_.data() + std::size_t(list) * words_;
  for (std::uint32_t i = 0; i < length_; ++i) {
    const std::uint32_t shape = order[i].second;
    shapes_.push_back(shape);
    bits[shape / 32] |= 1u << (shape % 32);
  }
  return list;
}

bool NearColours::holds(List list, ShapeId shape) const {
  if (list == kAny) return true;
  const std::uint32_t word = bits_[std::size_t(list) * words_ + index_of(shape) / 32];
  return ((word >> (index_of(shape) % 32)) & 1u) != 0;
}

}  // namespace tessera
