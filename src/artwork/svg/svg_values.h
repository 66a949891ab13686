// Reads and writes attribute values as cairo writes them into SVGs.
#pragma once

#include <cairo.h>

#include <map>
#include <string>
#include <string_view>

namespace tessera {

/// Reads numbers and letters that are separated by spaces and commas.
class NumberReader {
 public:
  explicit NumberReader(std::string_view text) : rest_(text) {}

  /// The next letter; 0 at the end.
  char next_letter();
  /// The next number. Throws InputError where there is no finite number.
  double next_number();
  bool at_end();

 private:
  void skip_spaces();

  std::string_view rest_;
};

/// The number in `text`. Throws InputError where it is no finite number.
double svg_number(const std::string& text);

/// The matrix of "matrix(...)"; the identity for "". Throws InputError for everything else.
cairo_matrix_t svg_matrix(const std::string& text);
std::string svg_text(const cairo_matrix_t& matrix);

/// "#rrggbb" from "rgb(R%,G%,B%)". Throws InputError for everything else.
std::string hex_colour(const std::string& rgb);

/// The id in "url(#ID)"; "" for everything else.
std::string local_id(const std::string& value);

/// The declarations of a style attribute.
std::map<std::string, std::string> svg_style(const std::string& text);

}  // namespace tessera
