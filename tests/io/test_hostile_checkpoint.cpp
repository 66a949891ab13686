// Checkpoints that someone made to harm: each is refused with its name, or goes on as it would have; no crash, no hang, no
// more than 1 GB.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/base/error.h"
#include "forged_checkpoint.h"
#include "io/checkpoint/checkpoint_file.h"
#include "io/job/job_file.h"
#include "master/collage_loop.h"
#include "scratch_folder.h"
#include "support/divided_matcher.h"
#include "support/limited_child.h"

namespace tessera::io {
namespace {

using test::ForgedCheckpoint;
using test::ScratchFolder;

class StopAfter : public master::SilentObserver {
 public:
  explicit StopAfter(std::size_t steps) : left_(steps) {}
  void progressed(const master::Progress&) override { --left_; }
  const char* stop_requested() override { return left_ == 0 ? "signal" : nullptr; }

 private:
  std::size_t left_;
};

class KeepLatest : public master::CheckpointKeeper {
 public:
  bool due() override { return false; }
  void keep(const CheckpointState& state) override { latest = state; }
  CheckpointState latest;
};

class HostileCheckpoint : public testing::Test {
 protected:
  void SetUp() override {
    settings_.pieces.min_scale_px = 18;
    settings_.pieces.max_scale_px = 70;
    settings_.match.tangent_dockings = 60;
    library_ = test::synthetic_library(6);
    StopAfter stop(3);
    good_ = go_on(nullptr, stop);
    bytes_ = checkpoint_bytes({job_text_, 1, 2, good_});
  }

  /// The state after so many steps.
  CheckpointState go_on(const CheckpointState* from, master::Observer& observer) const {
    const MatchingContext context = make_matching_context(settings_, std::uint32_t(library_.size()));
    CompositeMatcher matcher = test::divided_matcher(library_, context, {});
    test::VectorShapes shapes(library_);
    KeepLatest keeper;
    master::make_collage(canvas_, settings_, matcher, shapes, observer, {from, &keeper});
    return keeper.latest;
  }

  /// What a restart does with it: reads it and rebuilds its state. Returns the refusal, or what is wrong after "WRONG: ".
  std::string use(bool may_differ) const {
    try {
      const Checkpoint checkpoint = read_checkpoint(path_);
      if (checkpoint.job != job_text_) {
        job_from_toml(checkpoint.job, path_ + ", its job");
        if (!may_differ) return "WRONG: another job";
      }
      StopAfter stop(0);
      const CheckpointState again = go_on(&checkpoint.state, stop);
      if (!may_differ && (again.placements != good_.placements || again.stale != good_.stale ||
                          again.pool.size() != good_.pool.size() || again.rebuilt_digest != good_.rebuilt_digest))
        return "WRONG: another state";
      return {};
    } catch (const InputError& error) {
      return error.what();
    } catch (const std::exception& error) {
      return std::string("WRONG: not an InputError: ") + error.what();
    }
  }

  bool try_forgery(std::uint32_t seed) {
    folder_.write("checkpoint.h5", {bytes_.begin(), bytes_.end()});
    test::CheckpointForger forger(seed);
    const ForgedCheckpoint forgery = forger.forge(path_, int(seed) % test::CheckpointForger::kKinds);
    const std::string what = "seed " + std::to_string(seed) + ": " + forgery.what;
    const test::ChildReport report = test::in_child([&] { return use(forgery.may_differ); });
    test::expect_survived(report, what);
    if (!report.said.empty()) test::expect_names_the_file(report.said, path_, what);
    return !report.said.empty();
  }

  void try_forgeries(std::uint32_t first, std::uint32_t count) {
    std::uint32_t refused = 0;
    for (std::uint32_t seed = first; seed < first + count; ++seed) refused += try_forgery(seed);
    EXPECT_GT(refused, count / 2);
  }

  const Canvas canvas_ = make_rectangle_canvas(160, 120);
  const std::string job_text_ = "seed = 7\n[library]\nfile = \"/a.h5\"\n[canvas]\nsize_px = [160, 120]\n";
  CollageSettings settings_;
  std::vector<Shape> library_;
  CheckpointState good_;
  std::vector<std::uint8_t> bytes_;
  ScratchFolder folder_;
  std::string path_ = folder_.path("checkpoint.h5");
};

TEST_F(HostileCheckpoint, IsFineBefore) {
  folder_.write("checkpoint.h5", {bytes_.begin(), bytes_.end()});
  EXPECT_EQ(use(false), "");
}

TEST_F(HostileCheckpoint, TwoHundredForgeries) { try_forgeries(0, 200); }

// Behind the label "long".
TEST_F(HostileCheckpoint, DISABLED_ThousandsOfForgeries) { try_forgeries(1000, 4000); }

}  // namespace
}  // namespace tessera::io
