#include "artwork/svg/svg_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/error.h"
#include "core/base/split_text.h"
#include "text/number_text.h"

namespace tessera {
namespace {

/// Digits of a matrix: more than single precision holds, so that it can be inverted.
constexpr int kMatrixDigits = 9;

[[noreturn]] void throw_unknown(const std::string& what, std::string_view found, const std::string& allowed) {
  throw InputError(what + ": found \"" + std::string(found.substr(0, 40)) + "\", allowed: " + allowed);
}

/// The text between "NAME(" and ")".
std::string_view arguments_of(std::string_view text, std::string_view name) {
  const std::string start = std::string(name) + "(";
  if (!text.starts_with(start) || !text.ends_with(')')) throw_unknown("a value", text, start + "...)");
  return text.substr(start.size(), text.size() - start.size() - 1);
}

}  // namespace

void NumberReader::skip_spaces() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" ,\t\r\n"), rest_.size())); }

char NumberReader::next_letter() {
  skip_spaces();
  if (rest_.empty()) return 0;
  const char letter = rest_.front();
  rest_.remove_prefix(1);
  return letter;
}

double NumberReader::next_number() {
  skip_spaces();
  double value = 0;
  const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
  if (error != std::errc() || !std::isfinite(value)) throw_unknown("a number", rest_, "finite ones");
  rest_.remove_prefix(std::size_t(end - rest_.data()));
  return value;
}

bool NumberReader::at_end() {
  skip_spaces();
  return rest_.empty();
}

double svg_number(const std::string& text) {
  NumberReader reader(text);
  const double value = reader.next_number();
  if (!reader.at_end()) throw_unknown("a number", text, "finite ones");
  return value;
}

cairo_matrix_t svg_matrix(const std::string& text) {
  cairo_matrix_t matrix;
  cairo_matrix_init_identity(&matrix);
  if (text.empty()) return matrix;
  NumberReader reader(arguments_of(text, "matrix"));
  for (double* entry : {&matrix.xx, &matrix.yx, &matrix.xy, &matrix.yy, &matrix.x0, &matrix.y0}) {
    *entry = reader.next_number();
  }
  if (!reader.at_end()) throw_unknown("a matrix", text, "six numbers");
  return matrix;
}

std::string svg_text(const cairo_matrix_t& m) {
  std::string text = "matrix(";
  for (const double entry : {m.xx, m.yx, m.xy, m.yy, m.x0, m.y0}) text += significant(entry, kMatrixDigits) + " ";
  text.back() = ')';
  return text;
}

std::string hex_colour(const std::string& rgb) {
  static constexpr char kDigits[] = "0123456789abcdef";
  NumberReader reader(arguments_of(rgb, "rgb"));
  std::string colour = "#";
  for (int k = 0; k < 3; ++k) {
    const double percent = reader.next_number();
    if (reader.next_letter() != '%') throw_unknown("a colour", rgb, "percents of red, green and blue");
    const int value = int(std::lround(std::clamp(percent, 0., 100.) * 2.55));
    colour += {kDigits[value / 16], kDigits[value % 16]};
  }
  return colour;
}

std::string local_id(const std::string& value) {
  const bool is_local = value.starts_with("url(#") && value.ends_with(')');
  return is_local ? value.substr(5, value.size() - 6) : "";
}

std::map<std::string, std::string> svg_style(const std::string& text) {
  std::map<std::string, std::string> style;
  for (const std::string_view declaration : split_outside(text, ';')) {
    const std::size_t colon = declaration.find(':');
    if (colon == std::string_view::npos) continue;
    style[std::string(trimmed(declaration.substr(0, colon)))] = trimmed(declaration.substr(colon + 1));
  }
  return style;
}

}  // namespace tessera
