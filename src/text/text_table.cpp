#include "text/text_table.h"

#include <algorithm>

#include "text/utf8_text.h"

namespace tessera {

void TextTable::add(std::vector<std::string> row) {
  for (std::string& cell : row) cell = printable_utf8(cell);
  rows_.push_back(std::move(row));
}

std::string TextTable::text() const {
  std::vector<std::size_t> width(rows_.front().size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
  }
  std::string text;
  for (const auto& row : rows_) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string blanks(width[c] - row[c].size(), ' ');
      const bool left = c == 0 || cells_ == Cells::words;
      text += (c == 0 ? "" : "  ") + (left ? row[c] + blanks : blanks + row[c]);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text;
}

}  // namespace tessera
