// Words for a shell: commands to be typed next, and lists that scripts read.
#pragma once

#include <string>

namespace tessera {

/// The text as a word of a command that bash reads back unchanged, in quotes where needed. Bytes that must not be
/// printed (printable_utf8) are escaped: $'a\033'.
std::string shell_word(const std::string& text);

/// The text for a table that people read: unchanged where all of it can be printed and it does not look like an escaped
/// word; otherwise shell_word(text).
std::string shell_cell(const std::string& text);

}  // namespace tessera
