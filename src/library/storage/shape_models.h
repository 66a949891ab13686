// Reads the models of shapes that matching needs.
#pragma once

#include <memory>
#include <vector>

#include "core/matching/model_source.h"
#include "library/storage/shape_library.h"

namespace tessera {

/// The models with the levels that the context uses. Only a few whole shapes are in memory at a time: models need a
/// twentieth of their memory.
std::vector<ShapeModel> read_models(const ShapeLibrary& library, const ShapeRange& range,
                                    const MatchingContext& context);

/// The models stored in the library's file. Where there are none, a source that reads shapes and makes their models when
/// asked. The library outlives it.
std::shared_ptr<const ModelSource> models_of(const ShapeLibrary& library, const MatchingContext& context);

}  // namespace tessera
