// Numbers with a noun in texts for people: "1 piece", "2 pieces".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tessera {

/// The number and the noun: count_text(1, "piece") == "1 piece", count_text(2, "piece") == "2 pieces". `several` is for
/// plurals that are not `one` with an s: count_text(0, "entity", "entities") == "0 entities".
std::string count_text(std::size_t count, std::string_view one, std::string_view several = {});

/// The noun alone, or what else goes by the number: by_count(1, "is", "are") == "is".
std::string by_count(std::size_t count, std::string_view one, std::string_view several);

}  // namespace tessera
