// The models of a very large library in a file of their own, laid out as in a library file
// (library/storage/segment_layout.h). It omits the parts that no matcher reads: a million shapes take 27 GB.
#pragma once

#include <memory>
#include <string>

#include "bench/inputs/varied_shapes.h"
#include "core/matching/model_source.h"

namespace tessera::bench {

/// The models of the first `count` varied shapes, with the levels of the context, from a file in the folder. Writes
/// that file where it is missing, or holds other shapes. Throws EnvironmentError where it cannot be written.
std::shared_ptr<const ModelSource> models_in_file(const std::string& folder, const VariedShapes& shapes,
                                                  std::uint32_t count, const MatchingContext& context);

/// The models from models_in_file(). Where `folder` is empty, they are made whenever a matcher asks for them. `shapes`
/// must outlive them.
std::shared_ptr<const ModelSource> varied_models(const VariedShapes& shapes, std::uint32_t count,
                                                 const MatchingContext& context, const std::string& folder);

}  // namespace tessera::bench
