// Tables as texts with commas (RFC 4180) or semicolons, as spreadsheets and scripts write them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tessera {

struct CsvRow {
  std::size_t line = 1;  // where it begins, from 1
  std::vector<std::string> cells;
};

/// What separates the cells of the first row: a comma, or a semicolon or tabulator where there is no comma, as spreadsheets
/// write tables where the decimal point is a comma.
char csv_separator(const std::string& text);

/// The rows of the text but for empty lines, their cells separated by csv_separator(). Either kind of line end is taken;
/// quotes may hold separators, line ends and doubled quotes. Throws InputError "LINE: ..." where quotes are not closed
/// or something stands beside them.
std::vector<CsvRow> read_csv(const std::string& text);

/// A cell for a text that comes from elsewhere: escaped (printable_utf8), in quotes where it holds a separator, and no
/// formula for a spreadsheet. What would begin one (= + - @, also behind a semicolon, which separates cells where the
/// decimal point is a comma) gets an apostrophe before it. Numbers of our own need none of this.
std::string csv_text_cell(const std::string& text);

}  // namespace tessera
