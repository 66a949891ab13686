// Libraries with a chunk that does not match its declared packing, but has a valid checksum.
#pragma once

#include "support/forging_chance.h"
#include "support/hostile_file.h"

namespace tessera::test {

Forgery chunk_that_inflates_to_less(const std::string& path, ForgingChance& chance);
Forgery chunk_that_inflates_to_more(const std::string& path, ForgingChance& chance);
Forgery chunk_with_skipped_filters(const std::string& path, ForgingChance& chance);
Forgery chunk_of_random_bytes(const std::string& path, ForgingChance& chance);

}  // namespace tessera::test
