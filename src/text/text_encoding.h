// Text files of people, who have other editors and spreadsheets than we: all become UTF-8, or are refused by name.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tessera {

/// The text in UTF-8, without a byte order mark. UTF-16 is told by its mark. Throws InputError, which begins with `shown`
/// and the line, where the text is in another encoding, and says how to save it.
std::string utf8_text(std::span<const std::uint8_t> bytes, const std::string& shown);

}  // namespace tessera
