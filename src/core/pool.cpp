#include "core/pool.h"

#include <algorithm>

#include "core/tuning.h"

namespace tessera {

bool ranks_before(const Candidate& a, const Candidate& b) {
  if (a.score != b.score) return a.score > b.score;
  if (a.shape != b.shape) return a.shape < b.shape;
  return a.source < b.source;
}

void Pool::put(std::uint32_t edge, std::vector<Candidate> candidates, bool truncated) {
  std::sort(candidates.begin(), candidates.end(), ranks_before);
  if (candidates.size() > kPoolPerSample) {
    candidates.resize(kPoolPerSample);
    truncated = true;
  }
  entries_[edge] = {std::move(candidates), truncated};
}

}  // namespace tessera
