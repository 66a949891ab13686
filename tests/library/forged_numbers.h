// Libraries with a changed number or byte in a chunk, packed and with a valid checksum.
#pragma once

#include "support/forging_chance.h"
#include "support/hostile_file.h"

namespace tessera::test {

/// Writes not-a-number, or a number far too large or too small.
Forgery absurd_number(const std::string& path, ForgingChance& chance);
Forgery flipped_content(const std::string& path, ForgingChance& chance);
Forgery astray_offset(const std::string& path, ForgingChance& chance);
/// Writes a thumbnail that claims a huge size, is not RGBA, or holds more data.
Forgery forged_thumbnail(const std::string& path, ForgingChance& chance);

}  // namespace tessera::test
