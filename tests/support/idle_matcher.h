// A matcher that finds nothing. Tests use it to see which questions reach a matcher.
#pragma once

#include <algorithm>

#include "core/matching/matcher.h"

namespace tessera::test {

/// The number of samples in a count request.
inline std::size_t samples_asked(const CountRequest& request) {
  return std::size_t(std::count_if(request.bins.begin(), request.bins.end(), [](std::uint32_t b) { return b > 0; }));
}

class IdleMatcher : public Matcher {
 public:
  void start_field(int, int, Vec2) override {}
  void update_field(const std::vector<FieldPatch>&) override {}
  void limit(const StanceLimits&) override {}
  void post_dock(const DockRequest&) override {}
  DockReply take_dock() override { return {}; }
  void post_refine(const std::vector<Docking>&) override {}
  std::vector<RefinedDocking> take_refine() override { return {}; }
  void post_measure(const std::vector<Docking>&) override {}
  std::vector<DockingTerms> take_measure() override { return {}; }
};

}  // namespace tessera::test
