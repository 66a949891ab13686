// Campaigns: seeds and values become named jobs.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "job/pieces/variations.h"
#include "support/input_error.h"

namespace tessera {
namespace test_variations {

using test::message_of;
using Texts = std::vector<std::string>;

Texts names(const std::vector<Variation>& variations) {
  Texts all;
  for (const Variation& variation : variations) all.push_back(variation.name);
  return all;
}

TEST(Variations, every_seed_with_every_value) {
  const auto variations = make_variations("1-2", {"objective.gap_weight=0.5,2"});
  EXPECT_EQ(names(variations),
            (Texts{"seed_1-gap_weight_0.5", "seed_1-gap_weight_2", "seed_2-gap_weight_0.5", "seed_2-gap_weight_2"}));
  EXPECT_EQ(variations[2].overrides, (Texts{"seed=2", "objective.gap_weight=0.5"}));
}

TEST(Variations, a_single_value_is_the_same_in_all) {
  const auto variations = make_variations("4,7-8", {"library.file=\"a,b.h5\""});
  EXPECT_EQ(names(variations), (Texts{"seed_4", "seed_7", "seed_8"}));
  EXPECT_EQ(variations[0].overrides, (Texts{"seed=4", "library.file=\"a,b.h5\""}));
}

TEST(Variations, a_single_seed_is_in_the_names) {
  const auto one = make_variations("4", {"a.b=1"});
  EXPECT_EQ(names(one), Texts{"seed_4"});
  EXPECT_EQ(one[0].overrides, (Texts{"seed=4", "a.b=1"}));
  EXPECT_EQ(names(make_variations("4", {"a.b=1,2"})), (Texts{"seed_4-b_1", "seed_4-b_2"}));
}

TEST(Variations, commas_in_brackets_belong_to_a_value) {
  const auto variations = make_variations("", {"pieces.scale_px=[20, 160],[14,90]"});
  EXPECT_EQ(variations[0].overrides, Texts{"pieces.scale_px=[20, 160]"});
  EXPECT_EQ(variations[1].overrides, Texts{"pieces.scale_px=[14,90]"});
  EXPECT_EQ(names(variations), (Texts{"scale_px__20__160_", "scale_px__14_90_"}));
}

TEST(Variations, names_stay_different) {
  EXPECT_EQ(names(make_variations("", {"canvas.file=a b,a_b"})), (Texts{"file_a_b", "file_a_b-2"}));
}

TEST(Variations, mistakes_name_the_argument) {
  EXPECT_EQ(message_of([] { make_variations("8-1", {}); }),
            "--seeds 8-1: found \"8-1\", allowed: seeds and ranges of at most 10000 like 7 or 1-8,12");
  for (const char* seeds : {"x", "1-", "-1", "1,,2", "1.5", "1-99999999999999999999", "0-10000"}) {
    EXPECT_NE(message_of([&] { make_variations(seeds, {}); }), "") << seeds;
  }
  EXPECT_NE(message_of([] { make_variations("1-2", {"no value"}); }).find("--set no value: allowed"),
            std::string::npos);
  EXPECT_NE(message_of([] { make_variations("1-2", {"a.b=1,,2"}); }).find("empty value"), std::string::npos);
  EXPECT_NE(message_of([] { make_variations("1-2", {"seed=3,4"}); }).find("seed is given twice"), std::string::npos);
  EXPECT_NE(message_of([] { make_variations("1,2,1", {}); }).find("1 twice"), std::string::npos);
  EXPECT_NE(message_of([] { make_variations("", {"a.b=1"}); }).find("nothing varies"), std::string::npos);
  EXPECT_NE(
      message_of([] {
        make_variations(
            "1-200",
            {"a.b=" +
             std::string("1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,"
                         "18,19,20,21,22,23,24,25,26,27,28,29,30,31,32,33,34,35,36,37,38,39,40,41,42,43,44,45,46,47,"
                         "48,49,50,51")});
      }).find("more than 10000"),
      std::string::npos);
}

RC_GTEST_PROP(Variations, names_are_unique_and_fit_for_folders, ()) {
  const auto value = rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab./ -'~\\"))));
  const auto values = *rc::gen::unique<std::vector<std::string>>(5, value);
  std::string text = "canvas.file=";
  for (const std::string& v : values) text += "\"" + v + "\",";
  text.pop_back();
  std::set<std::string> taken;
  for (const Variation& variation : make_variations("", {text})) {
    RC_ASSERT(taken.insert(variation.name).second);
    RC_ASSERT(variation.name.find_first_of("/ '\"~\\") == std::string::npos);
  }
  RC_ASSERT(taken.size() == values.size());
}

}  // namespace test_variations
}  // namespace tessera
