// Values of attributes as cairo writes them into SVGs.
#pragma once

#include <cairo.h>

#include <map>
#include <string>
#include <string_view>

namespace tessera {

/// Numbers and letters with spaces and commas between them.
class NumberReader {
 public:
  explicit NumberReader(std::string_view text) : rest_(text) {}

  /// 0 at the end.
  char next_letter();
  /// Throws InputError where there is none that is finite.
  double next_number();
  bool at_end();

 private:
  void skip_spaces();

  std::string_view rest_;
};

/// Throws InputError where the text is no finite number.
double svg_number(const std::string& text);

/// Of "matrix(...)"; of "" the identity. Throws InputError for everything else.
cairo_matrix_t svg_matrix(const std::string& text);
std::string svg_text(const cairo_matrix_t& matrix);

/// "#rrggbb" of "rgb(R%,G%,B%)". Throws InputError for everything else.
std::string hex_colour(const std::string& rgb);

/// The id of "url(#ID)"; "" for everything else.
std::string local_id(const std::string& value);

/// The declarations of a style attribute.
std::map<std::string, std::string> svg_style(const std::string& text);

}  // namespace tessera
