// Texts as job files have them.
#pragma once

#include <string>

namespace tessera {

/// The text, UTF-8, as a TOML string with its quotes.
std::string toml_text(const std::string& text);

}  // namespace tessera
