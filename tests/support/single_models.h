// A model source that reads shape by shape and PAD by PAD, as for a very large library. Parts that were not asked for have wrong values.
#pragma once

#include "core/matching/model_source.h"

namespace tessera::test {

class SingleModels : public ModelSource {
 public:
  SingleModels(std::vector<ShapeModel> models, std::uint32_t first_shape, int pad_levels)
      : models_(std::move(models)),
        first_shape_(first_shape),
        pad_levels_(pad_levels) {}

  std::vector<ShapeModel> models(const ShapeRange& range, const ModelParts& parts) const override {
    std::vector<ShapeModel> result(models_.begin() + (range.begin - first_shape_),
                                   models_.begin() + (range.end - first_shape_));
    for (ShapeModel& model : result) {
      if (!parts.contours) leave_sketch(model);
      if (!parts.pads) model.levels.clear();
      if (!parts.keypoints) leave_pads(model);
    }
    return result;
  }

  bool supports_random_access() const override { return true; }

  std::vector<ShapeModel> contours(std::span<const ShapeId> shapes) const override {
    std::vector<ShapeModel> result;
    for (const ShapeId shape : shapes) {
      result.push_back(model(shape));
      result.back().levels.clear();
    }
    contours_read_ += shapes.size();
    return result;
  }

  std::vector<ModelSample::Step> keypoints(std::span<const PadName> pads) const override {
    std::vector<ModelSample::Step> result;
    for (PadName pad : pads) {
      std::size_t level = 0;
      for (; pad.source >= model(pad.shape).levels[level].samples.size(); ++level) {
        pad.source -= std::uint32_t(model(pad.shape).levels[level].samples.size());
      }
      const auto& points = model(pad.shape).levels[level].samples[pad.source].keypoint;
      result.insert(result.end(), points.begin(), points.begin() + 2 * pad_levels_ + 1);
    }
    return result;
  }

  std::size_t contours_read() const { return contours_read_; }

 private:
  const ShapeModel& model(ShapeId shape) const { return models_.at(index_of(shape) - first_shape_); }

  static void leave_sketch(ShapeModel& model) {
    constexpr Vec2 kWrong{-7, 13};
    model.tangent.fill(kWrong);
    for (std::size_t i = 0; i < model.boundary.size(); ++i) {
      if (i % kCoarseStride != 0) model.boundary[i] = kWrong;
    }
    for (std::size_t i = 0; i < model.interior.size(); ++i) {
      if (i % kInteriorStride != 0) model.interior[i] = kWrong;
    }
    model.colour.at = {};
    model.colour.colour = {};
    model.colour.part = {};
  }

  static void leave_pads(ShapeModel& model) {
    for (ModelLevel& level : model.levels) {
      for (ModelSample& sample : level.samples) sample.keypoint = {};
    }
  }

  std::vector<ShapeModel> models_;
  std::uint32_t first_shape_;
  int pad_levels_;
  mutable std::size_t contours_read_ = 0;
};

}  // namespace tessera::test
