// Text files of people with various editors and spreadsheets: converted to UTF-8, or refused with the name of their
// encoding.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tessera {

/// The text in UTF-8, without a byte order mark. UTF-16 is recognised by its byte order mark. For any other encoding it
/// throws InputError, which begins with `shown` and the line and says how to save the file.
std::string utf8_text(std::span<const std::uint8_t> bytes, const std::string& shown);

}  // namespace tessera
