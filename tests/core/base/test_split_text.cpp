#include "core/base/split_text.h"

#include <gtest/gtest.h>

namespace tessera {
namespace test_split_text {

using Parts = std::vector<std::string_view>;

TEST(SplitOutside, TrimsAndKeepsEmptyParts) {
  EXPECT_EQ(split_outside("0, 2 ,", ','), (Parts{"0", "2", ""}));
  EXPECT_EQ(split_outside("", ','), (Parts{""}));
}

TEST(SplitOutside, LeavesQuotesAndBracketsWhole) {
  EXPECT_EQ(split_outside("[20, 160], \"a,b\", 'c,[d', (e,{f,g})", ','),
            (Parts{"[20, 160]", "\"a,b\"", "'c,[d'", "(e,{f,g})"}));
}

TEST(SplitOutside, ToleratesWhatIsNeverClosedOrNeverOpened) {
  EXPECT_EQ(split_outside("a], b", ','), (Parts{"a]", "b"}));
  EXPECT_EQ(split_outside("[a, b", ','), (Parts{"[a, b"}));
}

TEST(FindOutside, StartsWhereItIsTold) { EXPECT_EQ(find_outside("a:b:c", ":", 2), 3u); }

TEST(Joined, PutsSeparatorsBetween) {
  EXPECT_EQ(joined({}), "");
  EXPECT_EQ(joined({"", "a", ""}), ", a, ") << "empty parts are parts";
  EXPECT_EQ(joined({"a", "b c"}, " "), "a b c");
}

}  // namespace test_split_text
}  // namespace tessera
