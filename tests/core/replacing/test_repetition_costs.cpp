// The costs of repeated drawings in a job.
#include "core/replacing/repetition_costs.h"

#include <gtest/gtest.h>

namespace tessera {
namespace test_repetition_costs {

CollageSettings pieces_of_40_to_80_px() {
  CollageSettings s;
  s.pieces.min_scale_px = 40;
  s.pieces.max_scale_px = 80;
  return s;
}

TEST(RepetitionCosts, AnEvenShareIsThatOfAllDrawingsOrAPieceOfTheMiddleSize) {
  const CollageSettings s = pieces_of_40_to_80_px();
  EXPECT_DOUBLE_EQ(repetition_costs(s, 6, 800. * 700).even_share_px2, 800. * 700 / 6);
  EXPECT_DOUBLE_EQ(repetition_costs(s, 1000, 800. * 700).even_share_px2, 40. * 80);
  EXPECT_DOUBLE_EQ(repetition_costs(s, 0, 800. * 700).even_share_px2, 40. * 80);
}

/// The reach covers as many pieces as there are drawings, so that each drawing has one copy in it.
TEST(RepetitionCosts, CopiesReachFartherTheMoreDrawingsThereAre) {
  const auto reach_sizes = [](std::size_t drawings) {
    return repetition_costs(pieces_of_40_to_80_px(), drawings, 1).reach_sizes;
  };
  EXPECT_EQ(reach_sizes(1), 0.5f) << "not even neighbours";
  EXPECT_EQ(reach_sizes(36), 3);
  EXPECT_EQ(reach_sizes(100), 5);
  EXPECT_EQ(reach_sizes(5000), 5);
}

}  // namespace test_repetition_costs
}  // namespace tessera
