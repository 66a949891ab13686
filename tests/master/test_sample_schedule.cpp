// The target samples to be matched, and their random dockings.
#include "master/sample_schedule.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tessera::master {
namespace test_sample_schedule {

/// A schedule for the boundary of an empty canvas.
class SampleScheduleTest : public testing::Test {
 protected:
  SampleScheduleTest() { schedule_.follow(curve_.retrace(opened_, free_.field().origin, {all_})); }

  std::vector<std::uint32_t> passes_taken() {
    std::vector<std::uint32_t> passes;
    for (const TargetSample& sample : schedule_.take()) passes.push_back(sample.pass);
    return passes;
  }

  const PieceSettings pieces_;
  FreeField free_{make_rectangle_canvas(200, 140), pieces_};
  OpenedField opened_{free_, pieces_};
  TargetCurve curve_{pieces_, PadParameters{}};
  const Window all_ = free_.field().value.bounds();
  std::optional<OutwardGrowth> growth_;
  SampleSchedule schedule_{free_, curve_, growth_};
};

TEST_F(SampleScheduleTest, EachSampleIsMatchedOnce) {
  EXPECT_EQ(schedule_.take().size(), curve_.sample_count());
  EXPECT_TRUE(schedule_.take().empty());
}

TEST_F(SampleScheduleTest, ASampleHasOtherRandomDockingsEachTime) {
  schedule_.set_first_pass(40);
  for (const std::uint32_t pass : {40u, 41u, 42u}) {
    EXPECT_EQ(passes_taken(), std::vector<std::uint32_t>(curve_.sample_count(), pass));
    schedule_.mark(all_);
  }
}

/// The samples are as if never taken; the state for a checkpoint is the same, too.
TEST_F(SampleScheduleTest, SamplesThatArePutBackHaveTheSameRandomDockings) {
  const auto state = [&] {
    CheckpointState state;
    schedule_.save(state);
    return state;
  };
  for (const std::uint32_t pass : {0u, 1u}) {
    const CheckpointState before = state();
    schedule_.put_back(schedule_.take());
    EXPECT_EQ(state().stale, before.stale);
    EXPECT_EQ(state().matches, before.matches);
    EXPECT_EQ(passes_taken().at(0), pass);
    schedule_.mark(all_);
  }
}

TEST_F(SampleScheduleTest, AWindowMarksItsSamples) {
  schedule_.take();
  schedule_.mark(Window{all_.x0, all_.y0, all_.x0 + 60, all_.y1});
  const std::vector<TargetSample> marked = schedule_.take();
  EXPECT_FALSE(marked.empty());
  EXPECT_LT(marked.size(), curve_.sample_count());
  for (const TargetSample& sample : marked) EXPECT_LT(sample.position.x - free_.field().origin.x, 60);
}

TEST_F(SampleScheduleTest, RemovedSamplesAreForgottenAndRenewedOnesMatchedAgain) {
  const std::vector<SampleId> ids = curve_.samples();
  schedule_.follow({{ids[0], ids[1]}, {}});
  EXPECT_EQ(schedule_.take().size(), ids.size() - 2);
  schedule_.follow({{}, {ids[1]}});
  const std::vector<TargetSample> renewed = schedule_.take();
  ASSERT_EQ(renewed.size(), 1u);
  EXPECT_EQ(renewed[0].id, ids[1]);
}

TEST_F(SampleScheduleTest, AfterAClearNothingIsKnown) {
  schedule_.take();
  schedule_.mark(all_);
  schedule_.clear();
  EXPECT_TRUE(schedule_.take().empty());
  schedule_.mark(all_);
  EXPECT_EQ(passes_taken().at(0), 0u);
}

TEST_F(SampleScheduleTest, SamplesThatWereSearchedLeastAreSearchedFirst) {
  schedule_.search_in(all_);
  schedule_.take();
  const std::vector<SampleId> ids = curve_.samples();
  EXPECT_EQ(schedule_.mark_for_search(2), 1);
  EXPECT_EQ(schedule_.take().size(), ids.size());
  schedule_.follow({{}, {ids[1], ids[2]}});
  EXPECT_EQ(schedule_.take().size(), 2u);
  EXPECT_EQ(schedule_.mark_for_search(2), 1) << "of the renewed ones";
  EXPECT_EQ(schedule_.take().size(), 2u);
  EXPECT_EQ(schedule_.mark_for_search(2), 2);
  EXPECT_EQ(schedule_.take().size(), ids.size());
}

TEST_F(SampleScheduleTest, NoSampleIsSearchedMoreOftenThanAllowed) {
  schedule_.search_in(all_);
  schedule_.take();
  for (const int time : {1, 2}) {
    EXPECT_EQ(schedule_.mark_for_search(2), time);
    schedule_.take();
  }
  EXPECT_EQ(schedule_.mark_for_search(2), 0);
  EXPECT_TRUE(schedule_.take().empty());
  EXPECT_EQ(schedule_.mark_for_search(3), 3);
  schedule_.take();
  schedule_.follow({{}, {curve_.samples().front()}});
  schedule_.take();
  for (const int time : {1, 2}) {
    EXPECT_EQ(schedule_.mark_for_search(2), time);
    EXPECT_EQ(schedule_.take().size(), 1u);
  }
  EXPECT_EQ(schedule_.mark_for_search(2), 0);
}

TEST_F(SampleScheduleTest, OnlySamplesOfTheRegionAreSearched) {
  const Window left{all_.x0, all_.y0, all_.x0 + 60, all_.y1};
  schedule_.take();
  schedule_.search_in(left);
  EXPECT_EQ(schedule_.mark_for_search(1), 1);
  const std::vector<TargetSample> searched = schedule_.take();
  EXPECT_FALSE(searched.empty());
  for (const TargetSample& sample : searched) EXPECT_LT(sample.position.x - free_.field().origin.x, 60);
  const std::vector<SampleId> ids = curve_.samples();
  const auto beyond = std::ranges::find_if(
      ids, [&](SampleId id) { return curve_.sample(id).position.x - free_.field().origin.x >= 60; });
  schedule_.follow({{}, {*beyond}});
  schedule_.take();
  EXPECT_EQ(schedule_.mark_for_search(1), 0);
}

/// An interruption comes within a search: the samples wait, and those of the others that are behind are known again.
TEST_F(SampleScheduleTest, GoesOnWithASearchFromItsState) {
  schedule_.search_in(all_);
  schedule_.take();
  schedule_.mark_for_search(2);
  schedule_.take();
  const std::vector<SampleId> ids = curve_.samples();
  schedule_.follow({{}, {ids[3], ids[5], ids[7]}});
  schedule_.take();
  schedule_.mark_for_search(2);
  schedule_.put_back(schedule_.take());
  CheckpointState state;
  schedule_.save(state);
  SampleSchedule other(free_, curve_, growth_);
  other.search_in(all_);
  other.restore(state);
  for (SampleSchedule* schedule : {&schedule_, &other}) {
    EXPECT_EQ(schedule->take().size(), 3u);
    EXPECT_EQ(schedule->mark_for_search(2), 2);
    EXPECT_EQ(schedule->take().size(), ids.size());
    EXPECT_EQ(schedule->mark_for_search(2), 0);
  }
}

TEST_F(SampleScheduleTest, GoesOnFromItsState) {
  schedule_.take();
  schedule_.mark(curve_.samples().front());
  CheckpointState state;
  schedule_.save(state);
  SampleSchedule other(free_, curve_, growth_);
  other.restore(state);
  other.mark(all_);
  schedule_.mark(all_);
  const std::vector<TargetSample> expected = schedule_.take();
  const std::vector<TargetSample> found = other.take();
  EXPECT_TRUE(std::ranges::equal(
      found, expected, [](const TargetSample& a, const TargetSample& b) { return a.id == b.id && a.pass == b.pass; }));
}

/// When growing outward, nothing docks to the canvas' edge, and an empty canvas has no other boundary.
TEST(SampleSchedule, NoSampleCountsWherePiecesMayNotDock) {
  const PieceSettings pieces;
  const Canvas canvas = make_rectangle_canvas(200, 140);
  class NoShapes : public ShapeSource {
    const Shape& shape(ShapeId) override { throw std::logic_error("there are no shapes"); }
    const ShapeModel& model(ShapeId) override { throw std::logic_error("there are no shapes"); }
  } none;
  const FreeField free(canvas, pieces);
  const OpenedField opened(free, pieces);
  TargetCurve curve(pieces, PadParameters{});
  for (const bool outward : {false, true}) {
    std::optional<OutwardGrowth> growth;
    if (outward) growth.emplace(canvas, pieces, std::vector<Placement>{}, none);
    SampleSchedule schedule(free, curve, growth);
    curve.retrace(opened, free.field().origin, {free.field().value.bounds()});
    schedule.mark(free.field().value.bounds());
    EXPECT_EQ(schedule.take().empty(), outward);
    EXPECT_EQ(schedule.any_may_dock(), !outward);
  }
}

}  // namespace test_sample_schedule
}  // namespace tessera::master
