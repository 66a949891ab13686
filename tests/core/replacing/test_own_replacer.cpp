// Replacement trials on several threads: a window's result depends on the window alone, and the caller may stop the work.
#include "core/replacing/own_replacer.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "core/replacing/replaced_windows.h"
#include "support/replacement_windows.h"
#include "support/room_for_stacks.h"

namespace tessera {
namespace test_own_replacer {

using test::any_windows;
using test::endless_windows;
using test::EndlessShapes;

const auto do_not_look = [] {};

std::vector<ReplacementOutcome> asked(Replacer& replacer, const std::vector<ReplacementWindow>& windows) {
  replacer.post_replace(windows);
  return replacer.take_replaced();
}

TEST(OwnReplacer, AnyNumberOfThreadsGivesTheSame) {
  EndlessShapes shapes;
  const std::vector<ReplacementWindow> windows = any_windows(7, 1);
  OwnReplacer alone(shapes, 1, do_not_look);
  const std::vector<ReplacementOutcome> expected = asked(alone, windows);
  ASSERT_EQ(expected.size(), windows.size());
  const auto kept = [](std::uint32_t sum, const ReplacementOutcome& outcome) { return sum + outcome.kept; };
  EXPECT_GT(std::accumulate(expected.begin(), expected.end(), 0u, kept), 5u)
      << "trials that change nothing show little";
  for (const int threads : {3, 20}) {
    OwnReplacer several(shapes, threads, do_not_look);
    EXPECT_EQ(several.breadth(), threads);
    EXPECT_EQ(asked(several, windows), expected);
    EXPECT_EQ(asked(several, windows), expected) << "the second time it has the shapes";
  }
}

/// There are fewer windows than threads: from the beginning, or after other windows are done.
TEST(OwnReplacer, WhoHelpsChangesNothing) {
  EndlessShapes shapes;
  OwnReplacer alone(shapes, 1, do_not_look);
  OwnReplacer several(shapes, 5, do_not_look);
  for (const std::size_t count : {1, 2, 3}) {
    std::vector<ReplacementWindow> windows = any_windows(count, 6);
    windows.front().trials *= 4;
    EXPECT_EQ(asked(several, windows), asked(alone, windows)) << count;
  }
}

TEST(OwnReplacer, WithoutAnyThreadItDoesTheSame) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer maps a shadow of all addresses";
#endif
  EndlessShapes shapes;
  const std::vector<ReplacementWindow> windows = any_windows(2, 5);
  OwnReplacer alone(shapes, 1, do_not_look);
  const std::vector<ReplacementOutcome> expected = asked(alone, windows);
  const test::RoomForStacks none(0);
  OwnReplacer several(shapes, 2, do_not_look);
  EXPECT_EQ(asked(several, windows), expected);
}

TEST(OwnReplacer, WindowsStandForThemselves) {
  EndlessShapes shapes;
  OwnReplacer replacer(shapes, 2, do_not_look);
  const std::vector<ReplacementWindow> windows = any_windows(3, 2);
  const std::vector<ReplacementOutcome> together = asked(replacer, windows);
  for (std::size_t i = 0; i < windows.size(); ++i) EXPECT_EQ(asked(replacer, {windows[i]}).at(0), together[i]);
}

TEST(OwnReplacer, AQuestionOfNothing) {
  EndlessShapes shapes;
  OwnReplacer replacer(shapes, 2, do_not_look);
  EXPECT_TRUE(asked(replacer, {}).empty());
}

TEST(OwnReplacer, HasAThreadAtLeast) {
  EndlessShapes shapes;
  EXPECT_EQ(OwnReplacer(shapes, 0, do_not_look).breadth(), 1);
}

TEST(OwnReplacer, WhatALookThrowsComesOutAndTheThreadsEnd) {
  EndlessShapes shapes;
  struct Enough {};
  for (const std::size_t count : {1, 5}) {  // fewer windows than threads, and more
    int looks = 0;
    OwnReplacer replacer(shapes, 3, [&] {
      if (++looks == 20) throw Enough{};  // four shapes were read before, so the threads are at work
    });
    EXPECT_THROW(asked(replacer, endless_windows(count)), Enough);
    EXPECT_EQ(asked(replacer, any_windows(1, 4)).size(), 1u) << "the next question is one of its own";
  }
}

TEST(ReplacedWindows, WhatAWindowThrowsComesOutAndTheOthersEnd) {
  EndlessShapes shapes;
  std::map<ShapeId, HoleShape> made;
  HoleShapes known;
  for (std::uint32_t k = 0; k < 4; ++k) {
    made[ShapeId{k}] = make_hole_shape(shapes.shape(ShapeId{k}));
    known[ShapeId{k}] = &made[ShapeId{k}];
  }
  std::vector<ReplacementWindow> windows = endless_windows(4);
  windows[2].moving[0].shape = ShapeId{4};
  TaskPool pool(3);
  EXPECT_THROW(replaced_windows(windows, known, pool, do_not_look), std::out_of_range);
}

TEST(OwnReplacer, ForgetsShapesAndReadsThemAgain) {
  EndlessShapes shapes;
  OwnReplacer replacer(shapes, 2, do_not_look);
  std::vector<ReplacementWindow> few = any_windows(2, 5);
  const std::vector<ReplacementOutcome> expected = asked(replacer, few);
  EXPECT_EQ(shapes.read(), 4u);
  asked(replacer, few);
  EXPECT_EQ(shapes.read(), 4u) << "they are kept";

  ReplacementWindow wide = few.front();
  wide.trials = 1;
  for (std::uint32_t k = 4; k < 3000; ++k)
    wide.still.push_back({ShapeId{k}, ShapeId{k}, wide.still[0].canvas_from_shape, {}});
  asked(replacer, {wide});
  EXPECT_EQ(shapes.read(), 3000u);
  asked(replacer, {few});
  EXPECT_EQ(shapes.read(), 3000u) << "the last question's are kept";
  EXPECT_EQ(asked(replacer, {wide}).size(), 1u);
  EXPECT_EQ(shapes.read(), 3000u + 1000u) << "of those before 2,000 in all are, where they are many";
  EXPECT_EQ(asked(replacer, few), expected);
}

}  // namespace test_own_replacer
}  // namespace tessera
