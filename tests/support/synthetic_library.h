// A small library of synthetic shapes with their PADs, for tests of matching and of whole collages.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/closed_curve.h"
#include "core/matching/matching_context.h"
#include "core/shape/level_curve.h"
#include "core/shape/shape_source.h"
#include "support/synthetic_shapes.h"

namespace tessera::test {

/// Makes a test shape with all its smoothing levels.
inline Shape make_library_shape(const std::string& name, const Outline& outline) {
  Shape shape = make_test_shape(name, outline);
  const std::vector<Vec2> fine = resampled_closed(shape.outline.curves.front(), 2048);
  for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k) {
    shape.levels[k] = make_level_curve(fine, kSmoothingLevels[k], PadParameters{});
  }
  return shape;
}

/// Blobs with a star, a bean and a ring among them.
inline std::vector<Shape> synthetic_library(int count) {
  std::vector<Shape> shapes;
  for (int i = 0; i < count; ++i) {
    const std::string name = "shape" + std::to_string(i);
    switch (i) {
      case 0: shapes.push_back(make_library_shape(name, star_outline(5))); break;
      case 1: shapes.push_back(make_library_shape(name, bean_outline())); break;
      case 2: shapes.push_back(make_library_shape(name, ring_outline())); break;
      default: shapes.push_back(make_library_shape(name, blob_outline(std::uint32_t(i)))); break;
    }
  }
  return shapes;
}

/// Models of shapes [begin, end) for the levels of a context.
inline std::vector<ShapeModel> models_of(const std::vector<Shape>& shapes, const MatchingContext& context,
                                         std::size_t begin, std::size_t end) {
  std::vector<ShapeModel> models;
  for (std::size_t i = begin; i < end; ++i) {
    models.push_back(make_shape_model(shapes[i], PadParameters{}, context.pad, context.levels));
  }
  return models;
}

class VectorShapes : public ShapeSource {
 public:
  explicit VectorShapes(const std::vector<Shape>& shapes) : shapes_(shapes) {
    for (const Shape& shape : shapes) {
      models_.push_back(make_shape_model(shape, PadParameters{}, PadParameters{}, {}));
    }
  }
  const Shape& shape(ShapeId id) override { return shapes_.at(index_of(id)); }
  const ShapeModel& model(ShapeId id) override { return models_.at(index_of(id)); }

 private:
  const std::vector<Shape>& shapes_;
  std::vector<ShapeModel> models_;
};

}  // namespace tessera::test
