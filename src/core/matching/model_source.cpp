#include "core/matching/model_source.h"

namespace tessera {

std::vector<LibraryPad> ModelSource::pads(const ShapeRange& range) const {
  std::vector<LibraryPad> pads;
  for (const ShapeModel& model : models(range, {.contours = false, .keypoints = false})) {
    for (const ModelLevel& level : model.levels) {
      for (const ModelSample& sample : level.samples)
        pads.push_back({sample.pad, sample.scale_length, sample.convexity});
    }
  }
  return pads;
}

}  // namespace tessera
