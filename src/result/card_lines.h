// Lines of card.txt: two columns, less than 80 characters.
#pragma once

#include <string>

#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera {

/// One line. `value` may hold names from files, which are escaped.
inline std::string card_line(const std::string& label, const std::string& value) {
  constexpr std::size_t kLabelWidth = 24;
  return "  " + label + std::string(kLabelWidth - label.size(), ' ') + printable_utf8(value) + "\n";
}

inline std::string percent_text(double fraction, int decimals = 2) { return fixed(100 * fraction, decimals) + " %"; }

}  // namespace tessera
