// Words for a shell: commands to be typed next, and lists that scripts read.
#pragma once

#include <string>

namespace tessera::cli {

/// As bash reads it, in quotes where it must be. Of what is not to be printed (printable_utf8) the bytes are escaped:
/// $'a\033'.
std::string shell_word(const std::string& text);

/// As it is, where all of it can be printed and it does not begin as what is escaped; else as shell_word.
std::string shell_cell(const std::string& text);

}  // namespace tessera::cli
