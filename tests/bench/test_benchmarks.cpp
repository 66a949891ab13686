// Every benchmark runs in its quick version, and its JSON holds the documented values.
#include "bench/benchmarks.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "bench/formula_library.h"
#include "bench/replacing_case.h"
#include "bench/scaling_case.h"
#include "core/base/error.h"
#include "support/scratch_folder.h"

namespace tessera::bench {
namespace test_benchmarks {

const Setting kQuick{.quick = true, .devices = "all", .out = ""};

const std::string& library() {
  static const test::FormulaLibrary made(12);
  return made.path();
}

void expect_keys(const Json& json, const std::vector<std::string>& keys) {
  for (const std::string& key : keys) EXPECT_TRUE(json.contains(key)) << key << " in\n" << json.dump(2);
}

void expect_head(const Report& report, const std::string& name) {
  EXPECT_EQ(report.json.at("benchmark"), name);
  EXPECT_EQ(report.json.at("quick"), true);
  EXPECT_FALSE(report.json.at("devices").empty());
  EXPECT_FALSE(report.text.empty());
}

TEST(Benchmarks, Pairs) {
  const Report report = bench_pairs(kQuick, {});
  expect_head(report, "pairs");
  expect_keys(report.json, {"cores", "pairs", "elements_per_pair", "operations_per_pair", "bytes_per_pair"});
  for (const char* rate : {"index_pairs_per_s", "device_pairs_per_s", "device_pairs_per_core_s", "plain_pairs_per_s",
                           "limit_float_pairs_per_s", "limit_byte_pairs_per_s", "limit_memory_pairs_per_s"}) {
    EXPECT_GT(report.json.at(rate).get<double>(), 0) << rate;
  }
}

TEST(Benchmarks, Headline) {
  const Report report = bench_headline(kQuick);
  expect_head(report, "headline");
  expect_keys(report.json,
              {"pair_tests", "runs", "prune_s", "dock_s", "dockings_evaluated", "dockings_refined", "thorough_score"});
  EXPECT_GT(report.json.at("median_s").get<double>(), 0);
  EXPECT_EQ(report.json.at("positions").get<int>(),
            report.json.at("target_samples").get<int>() * report.json.at("shape_points").get<int>());
  EXPECT_EQ(report.json.at("paper_s"), 0.064);
  EXPECT_LE(report.json.at("dockings_refined").get<int>(), 32);
  EXPECT_GT(report.json.at("best_score").get<double>(), 0.9 * report.json.at("thorough_score").get<double>());
}

TEST(Benchmarks, Table2) {
  const Report report = bench_table2(kQuick, {library(), {"19", "18"}});
  expect_head(report, "table2");
  const Json& rows = report.json.at("rows");
  ASSERT_EQ(rows.size(), 2u);
  for (const Json& row : rows) {
    for (const char* whose : {"ours", "paper"}) {
      expect_keys(row.at(whose),
                  {"candidates", "pads_per_shape", "iterations", "docking_choices", "pruned_percent", "total_s",
                   "prune_share_percent", "dock_share_percent", "objective_share_percent", "merge_share_percent"});
    }
    EXPECT_EQ(row.at("ours").at("stopped_by"), "pieces");
    EXPECT_EQ(row.at("ours").at("iterations"), row.at("paper").at("iterations"));
  }
  EXPECT_EQ(rows[0].at("figure"), "18") << "in the paper's order";
  EXPECT_NE(report.text.find("Fig. 18: the library has 12 shapes of 18."), std::string::npos) << report.text;
  EXPECT_EQ(report.text.find("Fig. 19: the library"), std::string::npos);
}

TEST(Benchmarks, Table2RefusesUnknownRows) {
  try {
    bench_table2(kQuick, {library(), {"19", "20"}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "--rows: found \"20\"; allowed: 1, 13a, 13b, 13c, 21, 16, 17, 18, 19, 22");
  }
}

TEST(Benchmarks, Alternatives) {
  const Report report = bench_alternatives(kQuick, {.library = library(), .scale_px = {20, 80}});
  expect_head(report, "alternatives");
  const Json& engines = report.json.at("engines");
  ASSERT_EQ(engines.size(), 6u);
  for (const Json& engine : engines) {
    expect_keys(engine, {"engine", "coverage_percent", "overlap_percent", "outside_percent", "shared_boundary_percent",
                         "pieces", "total_s"});
    EXPECT_GT(engine.at("pieces").get<int>(), 0) << engine.dump(2);
  }
  EXPECT_GT(engines[0].at("coverage_percent").get<double>(), engines[5].at("coverage_percent").get<double>())
      << "random filling is no match";
}

TEST(Benchmarks, AlternativesChecksItsArguments) {
  EXPECT_THROW(bench_alternatives(kQuick, {.library = library(), .scale_px = {80, 20}}), InputError);
  EXPECT_THROW(bench_alternatives(kQuick, {.library = library(), .size_px = 3}), InputError);
}

TEST(Benchmarks, Quality) {
  const Report report = bench_quality(kQuick, {.library = library(), .scale_px = {20, 80}}, 32);
  expect_head(report, "quality");
  const Json& rows = report.json.at("rows");
  ASSERT_EQ(rows.size(), 4u) << "after 1 and 2 s, twice";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    expect_keys(rows[i], {"seconds", "trials", "coverage_percent", "overlap_percent", "size_balance", "pieces",
                          "distinct_shapes"});
    EXPECT_EQ(rows[i].at("relax").get<bool>(), i < 2);
    EXPECT_GE(rows[i].at("seconds").get<double>(), i % 2 + 1.);
  }
  EXPECT_GE(rows[1].at("trials").get<int>(), rows[0].at("trials").get<int>());
  EXPECT_GT(rows[1].at("pieces").get<int>(), 0);
}

TEST(Benchmarks, QualityChecksItsArguments) {
  EXPECT_THROW(bench_quality(kQuick, {.library = library(), .scale_px = {80, 20}}, 32), InputError);
  EXPECT_THROW(bench_quality(kQuick, {.library = library()}, 0), InputError);
}

TEST(Benchmarks, Replacing) {
  const Report report = bench_replacing(kQuick, {.library = library(), .scale_px = {30, 60}, .size_px = 2000});
  expect_head(report, "replacing");
  const test::ScratchFolder folder;
  write_report(report, folder.path("replacing.json"));
  const ReplacingCase found = read_replacing_case(folder.path("replacing.json"));
  EXPECT_EQ(found.canvas_px, 300);
  EXPECT_GT(found.pieces, 20u);
  EXPECT_GT(found.windows.size(), 0u);
  EXPECT_GT(found.trials(), found.pieces / 2);
  EXPECT_GT(found.work_s(), 0);
  for (const double measured_s : {found.master_s, found.request_s, found.unpack_s, found.reply_s}) {
    EXPECT_GT(measured_s, 0);
    EXPECT_LT(measured_s, 1);
  }
  for (const MeasuredWindow& w : found.windows) {
    EXPECT_GT(w.trials, 0u);
    EXPECT_GT(w.work_s, 0);
    EXPECT_GT(w.request_bytes, 1000);
    EXPECT_GT(w.reply_bytes, 20);
  }
}

TEST(Benchmarks, ReplacingReportsThatAreNone) {
  const test::ScratchFolder folder;
  const auto complaint = [&](const std::string& text) {
    std::ofstream(folder.path("r.json")) << text;
    try {
      read_replacing_case(folder.path("r.json"));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_THROW(read_replacing_case(folder.path("none.json")), InputError);
  for (const char* text : {"", "{", "[1]", "{\"batch\":3}", "{\"batch\":{\"canvas_px\":\"wide\"}}"}) {
    EXPECT_NE(complaint(text).find("r.json: "), std::string::npos) << text;
    EXPECT_NE(complaint(text).find("allowed: the JSON file of tessera bench replacing"), std::string::npos) << text;
  }
}

TEST(Benchmarks, Library) {
  LibraryOptions options;
  options.library = library();
  const Report report = bench_library(kQuick, options);
  expect_head(report, "library");
  const Json& sizes = report.json.at("sizes");
  ASSERT_EQ(sizes.size(), 2u);
  EXPECT_EQ(sizes[1].at("shapes"), 30) << "more than the file has";
  for (const Json& size : sizes) {
    expect_keys(size, {"prune_s", "dock_s", "master_s", "target_samples", "start_s", "first_piece_s"});
    EXPECT_GT(size.at("master_s").get<double>(), 0);
    EXPECT_EQ(size.at("pieces"), 3);
    EXPECT_GT(size.at("s_per_piece").get<double>(), 0);
    EXPECT_GT(size.at("peak_memory_bytes").get<double>(), 1e6);
  }
}

/// Models read from a library file give the same matches as models made in memory, for a new file and for an existing one.
TEST(Benchmarks, LibraryReadsModelsOfAFile) {
  LibraryOptions options;
  options.library = library();
  const auto samples = [&] { return bench_library(kQuick, options).json.at("sizes")[1].at("target_samples"); };
  const Json made = samples();
  const test::ScratchFolder folder;
  options.models = folder.path("");
  EXPECT_EQ(samples(), made);
  EXPECT_TRUE(std::filesystem::exists(folder.path("models_30")));
  EXPECT_EQ(samples(), made);
}

TEST(Benchmarks, LibraryChecksItsSizes) {
  LibraryOptions options;
  options.library = library();
  options.sizes = {100, 0};
  EXPECT_THROW(bench_library({}, options), InputError);
}

/// A quick version keeps the options that are given and reduces all others. Every reduced part is reported.
TEST(Benchmarks, QuickOnesDoWhatIsAskedFor) {
  LibraryOptions sizes;
  sizes.library = library();
  sizes.sizes = {20};
  EXPECT_EQ(bench_library(kQuick, sizes).json.at("sizes").at(0).at("shapes"), 20);
  sizes.sizes = {0};
  EXPECT_THROW(bench_library(kQuick, sizes), InputError);

  SquareJob job;
  job.library = library();
  job.scale_px = {15, 50};
  Setting setting = kQuick;
  std::vector<std::string> told;
  setting.progress = [&](const std::string& line) { told.push_back(line); };
  EXPECT_EQ(bench_variety(setting, job, {}).json.at("rows").size(), 4u);
  EXPECT_EQ(told, (std::vector<std::string>{"10 shapes, seed 1", "30 shapes, seed 1"}));
}

/// A limit of no pairs gives other dockings than a limit of some. The rows differ and hold the given options.
TEST(Benchmarks, Variety) {
  SquareJob job;
  job.library = library();
  job.scale_px = {15, 50};
  VarietyOptions options;
  options.sizes = {10, 30};
  options.pairs = {0, 50};
  options.seeds = 2;
  const Report report = bench_variety(kQuick, job, options);
  expect_head(report, "variety");
  const Json& rows = report.json.at("rows");
  ASSERT_EQ(rows.size(), 4u);
  for (const Json& row : rows) {
    expect_keys(row, {"overlap_percent", "shared_boundary_percent", "size_balance", "distinct_shapes", "ms_per_piece"});
    EXPECT_GT(row.at("coverage_percent").get<double>(), 10);
    EXPECT_GT(row.at("pieces").get<double>(), 1);
  }
  EXPECT_EQ(rows[1].at("pairs"), 50);
  EXPECT_EQ(rows[2].at("shapes"), 30);
  EXPECT_NE(rows[2].at("coverage_percent"), rows[3].at("coverage_percent"));

  options.seeds = 0;
  EXPECT_THROW(bench_variety(kQuick, job, options), InputError);
  options.seeds = 1;
  options.pairs = {3'000'000'000};
  EXPECT_THROW(bench_variety(kQuick, job, options), InputError);
  options.pairs = {0};
  options.sizes = {0};
  EXPECT_THROW(bench_variety(kQuick, job, options), InputError);
}

ScalingOptions scaling(const std::vector<int>& ranks, int repeats) {
  ScalingOptions options;
  options.library = library();
  options.ranks = ranks;
  options.repeats = repeats;
  options.program = TESSERA_PROGRAM;
  return options;
}

TEST(Benchmarks, Scaling) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "it starts mpirun, and Open MPI leaks";
#endif
  setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
  const test::ScratchFolder folder;
  Setting setting = kQuick;
  setting.out = folder.path("scaling.json");
  ScalingOptions options = scaling({2, 3}, 1);
  options.pieces = 2;
  const Report report = bench_scaling(setting, options);
  expect_head(report, "scaling");
  EXPECT_EQ(report.json.at("pieces"), 2) << "--quick leaves what is asked for";
  EXPECT_EQ(report.text.find("Amdahl"), std::string::npos) << report.text;
  const Json& cases = report.json.at("cases");
  ASSERT_EQ(cases.size(), 4u) << "6 and 12 shapes on 1 and 2 workers";
  for (const Json& c : cases) {
    EXPECT_GT(c.at("loop_s").get<double>(), 0);
    EXPECT_EQ(c.at("ranks").at("workers"), c.at("workers"));
  }
  for (const char* series : {"strong", "weak"}) {
    ASSERT_EQ(report.json.at(series).size(), 2u);
    EXPECT_EQ(report.json.at(series)[0].at("speed_up"), 1);
    EXPECT_EQ(report.json.at(series)[1].at("shapes"), 12);
  }
  expect_keys(report.json.at("amdahl"), {"serial_s", "parallel_s", "serial_percent"});
  for (const char* ending : {"csv", "svg", "png"}) {
    EXPECT_TRUE(std::filesystem::file_size(folder.path("scaling." + std::string(ending))) > 100) << ending;
  }
  write_report(report, setting.out);
  EXPECT_EQ(read_scaling_cases(setting.out).size(), 4u);
}

TEST(Benchmarks, ScalingChecksItsArguments) {
  EXPECT_THROW(bench_scaling(kQuick, scaling({1, 2}, 3)), InputError);
  EXPECT_THROW(bench_scaling(kQuick, scaling({2, 3}, 0)), InputError);
  EXPECT_THROW(read_scaling_cases("none.json"), InputError);
}

TEST(Benchmarks, NameTheLibraryThatIsMissing) { EXPECT_THROW(bench_table2(kQuick, {"none.h5", {}}), InputError); }

}  // namespace test_benchmarks
}  // namespace tessera::bench
