#include "master/library_shapes.h"

namespace tessera::master {
namespace {

constexpr std::size_t kWholeShapesKept = 1024;  // about 80 MB

constexpr io::LibraryParts kBody{.outline = true, .field = true, .levels = 0, .artwork = false, .original = false};

}  // namespace

const Shape& LibraryShapes::shape(std::uint32_t index) {
  const auto known = position_.find(index);
  if (known != position_.end()) {
    recent_.splice(recent_.begin(), recent_, known->second);
    return recent_.front().shape;
  }
  recent_.push_front({index, std::move(library_.read(index, index + 1, kBody).front())});
  position_[index] = recent_.begin();
  if (recent_.size() > kWholeShapesKept) {
    position_.erase(recent_.back().index);
    recent_.pop_back();
  }
  return recent_.front().shape;
}

const ShapeModel& LibraryShapes::model(std::uint32_t index) {
  auto known = models_.find(index);
  if (known == models_.end()) {
    known = models_.emplace(index, make_shape_model(shape(index), PadParameters{}, PadParameters{}, {})).first;
  }
  return known->second;
}

}  // namespace tessera::master
