#include "text/csv_text.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

class CsvReader {
 public:
  CsvReader(const std::string& text, char separator)
      : text_(text),
        separator_(separator),
        ends_of_cell_{separator, '\r', '\n'} {}

  std::vector<CsvRow> rows() {
    std::vector<CsvRow> rows;
    while (at_ < text_.size()) {
      CsvRow row = next_row();
      if (row.cells.size() > 1 || !row.cells.front().empty()) rows.push_back(std::move(row));
    }
    return rows;
  }

 private:
  CsvRow next_row() {
    CsvRow row{line_, {cell()}};
    while (at_ < text_.size() && text_[at_] == separator_) {
      ++at_;
      row.cells.push_back(cell());
    }
    skip_line_end();
    return row;
  }

  std::string cell() {
    if (at_ < text_.size() && text_[at_] == '"') return quoted_cell();
    const std::size_t begin = at_;
    at_ = std::min(text_.size(), text_.find_first_of(ends_of_cell_, at_));
    return text_.substr(begin, at_ - begin);
  }

  std::string quoted_cell() {
    const std::size_t first_line = line_;
    std::string cell;
    for (++at_;; ++at_) {
      if (at_ == text_.size()) throw InputError(std::to_string(first_line) + ": a quote \" is not closed");
      if (text_[at_] == '"' && text_[++at_] != '"') break;  // behind the text's end there is a NUL
      if (text_[at_] == '\n') ++line_;
      cell += text_[at_];
    }
    if (at_ < text_.size() && ends_of_cell_.find(text_[at_]) == std::string::npos) {
      throw InputError(std::to_string(line_) +
                       ": text behind a closing quote \"; a quote within quotes is written \"\"");
    }
    return cell;
  }

  void skip_line_end() {
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n') ++at_;
    ++line_;
  }

  const std::string& text_;
  const char separator_;
  const std::string ends_of_cell_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/// Whether this text would begin a formula, also with the wide signs of East Asian keyboards.
bool begins_formula(std::string_view text) {
  for (const std::string_view sign : {"=", "+", "-", "@", "＝", "＋", "－", "＠"}) {
    if (text.starts_with(sign)) return true;
  }
  return false;
}

std::string without_formulas(const std::string& text) {
  std::string harmless;
  bool begins_cell = true;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (begins_cell && begins_formula(std::string_view(text).substr(at))) harmless += '\'';
    begins_cell = text[at] == ';' || (begins_cell && (text[at] == ' ' || text[at] == '"'));
    harmless += text[at];
  }
  return harmless;
}

std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string csv_text_cell(const std::string& text) {
  const std::string cell = without_formulas(printable_utf8(text));
  return cell.find_first_of(",;\"") == std::string::npos ? cell : quoted(cell);
}

char csv_separator(const std::string& text) {
  bool quoted = false;
  char other = ',';
  for (const char c : text) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == ',' || c == '\n' || c == '\r') return c == ',' ? ',' : other;
    if (other == ',' && (c == ';' || c == '\t')) other = c;
  }
  return other;
}

std::vector<CsvRow> read_csv(const std::string& text) { return CsvReader(text, csv_separator(text)).rows(); }

}  // namespace tessera
