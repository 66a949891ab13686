// Lists in texts: of the command line, of job files, of style sheets.
#pragma once

#include <string_view>
#include <vector>

namespace tessera {

/// Without the white space round it.
std::string_view trimmed(std::string_view text);

/// Where one of the characters of `wanted` stands outside of quotes and brackets, from `from` on; else the text's size.
std::size_t find_outside(std::string_view text, std::string_view wanted, std::size_t from = 0);

/// What stands between the separators that are outside of quotes and brackets, trimmed. An empty text has one empty part.
/// The parts point into `text`.
std::vector<std::string_view> split_outside(std::string_view text, char separator);

}  // namespace tessera
