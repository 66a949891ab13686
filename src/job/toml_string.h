// A text as a string of TOML, for who writes a job file.
#pragma once

#include <string>

namespace tessera {

/// The text, UTF-8, as a TOML string with its quotes.
std::string toml_string(const std::string& text);

}  // namespace tessera
