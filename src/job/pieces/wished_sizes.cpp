#include "job/pieces/wished_sizes.h"

#include <algorithm>

#include "job/job_tables.h"

namespace tessera {
namespace {

bool has_own_sizes(const std::vector<JobRow>& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const JobRow& row) { return row.contains("scale_px"); });
}

}  // namespace

std::optional<SizeRange> wished_sizes(const Job& job) {
  const PieceSettings& pieces = job.settings.pieces;
  if (pieces.fit_all || job.drawn_sizes || !job.wishes.empty()) return {};
  if (has_own_sizes(rows_of(job, "shapes")) || has_own_sizes(rows_of(job, "regions"))) return {};
  return SizeRange{pieces.min_scale_px, pieces.max_scale_px};
}

}  // namespace tessera
