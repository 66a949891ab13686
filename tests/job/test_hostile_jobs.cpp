// 200 harmful job files. Each is refused in one line that names the place, the value found and the values allowed, or it is a legal job.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "core/base/stopwatch.h"
#include "hostile_job.h"
#include "job/job_file.h"
#include "job/job_keys.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_hostile_jobs {

constexpr std::uint32_t kJobs = 200;
constexpr std::size_t kLongestMessage = 700;  // bytes, without the file's path
constexpr double kLongest_s = 5;              // much less, except on a loaded machine

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Expects text that terminals and logs can show: one line without control characters.
void expect_readable(const std::string& message) {
  EXPECT_LT(message.size(), kLongestMessage) << message;
  for (const unsigned char c : message) EXPECT_TRUE(c >= 0x20 && c != 0x7f) << message;
}

/// Such mistakes appear only after the whole file is read. Their messages name the key, but no line.
bool is_of_the_whole_job(const std::string& message) {
  return has(message, ": both are given; ") || has(message, ": library.wishes: ") ||
         has(message, ": library.colours: ") || has(message, ": canvas.size_") || has(message, ": start.remove: ") ||
         has(message, ": start.lock: ") || has(message, ": colour.overlay: ");
}

void expect_says_what_is_allowed(const std::string& message, const std::string& where) {
  EXPECT_TRUE(has(message, where) || is_of_the_whole_job(message)) << message;
  EXPECT_TRUE(has(message, "allowed") || has(message, "needed:") || has(message, "not TOML: ") ||
              has(message, "is a section with the keys"))
      << message;
  expect_readable(message);
}

double most_of(const JobKey& key) { return key.max + 1e-6 * std::abs(key.max); }  // allows for float's rounding
double least_of(const JobKey& key) { return key.min - 1e-6 * std::abs(key.min); }

void expect_legal(const Job& job) {
  EXPECT_NE(job.library.empty(), job.library_files.empty());
  for (const JobKey& key : job_keys()) {
    const JobValue value = key.get(job);
    const bool is_absent = key.kind == JobKind::paper_size && value.numbers == std::vector<double>{0, 0};
    for (const double number : is_absent ? std::vector<double>() : value.numbers) {
      EXPECT_GE(number, least_of(key)) << key.full_name();
      EXPECT_LE(number, most_of(key)) << key.full_name();
    }
    const std::vector<double>& n = value.numbers;
    for (std::size_t i = 0; key.kind == JobKind::intervals && i + 1 < n.size(); i += 2) {
      EXPECT_LE(n[i], n[i + 1]) << key.full_name();
    }
    EXPECT_TRUE(key.kind != JobKind::size || n[0] * n[1] <= kMaxCanvas_px2) << key.full_name();
    EXPECT_EQ(value.text.find('\0'), std::string::npos) << key.full_name();
  }
  EXPECT_EQ(to_toml(job_from_toml(to_toml(job), job.path)), to_toml(job));
}

struct Tally {
  int accepted = 0;
  int refused = 0;
};

void load_and_judge(const std::string& path, const std::vector<std::string>& overrides, const std::string& where,
                    Tally& tally) {
  const Stopwatch watch;
  try {
    expect_legal(load_job(path, overrides));
    ++tally.accepted;
  } catch (const InputError& error) {
    std::string message = error.what();
    if (message.starts_with("job file ")) message.erase(0, 9);
    if (message.starts_with(path)) message.replace(0, path.size(), "job.toml");
    expect_says_what_is_allowed(message, where);
    ++tally.refused;
  }
  EXPECT_LT(watch.seconds(), kLongest_s);
}

TEST(HostileJobs, AreRefusedInOneLineOrLegal) {
  const test::ScratchFolder folder;
  Tally tally;
  for (std::uint32_t seed = 1; seed <= kJobs; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    load_and_judge(folder.write("job.toml", test::HostileJob(seed).make("own.h5")), {}, "job.toml", tally);
  }
  EXPECT_GT(tally.refused, int(kJobs / 2));
  EXPECT_GT(tally.accepted, int(kJobs / 20));
}

TEST(HostileJobs, InArgumentsToo) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("job.toml", "[library]\nfile = 'own.h5'\n");
  Tally tally;
  for (std::uint32_t seed = 1; seed <= kJobs; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    load_and_judge(path, {test::HostileJob(seed).make_override()}, "--set ", tally);
  }
  EXPECT_GT(tally.refused, int(kJobs / 4));
  EXPECT_GT(tally.accepted, int(kJobs / 20));
}

/// Checkpoints and the master's message hold a job, too. Text that is too deep for the parser must not reach it.
TEST(HostileJobs, AsTextToo) {
  std::string deep = "a";
  for (int i = 0; i < 500'000; ++i) deep += ".a";
  EXPECT_THROW(job_from_toml(deep + " = 1", "checkpoint.h5"), InputError);
}

}  // namespace test_hostile_jobs
}  // namespace tessera
