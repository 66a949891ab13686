// Tables in plain text, for people to read.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tessera {

/// A table whose columns are as wide as their widest cell. The first column is aligned to the left. The others are aligned to
/// the right if they hold numbers, to the left if they hold words. Cells may hold names from files: they are escaped
/// (printable_utf8).
class TextTable {
 public:
  enum class Cells { numbers, words };

  explicit TextTable(std::vector<std::string> header, Cells cells = Cells::numbers)
      : rows_{std::move(header)},
        cells_(cells) {}
  /// `row` has as many cells as the header.
  void add(std::vector<std::string> row);
  std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
  Cells cells_;
};

}  // namespace tessera
