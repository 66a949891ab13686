// Libraries as an attacker makes them: a good one, changed at one place, with valid checksums. Seeded.
#pragma once

#include <cstdint>
#include <string>

#include "support/hostile_file.h"

namespace tessera::test {

/// Changes the library at `path`; the seed says in which of 16 ways, and where.
Forgery forge_library(const std::string& path, std::uint32_t seed);

}  // namespace tessera::test
