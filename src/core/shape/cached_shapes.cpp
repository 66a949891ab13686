#include "core/shape/cached_shapes.h"

namespace tessera {
namespace {

constexpr std::size_t kWholeShapesKept = 1024;  // about 80 MB

}  // namespace

const std::shared_ptr<const Shape>& CachedShapes::recent(ShapeId id) {
  const auto known = position_.find(id);
  if (known != position_.end()) {
    recent_.splice(recent_.begin(), recent_, known->second);
    return recent_.front().shape;
  }
  recent_.push_front({id, std::make_shared<Shape>(load(id))});
  position_[id] = recent_.begin();
  if (recent_.size() > kWholeShapesKept) {
    position_.erase(recent_.back().id);
    recent_.pop_back();
  }
  return recent_.front().shape;
}

const ShapeModel& CachedShapes::model(ShapeId id) {
  auto known = models_.find(id);
  if (known == models_.end()) {
    known = models_.emplace(id, make_shape_model(shape(id), PadParameters{}, PadParameters{}, {})).first;
  }
  return known->second;
}

}  // namespace tessera
