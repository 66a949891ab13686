// Source of the shape models of a matcher. It gives a few at a time, so that a large library never lies in memory
// whole.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/matching/matcher.h"

namespace tessera {

/// The parts of the models that the caller needs.
struct ModelParts {
  /// If false, there are no tangents, and no colours but ColourModel::mean and cell. Of the points only every
  /// kCoarseStride-th of the boundary and every kInteriorStride-th of the interior are valid.
  bool contours = true;
  bool pads = true;       // if false, there are no levels
  bool keypoints = true;  // of the PADs
};

class ModelSource {
 public:
  /// A PAD of a library shape: the shape, and the PAD's number among all levels in use.
  struct PadName {
    ShapeId shape;
    std::uint32_t source;
  };

  virtual ~ModelSource() = default;

  /// The models of the library's shapes [begin, end), in order. A matcher calls it with neighbouring ranges.
  virtual std::vector<ShapeModel> models(const ShapeRange& range, const ModelParts& parts) const = 0;

  /// The PADs of the shapes [begin, end), for each shape all of its levels in use.
  virtual std::vector<LibraryPad> pads(const ShapeRange& range) const;

  /// The order of an index (PadIndex::order) for the PADs of a level in use and a range of shapes: a permutation of all
  /// of them. Empty if the caller must compute the order.
  virtual std::vector<std::uint32_t> pad_order(const ShapeRange&, std::size_t /*level*/) const { return {}; }

  /// Whether contours and key points can be read later, shape by shape and PAD by PAD. If false, models come whole.
  virtual bool supports_random_access() const { return false; }
  /// Models without levels, in the order of the shapes.
  virtual std::vector<ShapeModel> contours(std::span<const ShapeId>) const { return {}; }
  /// 2 n + 1 points for each PAD, in the pyramid's order; n is the number of levels of a pyramid.
  virtual std::vector<ModelSample::Step> keypoints(std::span<const PadName>) const { return {}; }

 protected:
  ModelSource() = default;
  ModelSource(const ModelSource&) = default;
  ModelSource& operator=(const ModelSource&) = default;
};

/// Models that a function makes.
class MadeModels : public ModelSource {
 public:
  using Make = std::function<std::vector<ShapeModel>(const ShapeRange&)>;

  explicit MadeModels(Make make) : make_(std::move(make)) {}
  std::vector<ShapeModel> models(const ShapeRange& range, const ModelParts&) const override { return make_(range); }

 private:
  Make make_;
};

/// `models[i]` is library shape first_shape + i. The models outlive the source.
inline std::shared_ptr<const ModelSource> given(const std::vector<ShapeModel>& models, std::uint32_t first_shape = 0) {
  return std::make_shared<MadeModels>([&models, first_shape](const ShapeRange& range) {
    return std::vector<ShapeModel>(models.begin() + (range.begin - first_shape),
                                   models.begin() + (range.end - first_shape));
  });
}

inline ShapeRange all_of(const std::vector<ShapeModel>& models, std::uint32_t first_shape = 0) {
  return {first_shape, first_shape + std::uint32_t(models.size())};
}

}  // namespace tessera
