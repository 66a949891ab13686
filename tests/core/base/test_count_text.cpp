#include "core/base/count_text.h"

#include <gtest/gtest.h>

namespace tessera {
namespace test_count_text {

TEST(CountText, OneIsSingularAndAllOthersArePlural) {
  EXPECT_EQ(count_text(0, "piece"), "0 pieces");
  EXPECT_EQ(count_text(1, "piece"), "1 piece");
  EXPECT_EQ(count_text(2, "piece"), "2 pieces");
  EXPECT_EQ(count_text(1, "entity", "entities"), "1 entity");
  EXPECT_EQ(count_text(11, "entity", "entities"), "11 entities");
  EXPECT_EQ(by_count(1, "is", "are"), "is");
  EXPECT_EQ(by_count(0, "is", "are"), "are");
}

}  // namespace test_count_text
}  // namespace tessera
