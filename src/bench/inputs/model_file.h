// The models of a very large library in a file of their own, as a library file holds them (library/storage/segment_layout.h)
// and without the rest of it, which no matcher reads: a million shapes are 27 GB.
#pragma once

#include <memory>
#include <string>

#include "bench/inputs/varied_shapes.h"
#include "core/matching/model_source.h"

namespace tessera::bench {

/// Of the first `count` varied shapes, with the levels of the context, in a file of the folder. It is made where it is
/// not there, or is of other shapes. Throws EnvironmentError where it cannot be written.
std::shared_ptr<const ModelSource> models_in_file(const std::string& folder, const VariedShapes& shapes,
                                                  std::uint32_t count, const MatchingContext& context);

/// The same, or where `folder` is empty, models that are made whenever a matcher asks for them. `shapes` outlive them.
std::shared_ptr<const ModelSource> varied_models(const VariedShapes& shapes, std::uint32_t count,
                                                 const MatchingContext& context, const std::string& folder);

}  // namespace tessera::bench
