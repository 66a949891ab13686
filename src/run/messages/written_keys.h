// The keys of a job as its file has them, for messages that say which of them to change.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "job/job_file.h"

namespace tessera {

/// Gives the values of keys as texts only. Sizes and limits to compute with are those of CollageProblem.
class WrittenKeys {
 public:
  /// The job outlives it.
  explicit WrittenKeys(const Job& job) : job_(job) {}

  /// "pieces.scale_px (now [20, 160])"; in mm where the canvas has a size on paper.
  std::string with_value(const char* section, const char* name) const;
  bool is_default(const char* section, const char* name) const;
  /// The rows of this table ([[shapes]]) that have a value in this column.
  std::vector<std::uint32_t> rows_with(const char* table, const char* column) const;
  /// `scale_px of [[regions]] "sky" (now [20, 160])`: the values of the first of these rows.
  std::string rows_with_values(const char* table, const char* column, const std::vector<std::uint32_t>& rows) const;
  bool has_rows(const char* table) const;
  /// A length as a text: "41.2 px"; in mm where the canvas has a size on paper.
  std::string length_text(double length_px) const;

 private:
  const Job& job_;
};

}  // namespace tessera
