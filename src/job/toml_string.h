// A text as a TOML string, for writing job files.
#pragma once

#include <string>

namespace tessera {

/// The UTF-8 text as a TOML string with its quotes.
std::string toml_string(const std::string& text);

}  // namespace tessera
