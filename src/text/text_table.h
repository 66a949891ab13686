// Tables for people, in plain text.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tessera {

/// Columns are as wide as their widest cell; the first is aligned to the left, the others to the right. Cells may hold
/// names from files: they are escaped (printable_utf8).
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> header) : rows_{std::move(header)} {}
  /// `row` has as many cells as the header.
  void add(std::vector<std::string> row);
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace tessera
