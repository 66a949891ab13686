// Numbers as texts in messages.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace tessera::matching {

/// The number with six significant digits, the same in every locale; "nan" and "inf" are possible.
inline std::string number_in_message(double number) {
  if (std::isnan(number)) return "nan";  // it may have a sign, which says nothing
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 6).ptr;
  return std::string(text.data(), end);
}

}  // namespace tessera::matching
