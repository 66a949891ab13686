// Libraries as an attacker makes them: a valid file, changed at one place, with valid checksums. All choices follow from a seed.
#pragma once

#include <cstdint>
#include <string>

#include "support/hostile_file.h"

namespace tessera::test {

/// Changes the library at `path`; the seed selects one of 16 ways, and the place.
Forgery forge_library(const std::string& path, std::uint32_t seed);

}  // namespace tessera::test
