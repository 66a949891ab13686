// Numbers that a message tells of.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace tessera::matching {

/// Six digits that count; also "nan" and "inf", in every locale.
inline std::string number_in_message(double number) {
  if (std::isnan(number)) return "nan";  // it may have a sign, which says nothing
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 6).ptr;
  return std::string(text.data(), end);
}

}  // namespace tessera::matching
