// Harmful checkpoints. The program refuses each with its name, or goes on as that checkpoint says; without a crash, a hang, or more than 1
// GB.
#include <gtest/gtest.h>

#include "checkpoint/checkpoint_file.h"
#include "core/base/stop.h"
#include "forged_checkpoint.h"
#include "job/job_file.h"
#include "master/collage_loop.h"
#include "support/divided_matcher.h"
#include "support/hostile_file.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_hostile_checkpoint {

using test::ScratchFolder;

class StopAfter : public master::SilentObserver {
 public:
  explicit StopAfter(std::size_t steps) : left_(steps) {}
  void progressed(const master::Progress&) override { --left_; }
  std::optional<StopReason> stop_requested() override {
    return left_ == 0 ? std::optional(StopReason::signal) : std::nullopt;
  }

 private:
  std::size_t left_;
};

class KeepLatest : public master::CheckpointKeeper {
 public:
  bool due(LoopPhase /*phase*/) override { return false; }
  void keep(const CheckpointState& state) override { latest = state; }
  CheckpointState latest;
};

class HostileCheckpoint : public test::HostileFile {
 protected:
  void SetUp() override {
    settings_.pieces.min_scale_px = 18;
    settings_.pieces.max_scale_px = 70;
    settings_.match.tangent_dockings = 60;
    library_ = test::synthetic_library(6);
    StopAfter stop(3);
    good_ = go_on(nullptr, stop);
    bytes_ = checkpoint_bytes({job_text_, 1, 2, 3, good_});
  }

  /// Returns the state after a few more steps.
  CheckpointState go_on(const CheckpointState* from, master::Observer& observer) const {
    const MatchingContext context = make_matching_context(settings_, std::uint32_t(library_.size()));
    CompositeMatcher matcher = test::divided_matcher(library_, context, {});
    test::VectorShapes shapes(library_);
    KeepLatest keeper;
    master::make_collage(canvas_, settings_, matcher, shapes, observer, {from, &keeper});
    return keeper.latest;
  }

  /// Reads the file and rebuilds its state, as a restart does.
  std::string read(bool may_differ) const override {
    const Checkpoint checkpoint = read_checkpoint(path_);
    if (checkpoint.job != job_text_) {
      job_from_toml(checkpoint.job, path_ + ", its job");
      if (!may_differ) return "another job";
    }
    StopAfter stop(0);
    const CheckpointState again = go_on(&checkpoint.state, stop);
    if (!may_differ && (again.placements != good_.placements || again.stale != good_.stale ||
                        again.pool.size() != good_.pool.size() || again.rebuilt_digest != good_.rebuilt_digest))
      return "another state";
    return {};
  }

  test::Forgery forge(std::uint32_t seed) override {
    write_good();
    test::CheckpointForger forger(seed);
    return forger.forge(path_, int(seed) % test::CheckpointForger::kKinds);
  }

  const std::string& path() const override { return path_; }

  void write_good() { folder_.write("checkpoint.h5", {bytes_.begin(), bytes_.end()}); }

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
  write_good();
  EXPECT_EQ(use(false), "");
}

TEST_F(HostileCheckpoint, TwoHundredForgeries) { EXPECT_GT(try_forgeries(0, 200), 200u / 2); }

// ctest runs it under the label "long".
TEST_F(HostileCheckpoint, DISABLED_ThousandsOfForgeries) { EXPECT_GT(try_forgeries(1000, 4000), 4000u / 2); }

}  // namespace test_hostile_checkpoint
}  // namespace tessera
