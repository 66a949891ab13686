#include "core/matcher_suite.h"
#include "core/ranks/partition.h"

namespace tessera::test {
namespace test_matchers {

std::unique_ptr<Matcher> make_reference(const MatchingContext& context, std::uint32_t first,
                                        std::vector<ShapeModel> models) {
  return std::make_unique<ReferenceMatcher>(context, first, std::move(models));
}

MatcherKind composite_of(int parts) {
  const auto make = [parts](const MatchingContext& context, std::uint32_t first, std::vector<ShapeModel> models) {
    const std::vector<std::uint64_t> weights(models.size(), 1);
    std::vector<std::unique_ptr<Matcher>> made;
    for (const ShapeRange& range : balanced_ranges(weights, parts)) {
      made.push_back(
          make_reference(context, first + range.begin, {models.begin() + range.begin, models.begin() + range.end}));
    }
    return std::unique_ptr<Matcher>(std::make_unique<CompositeMatcher>(std::move(made)));
  };
  return {"CompositeOf" + std::to_string(parts), make};
}

INSTANTIATE_TEST_SUITE_P(Core, MatcherSuite,
                         testing::Values(MatcherKind{"Reference", make_reference}, composite_of(2), composite_of(3)),
                         [](const auto& info) { return info.param.name; });

TEST(CompositeMatcher, RefusesPartsThatDoNotFollowOneAnother) {
  const MatchingContext context = make_matching_context(scene_settings(), 10);
  std::vector<std::unique_ptr<Matcher>> parts;
  parts.push_back(make_reference(context, 0, {}));
  parts.push_back(make_reference(context, 1, {}));
  EXPECT_THROW(CompositeMatcher(std::move(parts)), std::logic_error);
}

}  // namespace test_matchers
}  // namespace tessera::test
