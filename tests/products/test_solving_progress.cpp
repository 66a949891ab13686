// The displayed progress of a puzzle never goes back.
#include "products/puzzle/solving_progress.h"

#include <gtest/gtest.h>

#include <string>

namespace tessera {
namespace test_solving_progress {

TEST(SolvingProgress, OnlyGrowsThoughPiecesAreLaidSeveralTimes) {
  tessera::SolvingProgress progress;
  const auto see = [&](bool laying, std::size_t done) {
    const tessera::SolvingProgress::Shown shown = progress.see({laying, done, 36});
    return shown.label + " " + std::to_string(shown.done) + " of " + std::to_string(shown.of) + " " + shown.note;
  };
  EXPECT_EQ(see(false, 0), "matching 0 of 36 ");
  EXPECT_EQ(see(false, 30), "matching 30 of 36 ");
  EXPECT_EQ(see(false, 7), "matching 30 of 36 ") << "of other outlines";
  EXPECT_EQ(see(true, 2), "laying 2 of 36 2 pieces");
  EXPECT_EQ(see(true, 35), "laying 35 of 36 35 pieces");
  EXPECT_EQ(see(true, 5), "laying 35 of 36 arrangement 2: 5 pieces");
  EXPECT_EQ(see(false, 36), "laying 35 of 36 arrangement 2: matching again");
  EXPECT_EQ(see(true, 1), "laying 35 of 36 arrangement 3: 1 piece");
  EXPECT_EQ(see(true, 36), "laying 36 of 36 arrangement 3: 36 pieces");
}

}  // namespace test_solving_progress
}  // namespace tessera
