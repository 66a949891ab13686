// Libraries whose data sets have other declarations: filters, lengths, types, layouts, links, attributes.
#pragma once

#include "support/forging_chance.h"
#include "support/hostile_file.h"

namespace tessera::test {

/// Stores the same numbers with other filters.
Forgery other_filters(const std::string& path, ForgingChance& chance);
Forgery giant(const std::string& path, ForgingChance& chance);
Forgery other_type(const std::string& path, ForgingChance& chance);
/// Stores the bytes contiguously, in the header, in another file, or as a view of another file.
Forgery other_layout(const std::string& path, ForgingChance& chance);
Forgery other_link(const std::string& path, ForgingChance& chance);
Forgery forged_attribute(const std::string& path, ForgingChance& chance);

}  // namespace tessera::test
