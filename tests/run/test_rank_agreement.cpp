// What a worker compares with the master before the first round, over ranks that are threads.
#include "run/rank_agreement.h"

#include <gtest/gtest.h>

#include <thread>

#include "comm/in_process_communicator.h"
#include "core/base/error.h"

namespace tessera::cli {
namespace test_rank_agreement {

/// What the worker's `join` throws, as text; "" for nothing. The master runs "master 1" with a job of seed 5.
template <class Join>
std::string complaint(Join join) {
  comm::InProcessNetwork network(2);
  std::jthread master([&network] {
    Job job;
    job.library = "/a/library.h5";
    job.quality = QualityWord::none;  // an effective job has the number in its place
    job.settings.seed = 5;
    const auto ranks = network.connect(0);
    announce_job(*ranks, "master 1", job);
  });
  const auto ranks = network.connect(1);
  try {
    join(*ranks);
    return "";
  } catch (const EnvironmentError& error) {
    return error.what();
  }
}

TEST(RankAgreement, the_masters_job_arrives) {
  EXPECT_EQ(complaint([](comm::Communicator& ranks) {
              const Job job = receive_job(ranks, "master 1");
              EXPECT_EQ(job.settings.seed, 5u);
              EXPECT_EQ(job.library, "/a/library.h5");
            }),
            "");
}

/// To the bit, however its sizes divide.
TEST(RankAgreement, what_was_found_on_the_canvas_arrives) {
  Grid<Texel> finest(37, 11);
  for (std::size_t i = 0; i < finest.data().size(); ++i)
    finest.data()[i] = {float(i) / 7, float(i) / 3, -1.f / 9, 0.7f};
  const auto target = std::make_shared<const ColourTarget>(finest, 1.7f);
  const auto sizes = std::make_shared<const SizeMap>(SizeMap{Grid<float>(5, 3, 0.3f), 0.7f});
  comm::InProcessNetwork network(2);
  std::jthread master([&] { announce_findings(*network.connect(0), {1. / 3, 0.1, {target, sizes}}); });
  const CanvasFindings found = receive_findings(*network.connect(1));
  EXPECT_EQ(found.size_factor, 1. / 3);
  EXPECT_EQ(found.room_part, 0.1);
  ASSERT_TRUE(found.overlays.colour);
  EXPECT_EQ(found.overlays.colour->texels(), target->texels());
  ASSERT_TRUE(found.overlays.sizes);
  EXPECT_EQ(found.overlays.sizes->part.data(), sizes->part.data());
  EXPECT_EQ(found.overlays.sizes->cells_per_px, 0.7f);
  EXPECT_EQ(found.overlays.colour->levels().back().texels_per_px, target->levels().back().texels_per_px);
}

TEST(RankAgreement, where_there_is_no_picture_none_arrives) {
  comm::InProcessNetwork network(2);
  std::jthread master([&] { announce_findings(*network.connect(0), {}); });
  const CanvasFindings found = receive_findings(*network.connect(1));
  EXPECT_FALSE(found.overlays.colour);
  EXPECT_FALSE(found.overlays.sizes);
}

TEST(RankAgreement, another_program_is_refused) {
  EXPECT_EQ(
      complaint([](comm::Communicator& ranks) { receive_job(ranks, "worker 2"); }),
      "this rank runs worker 2, the master master 1; allowed: the same program on all ranks; install it anew on every "
      "node");
}

TEST(RankAgreement, the_program_is_told_by_version_commit_and_kernels) {
  EXPECT_TRUE(program_identity().starts_with("tessera "));
  EXPECT_NE(program_identity().find(", commit "), std::string::npos);
  EXPECT_NE(program_identity().find(", kernels "), std::string::npos);
}

}  // namespace test_rank_agreement
}  // namespace tessera::cli
