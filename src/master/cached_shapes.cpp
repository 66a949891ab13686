#include "master/cached_shapes.h"

namespace tessera::master {
namespace {

constexpr std::size_t kWholeShapesKept = 1024;  // about 80 MB

}  // namespace

const Shape& CachedShapes::shape(std::uint32_t index) {
  const auto known = position_.find(index);
  if (known != position_.end()) {
    recent_.splice(recent_.begin(), recent_, known->second);
    return recent_.front().shape;
  }
  recent_.push_front({index, load(index)});
  position_[index] = recent_.begin();
  if (recent_.size() > kWholeShapesKept) {
    position_.erase(recent_.back().index);
    recent_.pop_back();
  }
  return recent_.front().shape;
}

const ShapeModel& CachedShapes::model(std::uint32_t index) {
  auto known = models_.find(index);
  if (known == models_.end()) {
    known = models_.emplace(index, make_shape_model(shape(index), PadParameters{}, PadParameters{}, {})).first;
  }
  return known->second;
}

}  // namespace tessera::master
