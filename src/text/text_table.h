// Tables in plain text, for people to read.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tessera {

/// A table whose columns are as wide as their widest cell. The first column is aligned to the left, the others to the
/// right. Cells may hold names from files: they are escaped (printable_utf8).
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
