// The keys of a job as its file has them, for messages that say which of them to change.
#pragma once

#include <string>

#include "job/job_file.h"

namespace tessera {

/// It says what a key's value is, and gives none to compute with: sizes and limits that count are CollageProblem's.
class WrittenKeys {
 public:
  /// The job outlives it.
  explicit WrittenKeys(const Job& job) : job_(job) {}

  /// "pieces.scale_px (now [20, 160])": in mm where the canvas has a size on paper.
  std::string with_value(const char* section, const char* name) const;
  bool is_default(const char* section, const char* name) const;
  /// Whether a row of that table ([[shapes]]) has a value in that column.
  bool has_column(const char* table, const std::string& column) const;
  bool has_rows(const char* table) const;
  /// "41.2 px"; in mm where the canvas has a size on paper.
  std::string length_text(double length_px) const;

 private:
  const Job& job_;
};

}  // namespace tessera
