// Tables as text with commas (RFC 4180) or semicolons, as spreadsheets and scripts write them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tessera {

struct CsvRow {
  std::size_t line = 1;  // line of the file where the row begins, from 1
  std::vector<std::string> cells;
};

/// The separator of cells, found in the first row: a comma; without any comma a semicolon or a tabulator. Spreadsheets
/// write these where the decimal point is a comma.
char csv_separator(const std::string& text);

/// The rows of the text without empty lines; csv_separator() separates their cells. Both kinds of line end are
/// accepted. Quotes may hold separators, line ends and doubled quotes. Throws InputError "LINE: ..." where quotes are
/// not closed, or where something stands beside them in the cell.
std::vector<CsvRow> read_csv(const std::string& text);

/// A cell for a foreign text: escaped (printable_utf8), in quotes where it holds a separator, and never a formula of a
/// spreadsheet. A text that would begin a formula (= + - @, also behind a semicolon, which separates cells where the
/// decimal point is a comma) gets an apostrophe before it. Our own numbers do not need this function.
std::string csv_text_cell(const std::string& text);

}  // namespace tessera
