// Marks jobs that a command wrote, so that a later run can tell whether the user has changed one.
#pragma once

#include <string>

namespace tessera {

/// The text with a last line that names its author, a command.
std::string with_written_mark(const std::string& text, const std::string& author);

/// Whether a text has this author's mark, changed since or not.
bool has_written_mark(const std::string& text, const std::string& author);

/// Whether a text is as with_written_mark() made it.
bool is_as_written(const std::string& text, const std::string& author);

}  // namespace tessera
