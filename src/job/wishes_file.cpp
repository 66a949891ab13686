#include "job/wishes_file.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/split_text.h"
#include "files/regular_file.h"
#include "job/job_entry.h"
#include "text/csv_text.h"
#include "text/nearest_name.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr std::size_t kMostWishesBytes = std::size_t(1) << 20;
constexpr std::size_t kMostShownBytes = 300;  // of a path
constexpr std::size_t kMostCellBytes = 4096;  // few enough for whatever TOML they are

bool is_text(JobKind kind) { return kind == JobKind::texts || kind == JobKind::name || kind == JobKind::word; }

/// A text stands in its cell as it is, a list of them as in TOML: ["owl*", "eagle"].
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
    const std::vector<CsvRow> rows = read();
    if (rows.empty()) throw InputError(shown_ + ": empty; needed: a first row with the names of the columns");
    check_header(rows.front());
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (says_nothing(rows[i])) continue;
      check_width(rows[i], rows.front());
      add_row(
          table_, row_of(rows[i], rows.front()), [&](const toml::node&) { return place(rows[i]); }, job);
      job.wishes_places.push_back(place(rows[i]));
    }
  }

 private:
  std::string place(const CsvRow& row) const { return shown_ + ":" + std::to_string(row.line); }

  std::vector<CsvRow> read() const {
    const std::string text = read_text();
    check_is_utf8(text);
    try {
      return read_csv(text);
    } catch (const InputError& error) {
      throw InputError(shown_ + ":" + error.what());
    }
  }

  std::string read_text() const {
    try {
      const std::vector<std::uint8_t> bytes = read_regular_file(path_, kMostWishesBytes);
      return {bytes.begin(), bytes.end()};
    } catch (const InputError& error) {
      const std::string what = error.what();
      throw InputError(shown_ + (what.starts_with(path_) ? what.substr(path_.size()) : ": " + what) +
                       "; allowed: a CSV file, its columns those of [[shapes]]");
    }
  }

  /// Spreadsheets save in other encodings, too.
  void check_is_utf8(const std::string& text) const {
    constexpr const char* kSaveAsUtf8 = "; allowed: UTF-8; save the table as CSV in UTF-8";
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") || text.find('\0') != text.npos) {
      throw InputError(shown_ + ": found UTF-16, or no text" + kSaveAsUtf8);
    }
    std::istringstream lines(text);
    std::string line;
    for (std::size_t number = 1; std::getline(lines, line); ++number) {
      if (is_utf8(line)) continue;
      throw InputError(shown_ + ":" + std::to_string(number) + ": found \"" + printable(printable_utf8(line)) +
                       "\", which is not UTF-8 but another encoding, such as Latin-1" + kSaveAsUtf8);
    }
  }

  std::vector<std::string> known_columns() const {
    std::vector<std::string> names;
    for (const JobKey& column : table_.columns) names.push_back(column.name);
    return names;
  }

  /// By its name, or by that in mm.
  const JobKey* column_of(const std::string& name) const {
    const JobKey* column = find_column(table_, name);
    return column ? column : length_in_mm(table_, name);
  }

  void check_header(const CsvRow& header) const {
    for (const std::string& cell : header.cells) {
      if (cell.find_first_of(";\t") == std::string::npos) continue;
      throw InputError(place(header) + ": found \"" + printable(printable_utf8(cell)) +
                       "\", allowed: columns with commas between them; write the table as CSV with commas, not with "
                       "semicolons or tabulators, and its numbers with points");
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

  /// Spreadsheets write such rows behind the last one.
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

  /// An empty cell says nothing.
  toml::table row_of(const CsvRow& row, const CsvRow& header) const {
    toml::table values;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const std::string cell = checked_cell(row, i, header);
      if (cell.empty()) continue;
      const std::string& name = header.cells[i];
      check_points(row, name, cell);
      value_of(*column_of(name), cell).get("value")->visit([&](auto& value) { values.insert(name, std::move(value)); });
    }
    return values;
  }

  /// "0,5" is how spreadsheets write a half in some languages.
  void check_points(const CsvRow& row, const std::string& column, const std::string& cell) const {
    const std::size_t comma = cell.find(',');
    if (is_text(column_of(column)->kind) || comma == cell.npos) return;
    std::string with_point = cell;
    with_point[comma] = '.';
    if (with_point.find_first_not_of("+-.0123456789") != cell.npos) return;
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
