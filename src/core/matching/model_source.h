// Where a matcher gets the models of its shapes: a few at a time, so that a large library never lies in memory whole.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/matching/matcher.h"

namespace tessera {

/// Which parts of the models are wanted.
struct ModelParts {
  /// If not, there are no tangents, no colours but ColourModel::mean and cell, and of the points every kCoarseStride-th
  /// of the boundary and every kInteriorStride-th of the interior, the others being anything.
  bool contours = true;
  bool pads = true;       // if not, there are no levels
  bool keypoints = true;  // of the PADs
};

class ModelSource {
 public:
  /// A PAD of a library shape, by its number among those of its levels in use.
  struct PadName {
    ShapeId shape;
    std::uint32_t source;
  };

  virtual ~ModelSource() = default;

  /// The models of the library's shapes [begin, end), in order. A matcher calls it with neighbouring ranges.
  virtual std::vector<ShapeModel> models(const ShapeRange& range, const ModelParts& parts) const = 0;

  /// The PADs of shapes [begin, end), of each all of its levels in use.
  virtual std::vector<LibraryPad> pads(const ShapeRange& range) const;

  /// Of a level in use, of some shapes that follow one another, the PADs in the order of an index (PadIndex::order);
  /// nothing where it must be made. Whatever comes is an order of all of them.
  virtual std::vector<std::uint32_t> pad_order(const ShapeRange&, std::size_t /*level*/) const { return {}; }

  /// Whether contours and key points can be read later, shape by shape and PAD by PAD; if not, models come whole.
  virtual bool reads_singly() const { return false; }
  /// Models without levels, in the order of the shapes.
  virtual std::vector<ShapeModel> contours(std::span<const ShapeId>) const { return {}; }
  /// 2 n + 1 points of each PAD, n being the levels of a pyramid, in its order.
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

/// `models[i]` is library shape first_shape + i. They outlive the source.
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
