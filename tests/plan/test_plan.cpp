// tessera plan: how the estimates depend on their inputs, and the head of the batch script.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/base/kept_memory.h"
#include "core/matching/matching_context.h"
#include "plan/plan_estimate.h"
#include "plan/plan_text.h"
#include "support/colours.h"
#include "worker/shard/shard.h"

namespace tessera::cli {
namespace test_plan {

/// The input of jobs/animals.toml with the demo's library.
PlanInput animals() {
  PlanInput input;
  input.canvas_px2 = input.canvas_nodes = 1e6;
  input.picture_px2 = 4e6;
  input.shapes = 232;
  input.ranks = 3;
  return input;
}

TEST(Plan, is_near_what_was_measured) {
  PlanInput input = animals();
  input.ranks = 1;
  input.picture_px2 = 250e3;
  const PlanEstimate plan = estimate(input);  // measured: 178 pieces, 297 MB, 4.9 s of the loop
  EXPECT_NEAR(plan.pieces, 178, 178 * 0.5);
  EXPECT_NEAR(plan.master_bytes, 297e6, 297e6 * 0.25);
  EXPECT_GT(plan.total_s, 4.9 / 2);
  EXPECT_LT(plan.total_s, 4.9 * 3);  // including the start and the files
}

/// The numbers in the line of times.
std::vector<double> told_times(const std::string& text) {
  const std::size_t begin = text.find("about ", text.find("  time"));
  const std::string line = text.substr(begin, text.find('\n', begin) - begin);
  std::vector<double> times;
  for (std::size_t at = 0; (at = line.find_first_of("0123456789", at)) != std::string::npos;) {
    std::size_t length = 0;
    times.push_back(std::stod(line.substr(at), &length));
    at += length;
  }
  return times;
}

TEST(Plan, the_parts_of_the_time_add_up) {
  for (const int trials : {0, 60, 3000, 200'000}) {
    for (const double limit_s : {0., 0.5, 400.}) {
      PlanInput input = animals();
      input.settings.improve.trials = trials;
      input.settings.stop.seconds = limit_s;
      const PlanEstimate plan = estimate(input);
      EXPECT_DOUBLE_EQ(plan.filling_s + plan.improving_s + plan.beside_s, plan.total_s);
      const bool improves = trials > 0 && limit_s != 0.5;  // filling alone uses up such a limit
      EXPECT_EQ(plan.improving_s > 0, improves) << trials << " trials, " << limit_s << " s";
      const std::vector<double> times = told_times(plan_text(input, plan));
      ASSERT_EQ(times.size(), 4u);
      EXPECT_NEAR(times[1] + times[2] + times[3], times[0], 0.66) << trials;
    }
  }
}

TEST(Plan, a_search_for_sizes_takes_a_few_attempts) {
  PlanInput input = animals();
  input.settings.pieces.uses = 1;
  const PlanEstimate once = estimate(input);
  EXPECT_EQ(plan_text(input, once).find("attempts"), std::string::npos);
  input.settings.pieces.fit_all = true;
  const PlanEstimate searched = estimate(input);
  EXPECT_GT(searched.filling_s, 2 * once.filling_s);
  EXPECT_GT(searched.pads_per_shape, once.pads_per_shape) << "of the levels for smaller sizes, too";
  EXPECT_NE(plan_text(input, searched).find("a few attempts at sizes (pieces.fit), of 12 at most"), std::string::npos);
}

/// 25 drawings on 400 x 400 px. By the job's sizes only three pieces would fit.
TEST(Plan, counts_each_wanted_piece_where_all_are_to_fit) {
  PlanInput input = animals();
  input.canvas_px2 = input.canvas_nodes = 160'000;
  input.shapes = 25;
  input.settings.pieces.min_scale_px = input.settings.pieces.max_scale_px = 170;
  input.settings.pieces.fit_all = true;
  input.settings.pieces.uses = 1;
  EXPECT_EQ(estimate(input).pieces, 25);
  input.settings.pieces.least_uses = input.settings.pieces.uses = 3;
  EXPECT_EQ(estimate(input).pieces, 75);
  input.settings.stop.pieces = 7;
  EXPECT_EQ(estimate(input).pieces, 7);
}

TEST(Plan, counts_a_drawing_and_its_mirror_image_once) {
  PlanInput input = animals();
  input.canvas_px2 = 25e6;
  input.shapes = 80;
  input.settings.pieces.uses = 1;
  EXPECT_EQ(estimate(input).pieces, 80);
  for (std::uint32_t i = 0; i < 80; ++i) input.drawings.push_back(i % 40);
  EXPECT_EQ(estimate(input).pieces, 40);
  input.settings.wishes.classes.resize(2);
  input.settings.wishes.classes[1].weight = 0;
  for (std::uint32_t i = 0; i < 80; ++i) input.settings.wishes.class_of_shape.push_back(i % 40 < 10);
  EXPECT_EQ(estimate(input).pieces, 30) << "ten may not stand";
}

TEST(Plan, shapes_are_divided_among_the_workers) {
  PlanInput input = animals();
  input.ranks = 9;
  const PlanEstimate plan = estimate(input);
  EXPECT_EQ(plan.workers, 8);
  EXPECT_EQ(plan.shapes_per_worker, 29u);
  EXPECT_LT(plan.device_bytes, estimate(animals()).device_bytes);
  EXPECT_LT(plan.total_s, estimate(animals()).total_s);
}

TEST(Plan, warns_of_workers_without_shapes) {
  PlanInput input = animals();
  input.shapes = 5;
  input.ranks = 6;
  EXPECT_EQ(idle_workers_warning(input, estimate(input)), "");
  input.ranks = 9;
  EXPECT_EQ(idle_workers_warning(input, estimate(input)),
            "--ranks 9: 8 workers divide 5 shapes, so that some have none; --ranks 6 is as good");
}

/// Workers cannot read a choice of a very large library shape by shape.
TEST(Plan, counts_what_workers_hold_that_cannot_read) {
  PlanInput reads = animals();
  reads.shapes = 400'000;
  PlanInput holds = reads;
  holds.reads = false;
  const MatchingContext context = make_matching_context(reads.settings, std::uint32_t(reads.shapes));
  const worker::ShardBytes all = worker::shard_bytes(context, reads.shapes / 2, false);
  const worker::ShardBytes part = worker::shard_bytes(context, reads.shapes / 2, true);
  EXPECT_GT(all.host, 2e9);
  EXPECT_NEAR(estimate(holds).worker_bytes - estimate(reads).worker_bytes,
              double(all.host + all.device) - double(part.host + part.device), 1e6);
}

TEST(Plan, takes_the_device_bytes_from_the_workers) {
  PlanInput input = animals();
  PlanInput twice = animals();
  twice.shapes *= 2;
  const MatchingContext context = make_matching_context(input.settings, std::uint32_t(input.shapes));
  const double more = estimate(twice).device_bytes - estimate(input).device_bytes;
  const double shard = double(worker::shard_bytes(context, input.shapes / 2, true).device);  // for each of two workers
  constexpr double kListsOfAShape_bytes = 2 * 15e3;  // the lists of pairs and of dockings
  EXPECT_GE(estimate(twice).largest_buffer_bytes,
            double(worker::shard_bytes(context, twice.shapes / 2, true).largest_buffer));
  EXPECT_NEAR(more, shard + kListsOfAShape_bytes * double(input.shapes / 2), 0.05 * more);
}

/// A job that needs hardly any memory of its own.
TEST(Plan, counts_the_freed_memory_that_each_process_keeps) {
  PlanInput small = animals();
  small.shapes = 1;
  small.canvas_px2 = small.canvas_nodes = small.picture_px2 = 100;
  constexpr double kLeastOfAll_bytes = 3 * 95e6;  // measured before freed memory was kept
  EXPECT_GT(estimate(small).node_bytes, kLeastOfAll_bytes + 3 * double(kKeptFreed_bytes));
  EXPECT_NE(plan_text(small, estimate(small)).find("64 MB of freed"), std::string::npos);
}

/// Pieces of 5 to 20 px on 1500 x 1500 px, measured in one process: 11,521 pieces, 942 MB.
TEST(Plan, counts_the_memory_of_many_small_pieces) {
  PlanInput input = animals();
  input.ranks = 1;
  input.canvas_px2 = input.canvas_nodes = 2.25e6;
  input.picture_px2 = 160e3;
  input.settings.pieces.min_scale_px = 5;
  input.settings.pieces.max_scale_px = 20;
  const PlanEstimate plan = estimate(input);
  EXPECT_NEAR(plan.pieces, 11'521, 11'521 * 0.2);
  EXPECT_NEAR(plan.node_bytes, 942e6, 942e6 * 0.2);
}

std::shared_ptr<const SizeMap> size_map(float left_part, float right_part) {
  auto map = std::make_shared<SizeMap>();
  map->part = Grid<float>(2, 1);
  map->part(0, 0) = left_part;
  map->part(1, 0) = right_part;
  return map;
}

TEST(Plan, a_size_map_says_how_many_pieces_there_will_be) {
  PlanInput input = animals();
  input.canvas_px2 = input.canvas_nodes = 25e6;
  input.settings.pieces.min_scale_px = 20;
  input.settings.pieces.max_scale_px = 80;
  const double large = estimate(input).pieces;
  input.settings.pieces.size_map = size_map(1, 1);
  EXPECT_NEAR(estimate(input).pieces, large, 1);
  input.settings.pieces.size_map = size_map(0, 0);
  EXPECT_NEAR(estimate(input).pieces, 4 * large, 4);
  input.settings.pieces.size_map = size_map(0, 1);
  EXPECT_NEAR(estimate(input).pieces, 2.5 * large, 3);
}

/// tessera mosaic of astronaut.jpg on 8000 x 8000 px, 27 to 107 px, mostly the smallest by its map: 46,054 pieces, and a loop of 433 s
/// with two workers of one core.
TEST(Plan, knows_mosaics) {
  PlanInput input = animals();
  input.shapes = 6082;
  input.canvas_px2 = input.canvas_nodes = 64e6;
  input.settings.pieces.min_scale_px = 27;
  input.settings.pieces.max_scale_px = 107;
  input.settings.pieces.size_map = size_map(0.4f, 0.9f);
  const double without_a_picture = estimate(input).pieces;
  input.settings.colour.target = test::picture(8, 8, [](Vec2) { return test::opaque({50, 0, 0}); });
  const PlanEstimate plan = estimate(input);
  EXPECT_NEAR(plan.pieces, 46'054, 46'054 * 0.25);
  EXPECT_GT(plan.pieces, 1.2 * without_a_picture) << "small pieces fill what the colours leave";
  EXPECT_NEAR(plan.filling_s, 433, 433 * 0.5);
}

TEST(Plan, obeys_the_limits_of_the_job) {
  PlanInput input = animals();
  input.settings.stop.pieces = 7;
  EXPECT_EQ(estimate(input).pieces, 7);
  input = animals();
  input.canvas_px2 = input.canvas_nodes = 25e6;
  input.settings.pieces.uses = 2;
  EXPECT_EQ(estimate(input).pieces, 464);
  input.settings.improve.trials = 1'000'000;
  input.settings.stop.seconds = 60;
  EXPECT_LT(estimate(input).total_s, 70);
  input.settings.stop.seconds = 0;
  input.settings.improve.seconds = 100;
  EXPECT_LT(estimate(input).total_s, 200);
}

TEST(Plan, counts_no_trials_where_filling_ends_before) {
  PlanInput draft = animals();
  PlanInput good = animals();
  good.settings.improve.trials = 420;
  EXPECT_GT(estimate(good).total_s, estimate(draft).total_s + 1);
  for (const StopSettings& stop : {StopSettings{.pieces = 7}, StopSettings{.coverage = 0.5f}}) {
    draft.settings.stop = good.settings.stop = stop;
    EXPECT_EQ(estimate(good).total_s, estimate(draft).total_s);
  }
  draft.settings.stop = good.settings.stop = {.pieces = 1'000'000};
  EXPECT_GT(estimate(good).total_s, estimate(draft).total_s + 1) << "more than the canvas holds";
}

RC_GTEST_PROP(Plan, more_of_anything_needs_no_less, ()) {
  PlanInput input = animals();
  input.shapes = *rc::gen::inRange<std::size_t>(1, 100'000);
  input.ranks = *rc::gen::inRange(1, 200);
  input.nodes = *rc::gen::inRange(1, input.ranks + 1);
  input.canvas_px2 = input.canvas_nodes = *rc::gen::inRange(1, 10'000) * 1e4;
  const PlanEstimate plan = estimate(input);
  PlanInput more = input;
  more.shapes *= 2;
  more.canvas_px2 = more.canvas_nodes *= 2;
  const PlanEstimate larger = estimate(more);
  RC_ASSERT(plan.workers_per_node * input.nodes >= plan.workers);
  RC_ASSERT(plan.ranks_per_node * input.nodes >= input.ranks);
  RC_ASSERT(larger.node_bytes > plan.node_bytes);
  RC_ASSERT(larger.total_s > plan.total_s);
  RC_ASSERT(larger.checkpoint_bytes > plan.checkpoint_bytes);
}

TEST(Plan, header_is_what_sbatch_takes) {
  PlanInput input = animals();
  input.ranks = 9;
  input.nodes = 4;
  PlanEstimate plan = estimate(input);
  plan.node_bytes = 1e9;
  plan.total_s = 400;
  EXPECT_EQ(sbatch_header(input, plan),
            "#SBATCH --nodes=4\n#SBATCH --ntasks=9\n#SBATCH --ntasks-per-node=3\n#SBATCH --mem=1300M\n"
            "#SBATCH --time=00:25:00\n#SBATCH --signal=B:USR2@120\n#SBATCH --cpus-per-task=2\n");
  input.host_devices = false;
  EXPECT_NE(sbatch_header(input, plan).find("--gres=gpu:2\n"), std::string::npos);
  EXPECT_EQ(slurm_time(100 * 3600 + 61), "100:01:01");
}

TEST(Plan, says_that_it_estimates) {
  const std::string text = plan_text(animals(), estimate(animals()));
  for (const char* part :
       {"Estimates for 3 ranks, a master and 2 workers", "232 shapes", "in one buffer", "about", "half or twice"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  }
}

}  // namespace test_plan
}  // namespace tessera::cli
