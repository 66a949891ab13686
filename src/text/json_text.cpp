#include "text/json_text.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "text/utf8_text.h"

namespace tessera {
namespace {

std::string escaped_byte(unsigned char byte) {
  char text[8];
  std::snprintf(text, sizeof text, "\\udc%02x", byte);
  return text;
}

/// Valid UTF-8, escaped, without the quotes.
std::string escaped(const std::string& text) {
  const std::string quoted = nlohmann::json(text).dump(-1, ' ', true);
  return quoted.substr(1, quoted.size() - 2);
}

}  // namespace

std::string json_path_text(const std::string& path) {
  std::string text = "\"";
  for (std::size_t at = 0; at < path.size();) {
    const std::size_t length = utf8_length(path, at);
    text += length == 0 ? escaped_byte(static_cast<unsigned char>(path[at])) : escaped(path.substr(at, length));
    at += length == 0 ? 1 : length;
  }
  return text + "\"";
}

}  // namespace tessera
