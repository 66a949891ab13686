// The shortlist equals the reference's: the best few pairs of each shape, then the best of all, in a total order.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "core/matching/matcher.h"
#include "worker/docked_shortlist.h"

namespace tessera::worker {
namespace test_docked_shortlist {

/// Dockings of few shapes with hardly any different keys. So there are ties everywhere, above all at the end of the list.
std::vector<Docking> tied_dockings(std::mt19937& random, std::size_t count) {
  std::vector<Docking> dockings(count);
  for (Docking& docking : dockings) {
    docking.shape = ShapeId(random() % 6);
    docking.source = std::uint32_t(random() % 1000) + (random() % 2 == 0 ? kTangentSource : 0);
    docking.key = 0.25f * float(1 + random() % 4);
  }
  return dockings;
}

std::vector<Docking> plainly_shortened(const std::vector<Docking>& dockings) {
  std::map<ShapeId, std::vector<Docking>> paired;
  std::vector<Docking> all;
  for (const Docking& docking : dockings) {
    (docking.source < kTangentSource ? paired[docking.shape] : all).push_back(docking);
  }
  for (auto& [shape, of_shape] : paired) {
    std::sort(of_shape.begin(), of_shape.end(), docks_better);
    of_shape.resize(std::min<std::size_t>(of_shape.size(), kDockingsPerShape));
    all.insert(all.end(), of_shape.begin(), of_shape.end());
  }
  keep_shortlist(all);
  return all;
}

RC_GTEST_PROP(DockedShortlist, is_the_references, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  std::vector<Docking> dockings = tied_dockings(random, *rc::gen::inRange<std::size_t>(0, 90));
  const std::vector<Docking> expected = plainly_shortened(dockings);
  keep_docked_shortlist(dockings);
  RC_ASSERT(dockings == expected);
}

}  // namespace test_docked_shortlist
}  // namespace tessera::worker
