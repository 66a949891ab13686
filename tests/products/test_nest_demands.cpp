// The demand for pieces by name and by pattern.
#include <gtest/gtest.h>

#include "products/nesting/nest_input.h"
#include "support/input_error.h"

namespace tessera {
namespace test_nest_demands {

NestInput input_of(const std::vector<std::string>& names) {
  NestInput input;
  for (const std::string& name : names) input.sources.emplace_back().drawing.name = name;
  return input;
}

std::vector<int> demands(NestInput input, const std::vector<std::pair<std::string, int>>& wished) {
  set_demands(input, wished);
  std::vector<int> found;
  for (const NestSource& source : input.sources) found.push_back(source.demand);
  return found;
}

TEST(SetDemands, takes_patterns_and_the_last_that_fits) {
  EXPECT_EQ(demands(input_of({"wheel", "wheel-2", "lid"}), {{"wheel*", 4}, {"wheel", 3}}), (std::vector{3, 4, 1}));
  EXPECT_EQ(demands(input_of({"wheel", "lid"}), {{"wheel", 0}}), (std::vector{1}));
  EXPECT_NE(test::message_of([] { demands(input_of({"wheel"}), {{"w", 2}}); }), "");
}

TEST(SetDemands, a_name_with_brackets_is_itself) {
  EXPECT_EQ(demands(input_of({"logo [final]", "logo f"}), {{"logo [final]", 5}}), (std::vector{5, 1}));
}

}  // namespace test_nest_demands
}  // namespace tessera
