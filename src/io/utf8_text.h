// Texts of strangers made fit to be shown: names of files, titles, values of jobs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tessera::io {

/// `text` with '_' instead of every byte that is no valid UTF-8, of every control character and of every character that
/// reorders the text round it (Unicode's bidirectional controls). The ASCII control characters in `kept` stay: "\n"
/// keeps the line ends of a text of several lines.
std::string printable_utf8(const std::string& text, std::string_view kept = {});

/// Whether all of it is valid UTF-8, whatever the characters are.
bool is_utf8(const std::string& text);

/// The beginning of a UTF-8 text, `most_bytes` long at most and not ending inside a character.
std::string cut_utf8(const std::string& text, std::size_t most_bytes);

}  // namespace tessera::io
