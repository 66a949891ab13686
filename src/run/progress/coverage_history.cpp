#include "run/progress/coverage_history.h"

#include <algorithm>

namespace tessera {
namespace {

constexpr std::size_t kMostMoments = 4096;  // a long run keeps at least 2,048, a tenth of them from its last tenth
constexpr std::size_t kFewestMoments = 10;  // a whole run needs so many: fewer are steps and no curve

}  // namespace

void CoverageHistory::add(double seconds, std::optional<double> coverage) {
  latest_ = {seconds, coverage};
  if (added_++ % every_ != 0) return;
  moments_.push_back(latest_);
  if (moments_.size() < kMostMoments) return;
  for (std::size_t i = 0; 2 * i < moments_.size(); ++i) moments_[i] = moments_[2 * i];
  moments_.resize(moments_.size() / 2);
  every_ *= 2;
}

std::optional<double> CoverageHistory::gained_in_last_tenth(double total_s) const {
  if (added_ < kFewestMoments) return {};
  const double then_s = 0.9 * total_s;
  const auto after =
      std::find_if(moments_.begin(), moments_.end(), [&](const Moment& m) { return m.seconds > then_s; });
  if (after == moments_.begin()) return {};
  const std::optional<double> then = (after - 1)->coverage;
  if (!then || !latest_.coverage) return {};
  return *latest_.coverage - *then;
}

std::vector<GrowthMoment> CoverageHistory::growth(std::size_t most) const {
  std::vector<GrowthMoment> known;
  for (const Moment& moment : moments_) {
    if (moment.coverage && moment.seconds < latest_.seconds) known.push_back({moment.seconds, *moment.coverage});
  }
  if (latest_.coverage) known.push_back({latest_.seconds, *latest_.coverage});
  if (known.size() <= most) return known;
  std::vector<GrowthMoment> picked;
  for (std::size_t k = 1; k <= most; ++k) picked.push_back(known[k * known.size() / most - 1]);
  return picked;
}

}  // namespace tessera
