// A library, or its first shapes, on the devices.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "core/matching/matching_context.h"
#include "core/settings/settings.h"
#include "library/storage/library_file.h"

namespace tessera {
class Matcher;
}

namespace tessera::bench {

/// A matcher for the first `shapes` shapes and a job with these settings.
std::unique_ptr<Matcher> library_matcher(const LibraryFile& library, std::size_t shapes,
                                         const CollageSettings& settings, const std::string& devices_use);

}  // namespace tessera::bench
