// Splits and joins lists in texts: command line, job files, style sheets, messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tessera {

/// The text without the white space around it.
std::string_view trimmed(std::string_view text);

/// The first place, from `from` on, of a character of `wanted` outside quotes and brackets; the text's size if there is
/// none.
std::size_t find_outside(std::string_view text, std::string_view wanted, std::size_t from = 0);

/// The trimmed parts between the separators outside quotes and brackets. An empty text has one empty part. The parts
/// point into `text`.
std::vector<std::string_view> split_outside(std::string_view text, char separator);

std::string joined(const std::vector<std::string>& parts, std::string_view separator = ", ");

}  // namespace tessera
