// Reads from the library file what matching needs of it.
#pragma once

#include <memory>
#include <vector>

#include "core/matching/model_source.h"
#include "library/storage/shape_library.h"

namespace tessera {

/// The models with the levels that the context uses. A few shapes at a time are read whole, as the models need a
/// twentieth of their memory.
std::vector<ShapeModel> read_models(const ShapeLibrary& library, const ShapeRange& range,
                                    const MatchingContext& context);

/// As they are stored in the library's file, or read and made when it is asked. The library outlives it.
std::shared_ptr<const ModelSource> models_of(const ShapeLibrary& library, const MatchingContext& context);

}  // namespace tessera
