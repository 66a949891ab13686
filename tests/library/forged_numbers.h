// Libraries with another number or byte in a chunk, packed and summed as if it belonged there.
#pragma once

#include "support/forging_chance.h"
#include "support/hostile_file.h"

namespace tessera::test {

/// A number that is none, or out of all proportion.
Forgery absurd_number(const std::string& path, ForgingChance& chance);
Forgery flipped_content(const std::string& path, ForgingChance& chance);
Forgery astray_offset(const std::string& path, ForgingChance& chance);
/// Claims to be huge, or is not RGBA, or brings more along.
Forgery forged_thumbnail(const std::string& path, ForgingChance& chance);

}  // namespace tessera::test
