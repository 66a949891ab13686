// Libraries whose data sets are declared in another way: filters, lengths, types, layouts, links, attributes.
#pragma once

#include "support/forging_chance.h"
#include "support/hostile_file.h"

namespace tessera::test {

/// The same numbers, packed in another way.
Forgery other_filters(const std::string& path, ForgingChance& chance);
Forgery giant(const std::string& path, ForgingChance& chance);
Forgery other_type(const std::string& path, ForgingChance& chance);
/// Bytes in one piece, in the header, in another file, or borrowed from one.
Forgery other_layout(const std::string& path, ForgingChance& chance);
Forgery other_link(const std::string& path, ForgingChance& chance);
Forgery forged_attribute(const std::string& path, ForgingChance& chance);

}  // namespace tessera::test
