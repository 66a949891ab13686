#include "job/wishes_file.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/split_text.h"
#include "files/regular_file.h"
#include "job/job_entry.h"
#include "text/csv_text.h"
#include "text/nearest_name.h"
#include "text/text_encoding.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr std::size_t kMostWishesBytes = std::size_t(1) << 20;
constexpr std::size_t kMostShownBytes = 300;  // of a path
constexpr std::size_t kMostCellBytes = 4096;  // few enough for any TOML value

bool is_text(JobKind kind) { return kind == JobKind::texts || kind == JobKind::name || kind == JobKind::word; }

/// The value of a cell. A text stands as it is, a list of texts as in TOML: ["owl*", "eagle"].
toml::table value_of(const JobKey& column, const std::string& cell) {
  toml::table table = parse_value(cell);
  if (is_text(column.kind) && !table.get("value")->is_array()) return toml::table{{"value", cell}};
  return table;
}

class WishesFile {
 public:
  explicit WishesFile(const std::string& path)
      : path_(path),
        shown_(printable(printable_utf8(path), kMostShownBytes)),
        table_(*find_job_table("shapes")) {}

  void add_to(Job& job) const {
    const std::string text = read_text();
    const bool decimal_commas = csv_separator(text) != ',';
    const std::vector<CsvRow> rows = rows_of(text);
    if (rows.empty()) throw InputError(shown_ + ": empty; needed: a first row with the names of the columns");
    check_header(rows.front());
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (says_nothing(rows[i])) continue;
      check_width(rows[i], rows.front());
      add_row(
          table_, row_of(rows[i], rows.front(), decimal_commas), [&](const toml::node&) { return place(rows[i]); },
          job);
      job.wishes_places.push_back(place(rows[i]));
    }
  }

 private:
  std::string place(const CsvRow& row) const { return shown_ + ":" + std::to_string(row.line); }

  std::vector<CsvRow> rows_of(const std::string& text) const {
    try {
      return read_csv(text);
    } catch (const InputError& error) {
      throw InputError(shown_ + ":" + error.what());
    }
  }

  std::string read_text() const { return utf8_text(read_bytes(), shown_); }

  std::vector<std::uint8_t> read_bytes() const {
    try {
      return read_regular_file(path_, kMostWishesBytes);
    } catch (const InputError& error) {
      const std::string what = error.what();
      throw InputError(shown_ + (what.starts_with(path_) ? what.substr(path_.size()) : ": " + what) +
                       "; allowed: a CSV file, its columns those of [[shapes]]");
    }
  }

  std::vector<std::string> known_columns() const {
    std::vector<std::string> names;
    for (const JobKey& column : table_.columns) names.push_back(column.name);
    return names;
  }

  /// The column with this name, in px or in mm.
  const JobKey* column_of(const std::string& name) const {
    const JobKey* column = find_column(table_, name);
    return column ? column : length_in_mm(table_, name);
  }

  void check_header(const CsvRow& header) const {
    for (const std::string& cell : header.cells) {
      if (cell.find_first_of(";\t") == std::string::npos) continue;
      throw InputError(
          place(header) + ": found \"" + printable(printable_utf8(cell)) +
          "\" beside commas, allowed: columns with commas between them, or all with semicolons, or all with "
          "tabulators");
    }
    for (std::size_t i = 0; i < header.cells.size(); ++i) check_column(header, i);
    if (std::find(header.cells.begin(), header.cells.end(), "names") == header.cells.end()) {
      throw InputError(place(header) + ": the column names is missing; needed: " + table_.columns.front().meaning);
    }
  }

  void check_column(const CsvRow& header, std::size_t i) const {
    const std::string& name = header.cells[i];
    if (!column_of(name)) {
      const std::string nearest = nearest_name(name, known_columns());
      throw InputError(place(header) + ": unknown column \"" + printable(printable_utf8(name)) + "\"" +
                       (nearest.empty() ? "" : " (did you mean " + nearest + "?)") +
                       "; allowed: " + joined(known_columns()));
    }
    if (std::find(header.cells.begin(), header.cells.begin() + std::ptrdiff_t(i), name) !=
        header.cells.begin() + std::ptrdiff_t(i)) {
      throw InputError(place(header) + ": the column " + name + " stands there twice; allowed: once");
    }
  }

  /// Whether all cells are empty: spreadsheets write such rows behind the last one.
  static bool says_nothing(const CsvRow& row) {
    return std::all_of(row.cells.begin(), row.cells.end(),
                       [](const std::string& cell) { return trimmed(cell).empty(); });
  }

  void check_width(const CsvRow& row, const CsvRow& header) const {
    if (row.cells.size() == header.cells.size()) return;
    const bool more = row.cells.size() > header.cells.size();
    throw InputError(place(row) + ": found " + count_text(row.cells.size(), "cell") +
                     ", allowed: " + std::to_string(header.cells.size()) + ", as many as the first row has" +
                     (more ? "; a list needs quotes, \"[20, 80]\", and a number has a point, 0.5, not a comma" : ""));
  }

  /// The row's values; an empty cell gives none.
  toml::table row_of(const CsvRow& row, const CsvRow& header, bool decimal_commas) const {
    toml::table values;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      std::string cell = checked_cell(row, i, header);
      if (cell.empty()) continue;
      const std::string& name = header.cells[i];
      if (const std::string with_point = with_decimal_point(name, cell); !with_point.empty()) {
        if (!decimal_commas) refuse_decimal_comma(row, name, cell, with_point);
        cell = with_point;
      }
      value_of(*column_of(name), cell).get("value")->visit([&](auto& value) { values.insert(name, std::move(value)); });
    }
    return values;
  }

  /// "0.5" from "0,5", as spreadsheets write a half in some languages; empty where the cell is no such number.
  std::string with_decimal_point(const std::string& column, const std::string& cell) const {
    const std::size_t comma = cell.find(',');
    if (is_text(column_of(column)->kind) || comma == cell.npos) return "";
    std::string with_point = cell;
    with_point[comma] = '.';
    return with_point.find_first_not_of("+-.0123456789") == cell.npos ? with_point : "";
  }

  /// Refuses a decimal comma in a table with commas between cells: there it could also separate the numbers of a list.
  [[noreturn]] void refuse_decimal_comma(const CsvRow& row, const std::string& column, const std::string& cell,
                                         const std::string& with_point) const {
    throw InputError(place(row) + ": [[shapes]] " + column + ": found \"" + printable(cell) +
                     "\", allowed: a number with a point, " + printable(with_point) + ", or a list in brackets, [" +
                     printable(cell) + "]");
  }

  std::string checked_cell(const CsvRow& row, std::size_t i, const CsvRow& header) const {
    std::string cell(trimmed(row.cells[i]));
    std::replace_if(
        cell.begin(), cell.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
    if (cell.size() > kMostCellBytes || printable_utf8(cell) != cell) {
      throw InputError(place(row) + ": " + header.cells[i] + ": found \"" + printable(printable_utf8(cell)) +
                       "\", allowed: UTF-8 without control characters, " + std::to_string(kMostCellBytes) +
                       " bytes or less");
    }
    return cell;
  }

  const std::string path_;
  const std::string shown_;  // in messages
  const JobTable& table_;
};

}  // namespace

void add_wishes_of_file(Job& job) {
  std::vector<JobRow> own = std::exchange(job.tables["shapes"], {});
  try {
    WishesFile(job.wishes).add_to(job);
  } catch (const InputError& error) {
    throw InputError(job.path + ": library.wishes: " + error.what());
  }
  std::vector<JobRow>& rows = job.tables["shapes"];
  rows.insert(rows.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  job.wishes.clear();
}

}  // namespace tessera
