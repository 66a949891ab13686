#include "bench/inputs/library_matcher.h"

#include "core/matching/matcher.h"
#include "library/storage/shape_models.h"
#include "worker/device_group.h"

namespace tessera::bench {

std::unique_ptr<Matcher> library_matcher(const LibraryFile& library, std::size_t shapes,
                                         const CollageSettings& settings, const std::string& devices_use) {
  const MatchingContext context = make_matching_context(settings, std::uint32_t(shapes));
  return worker::make_device_matcher(devices_use, context, {0, std::uint32_t(shapes)}, models_of(library, context));
}

}  // namespace tessera::bench
