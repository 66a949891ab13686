#include "text/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace tessera {

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) value = 0;
  std::array<char, 400> buffer;  // the largest double has 309 digits before the point
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  const std::string text(buffer.data(), end.ptr);
  return text.starts_with('-') && text.find_first_of("123456789") == std::string::npos ? text.substr(1) : text;
}

std::string significant(double value, int digits) {
  if (!std::isfinite(value) || value == 0) return "0";
  std::array<char, 64> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
  return {buffer.data(), end.ptr};
}

double rounded(double value, int decimals) {
  const double unit = std::pow(10., decimals);
  return std::round(value * unit) / unit;
}

}  // namespace tessera
