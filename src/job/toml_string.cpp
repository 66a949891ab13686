#include "job/toml_string.h"

#include <toml++/toml.h>

#include <sstream>

namespace tessera {

std::string toml_string(const std::string& text) {
  std::ostringstream out;
  out << toml::toml_formatter(toml::value<std::string>(text), toml::format_flags::none);
  return out.str();
}

}  // namespace tessera
