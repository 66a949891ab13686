// Texts of strangers made fit to be shown: names of files, titles, values of jobs.
#pragma once

#include <cstddef>
#include <string>

namespace tessera::io {

/// `text` with every control character and every byte that is not part of valid UTF-8 replaced by '_'.
std::string printable_utf8(const std::string& text);

/// Whether all of it is valid UTF-8, whatever the characters are.
bool is_utf8(const std::string& text);

/// The beginning of a UTF-8 text, `most_bytes` long at most and not ending inside a character.
std::string cut_utf8(const std::string& text, std::size_t most_bytes);

}  // namespace tessera::io
