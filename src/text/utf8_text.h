// Texts of strangers made fit to be shown: names of files, titles, values of jobs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tessera {

/// `text` with '_' instead of every byte that is no valid UTF-8, and of every character that is not seen or does something
/// to the text round it (Unicode's control and format characters, separators of lines, fillers). The ASCII control characters in `kept` stay: "\n"
/// keeps the line ends of a text of several lines.
std::string printable_utf8(const std::string& text, std::string_view kept = {});

/// How many bytes the character has that begins there; 0 where none does.
std::size_t utf8_length(const std::string& text, std::size_t at);

/// Whether all of it is valid UTF-8, whatever the characters are.
bool is_utf8(const std::string& text);

/// The beginning of a UTF-8 text, `most_bytes` long at most and not ending inside a character.
std::string cut_utf8(const std::string& text, std::size_t most_bytes);

}  // namespace tessera
