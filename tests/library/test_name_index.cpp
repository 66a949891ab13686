// A pattern finds all names that match it, and looks at few others.
#include "library/name_index.h"

#include <fnmatch.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace tessera {
namespace test_name_index {

using Places = std::vector<std::uint32_t>;

TEST(NameIndex, FindsNamesAndPatterns) {
  const NameIndex index({"owl", "cat", "owl_2", "Owl", "cat"});
  EXPECT_EQ(index.matching("owl"), (Places{0}));
  EXPECT_EQ(index.matching("cat"), (Places{1, 4})) << "each of one name, as mirror images have";
  EXPECT_EQ(index.matching("owl*"), (Places{0, 2}));
  EXPECT_EQ(index.matching("[oO]wl"), (Places{0, 3}));
  EXPECT_EQ(index.matching("*"), (Places{0, 1, 2, 3, 4}));
  EXPECT_EQ(index.matching("ow"), Places{});
  EXPECT_EQ(index.matching(""), Places{});
  EXPECT_EQ(index.find("cat"), 1u);
  EXPECT_EQ(index.find("owl*"), std::nullopt) << "no name";
  EXPECT_EQ(NameIndex({}).matching("*"), Places{});
}

TEST(NameIndex, ANameThatLooksLikeAPatternSelectsItselfAlone) {
  const NameIndex index(
      {"logo [final]", "logo f", "a*", "ab", "what?", "whats", "back\\slash", "backslash", "[", "logo [final]"});
  EXPECT_EQ(index.matching("logo [final]"), (Places{0, 9}));
  EXPECT_EQ(index.matching("logo [finale]"), (Places{1})) << "a pattern, as no name is the same";
  EXPECT_EQ(index.matching("logo \\[final]"), (Places{0, 9})) << "as before";
  EXPECT_EQ(index.matching("a*"), (Places{2}));
  EXPECT_EQ(index.matching("a**"), (Places{2, 3}));
  EXPECT_EQ(index.matching("what?"), (Places{4}));
  EXPECT_EQ(index.matching("back\\slash"), (Places{6}));
  EXPECT_EQ(index.matching("["), (Places{8}));
}

TEST(NameIndex, ANameIsFoundAsItIsShown) {
  const NameIndex index({"I\u0085b", "a\tb", "a\u202eb", "plain", "a_b", "a\xe4"});
  EXPECT_EQ(index.matching("I__b"), Places{0});
  EXPECT_EQ(index.matching("a___b"), Places{2});
  EXPECT_EQ(index.matching("a_b"), Places{4}) << "the name itself comes first";
  EXPECT_EQ(index.matching("a_"), Places{5});
  EXPECT_EQ(index.find("I__b"), 0u);
  EXPECT_EQ(index.find("a_b"), 4u);
}

TEST(NameIndex, ANameThatWasLeftOutIsNoPattern) {
  const NameIndex index({"logo f", "logo i", "a*"}, {"logo [final]", "logo [if]", "a*", "logo"});
  EXPECT_EQ(index.matching("logo [final]"), Places{}) << "that shape was meant, and it is not there";
  EXPECT_EQ(index.matching("logo [if]"), Places{});
  EXPECT_EQ(index.matching("logo [fi]"), (Places{0, 1})) << "no name";
  EXPECT_EQ(index.matching("logo*"), (Places{0, 1}));
  EXPECT_EQ(index.matching("a*"), Places{2}) << "another one of the name is there";
}

TEST(NameIndex, ANameIsComparedWithItselfAndAPatternWithWhatBeginsLikeIt) {
  std::vector<std::string> names;
  for (int i = 0; i < 10'000; ++i) names.push_back("shape_" + std::to_string(i));
  const NameIndex index(names);
  EXPECT_EQ(index.candidates("shape_77").size(), 1u);
  EXPECT_EQ(index.candidates("shape_77*").size(), 111u);
  EXPECT_EQ(index.candidates("shape_7[7]").size(), 1111u);
  EXPECT_EQ(index.candidates("owl").size(), 0u);
  EXPECT_EQ(index.candidates("*").size(), names.size());
}

RC_GTEST_PROP(NameIndex, finds_the_name_itself_or_what_fnmatch_finds, ()) {
  const auto text = [](const char* letters) {
    return rc::gen::container<std::string>(rc::gen::elementOf(std::string(letters)));
  };
  const auto names = *rc::gen::container<std::vector<std::string>>(text("ab*[]\\"));
  const std::string glob = *text("ab*?[]\\");
  const bool is_name = std::find(names.begin(), names.end(), glob) != names.end();
  Places expected;
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    if (is_name ? names[i] == glob : ::fnmatch(glob.c_str(), names[i].c_str(), 0) == 0) expected.push_back(i);
  }
  RC_ASSERT(NameIndex(names).matching(glob) == expected);
}

}  // namespace test_name_index
}  // namespace tessera
