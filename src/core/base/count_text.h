// Numbers with a noun or a unit, in texts for people: "1 piece", "2 pieces", "8.6 GB".
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace tessera {

/// The number and the noun: count_text(1, "piece") == "1 piece", count_text(2, "piece") == "2 pieces". `several` is for
/// plurals other than `one` with an s: count_text(0, "entity", "entities") == "0 entities".
std::string count_text(std::size_t count, std::string_view one, std::string_view several = {});

/// The noun alone, or another word that depends on the number: by_count(1, "is", "are") == "is".
std::string by_count(std::size_t count, std::string_view one, std::string_view several);

/// A size as text: "8.6 GB".
std::string gigabytes(std::uint64_t bytes);

/// A size as text: "640 x 480".
std::string size_text(int width, int height);

}  // namespace tessera
