// The conversion of a job back to TOML.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>

#include "job/job_tables.h"
#include "job_file_fixture.h"

namespace tessera {
namespace test_job_round_trip {

/// A value that the key accepts, not always a round number.
JobValue random_value(const JobKey& key) {
  const auto number = [&] {
    const double share = double(*rc::gen::inRange(0, 1000001)) / 1e6;
    const double value = key.min + share * (key.max - key.min);
    return key.kind == JobKind::integer || key.kind == JobKind::uses ? std::floor(value) : value;
  };
  switch (key.kind) {
    case JobKind::number:
    case JobKind::integer: return {{number()}, {}};
    case JobKind::flag: return {{}, *rc::gen::element<std::string>("true", "false")};
    case JobKind::intervals: {
      JobValue value;
      for (int left = *rc::gen::inRange(1, 5); left > 0; --left) {
        const double a = number();
        const double b = *rc::gen::inRange(0, 3) == 0 ? a : number();
        value.numbers.insert(value.numbers.end(), {std::min(a, b), std::max(a, b)});
      }
      return value;
    }
    case JobKind::point: return {{number(), number()}, {}};
    case JobKind::uses: return {{0, number()}, {}};
    case JobKind::name: return {{}, "a \"name\""};
    case JobKind::paper_size: return {{0, 0}, {}};  // must have the aspect of the canvas
    case JobKind::size: return {{double(*rc::gen::inRange(16, 5000)), double(*rc::gen::inRange(16, 20001))}, {}};
    case JobKind::word: return {{}, *rc::gen::elementOf(key.words)};
    case JobKind::file: return {{}, "/" + *rc::gen::container<std::string>(rc::gen::inRange<char>(' ', '~')) + "x"};
    case JobKind::texts:
    case JobKind::files:
      return {{}, {}, {"/" + *rc::gen::container<std::string>(rc::gen::inRange<char>(' ', '~')), "/b"}};
    case JobKind::palette:
      return {{},
              {},
              *rc::gen::elementOf(
                  std::vector<std::vector<std::string>>{{"#012345"}, {"forest"}, {"/p.gpl"}, {"#0a0b0c", "#ffffff"}})};
    case JobKind::colour: return {{}, *rc::gen::element<std::string>("#000000", "#12abcf", "#ffffff")};
    case JobKind::indices: return {key.name == "lock" ? std::vector{7.} : std::vector{3., 0., 17.}, {}};
    case JobKind::devices: return {{}, *rc::gen::element<std::string>("all", "gpu", "3", "5,0,63")};
  }
  return {};
}

JobRow random_row(const JobTable& table) {
  JobRow row;
  for (const JobKey& column : table.columns) {
    if (column.required || *rc::gen::inRange(0, 2) == 0) row[column.name] = random_value(column);
  }
  return row;
}

RC_GTEST_FIXTURE_PROP(JobFile, comes_back_from_toml_bit_by_bit, ()) {
  Job job;
  for (const JobKey& key : job_keys()) {
    JobValue value = random_value(key);
    if (key.kind == JobKind::file) value.text = std::filesystem::path(value.text).lexically_normal();
    if (key.kind == JobKind::files) value.texts[0] = std::filesystem::path(value.texts[0]).lexically_normal();
    key.set(job, value);
  }
  for (const JobTable& table : job_tables()) job.tables[table.name] = {random_row(table), random_row(table)};
  if (job.start.keep == StartKeep::free) job.start.remove.clear();
  job.wishes.clear();                            // there is no such file
  job.quality = QualityWord::none;               // improve.trials holds its value
  job.library_colours = {"#012345", "#ffffff"};  // for a palette the job stores the colours themselves
  *rc::gen::arbitrary<bool>() ? job.library.clear() : job.library_files.clear();
  if (*rc::gen::arbitrary<bool>()) {  // these two exclude each other
    job.canvas.seamless = Seamless::none;
  } else {
    job.settings.start.grow_outward = false;
  }
  const Job back = load(to_toml(job));
  for (const JobKey& key : job_keys()) {
    if (key.get(back) != key.get(job)) RC_FAIL(key.full_name() + " changed:\n" + to_toml(job));
  }
  RC_ASSERT(back.tables == job.tables);
  RC_ASSERT(to_toml(back) == to_toml(job));
  RC_ASSERT(to_toml(job_from_toml(to_toml(job), "elsewhere/job.toml")) == to_toml(job));
}

TEST_F(JobFile, writes_defaults_as_one_would_write_them) {
  const std::string text = to_toml(load(minimal_));
  EXPECT_NE(text.find("rotation_deg = [-180, 180]\n"), std::string::npos) << text;
  EXPECT_NE(text.find("delta_tau = 0.2\n"), std::string::npos) << text;
  EXPECT_NE(text.find("beta = 0.12\n"), std::string::npos) << text;
  EXPECT_NE(text.find("kind = \"scale_aware\"\n"), std::string::npos) << text;
}

}  // namespace test_job_round_trip
}  // namespace tessera
