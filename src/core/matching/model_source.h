// Where a matcher gets the models of its shapes: a few at a time, so that a large library never lies in memory whole.
#pragma once

#include <functional>
#include <vector>

#include "core/matching/matcher.h"

namespace tessera {

/// The models of the library's shapes [begin, end), in order. It is called with neighbouring ranges, each once.
using ModelSource = std::function<std::vector<ShapeModel>(const ShapeRange&)>;

/// `models[i]` is library shape first_shape + i. They outlive the source.
inline ModelSource given(const std::vector<ShapeModel>& models, std::uint32_t first_shape = 0) {
  return [&models, first_shape](const ShapeRange& range) {
    return std::vector<ShapeModel>(models.begin() + (range.begin - first_shape),
                                   models.begin() + (range.end - first_shape));
  };
}

inline ShapeRange all_of(const std::vector<ShapeModel>& models, std::uint32_t first_shape = 0) {
  return {first_shape, first_shape + std::uint32_t(models.size())};
}

}  // namespace tessera
