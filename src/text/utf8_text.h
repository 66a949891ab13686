// Foreign texts made safe to show: names of files, titles, values of jobs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tessera {

/// `text` with '_' for every byte that is not valid UTF-8, and for every character that is invisible or changes the
/// text round it (Unicode's control and format characters, line separators, fillers). ASCII control characters in
/// `kept` stay: "\n" keeps the line ends of a text of several lines.
std::string printable_utf8(const std::string& text, std::string_view kept = {});

/// The number of bytes of the character that begins at `at`; 0 where no character begins there.
std::size_t utf8_length(const std::string& text, std::size_t at);

/// Whether the whole text is valid UTF-8, with any characters.
bool is_utf8(const std::string& text);

/// The beginning of a UTF-8 text: at most `most_bytes`, and never ending inside a character.
std::string cut_utf8(const std::string& text, std::size_t most_bytes);

}  // namespace tessera
