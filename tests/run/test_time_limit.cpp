// The time at which a run must be over.
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "core/base/error.h"
#include "run/progress/time_limit.h"

namespace tessera::cli {
namespace test_time_limit {

TEST(TimeLimit, is_given_in_seconds_or_hours) {
  EXPECT_EQ(parse_time_limit("90"), 90);
  EXPECT_EQ(parse_time_limit("0.5"), 0.5);
  EXPECT_EQ(parse_time_limit("1:30:05"), 5405);
  EXPECT_EQ(parse_time_limit("00:00:10"), 10);
  EXPECT_EQ(parse_time_limit("120:00:00"), 432000);
}

TEST(TimeLimit, is_given_as_to_sbatch_but_that_a_plain_number_is_seconds) {
  EXPECT_EQ(parse_time_limit("90s"), 90);
  EXPECT_EQ(parse_time_limit("90m"), 5400);
  EXPECT_EQ(parse_time_limit("1.5h"), 5400);
  EXPECT_EQ(parse_time_limit("1:30"), 90);
  EXPECT_EQ(parse_time_limit("90:00"), 5400);
  EXPECT_EQ(parse_time_limit("1-12"), 129600);
  EXPECT_EQ(parse_time_limit("0-00:30"), 1800);
  EXPECT_EQ(parse_time_limit("1-12:30"), 131400);
  EXPECT_EQ(parse_time_limit("1-00:00:01"), 86401);
  for (const char* word : {"UNLIMITED", "unlimited", "Unlimited", "INFINITE", "infinite"}) {
    EXPECT_TRUE(std::isinf(parse_time_limit(word))) << word;
  }
}

TEST(TimeLimit, unlimited_goes_before_the_slurm_jobs) {
  EXPECT_TRUE(std::isinf(time_limit_s("UNLIMITED", "1700000100", 1700000000, 0)));
}

TEST(TimeLimit, must_be_longer_than_what_is_kept_of_it) {
  EXPECT_THROW(time_limit_s("0.001", nullptr, 0, 0), InputError);
  EXPECT_EQ(time_limit_s("10", nullptr, 0, 0), 10);
  EXPECT_THROW(time_limit_s("5", nullptr, 0, 4), InputError) << "several ranks need time to leave";
  EXPECT_EQ(time_limit_s("7", nullptr, 0, 4), 7);
}

TEST(TimeLimit, mistakes_are_told_with_what_is_allowed) {
  for (const char* text :
       {"0",     "-5",     "soon",          "1:3",   "1:60", "1:2:3",     "1:60:00", "0:00:00", "::", "1:00:00:00",
        "1e9",   "inf",    "nan",           "5 ",    "s",    "5d",        "-",       "1-",      "-1", "1-1:2",
        "1-1-1", "1.5:00", "1-00:00:00:00", "1-12m", "0-00", "unlimited?"}) {
    try {
      parse_time_limit(text);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(),
                std::string("--time-limit: found ") + text +
                    ", allowed: seconds, 90s, 90m, 2h, MM:SS, HH:MM:SS, D-HH, D-HH:MM, D-HH:MM:SS, UNLIMITED or "
                    "INFINITE, more than 0");
    }
  }
}

TEST(TimeLimit, that_is_empty_is_a_mistake) {
  try {
    time_limit_s("", "1700000100", 1700000000, 0);
    ADD_FAILURE() << "taken for none";
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("--time-limit: found an empty text, allowed: ")) << error.what();
  }
}

TEST(TimeLimit, of_a_slurm_job_that_is_too_short_is_told) {
  EXPECT_EQ(short_limit_warning(3, 4),
            "the Slurm job ends in 3 s, and 6 s are reserved for the checkpoint, the files and the end of the ranks: "
            "nothing will be computed; "
            "give the job more time (sbatch --time)");
  EXPECT_NE(short_limit_warning(2, 0), "");
  EXPECT_EQ(short_limit_warning(3, 0), "");
  EXPECT_EQ(short_limit_warning(std::numeric_limits<double>::infinity(), 4), "");
}

TEST(TimeLimit, is_that_of_the_slurm_job_if_none_is_given) {
  EXPECT_EQ(time_limit_s("50", "1700000100", 1700000000, 0), 50);
  EXPECT_EQ(time_limit_s({}, "1700000100", 1700000000, 0), 100);
  EXPECT_TRUE(std::isinf(time_limit_s({}, nullptr, 1700000000, 0)));
  EXPECT_TRUE(std::isinf(time_limit_s({}, "", 1700000000, 0)));
  EXPECT_TRUE(std::isinf(time_limit_s({}, "Unknown", 1700000000, 0)));
  EXPECT_TRUE(std::isinf(time_limit_s({}, "1600000000", 1700000000, 0))) << "long over: not this job's";
}

TEST(TimeLimit, leaves_time_for_the_files) {
  EXPECT_EQ(reserve_s(5), 2);
  EXPECT_EQ(reserve_s(100), 5);
  EXPECT_EQ(reserve_s(86400), 20);
}

TEST(TimeLimit, counts_on_a_round_as_long_as_the_longest) {
  TimeLimit limit(2.4);
  EXPECT_FALSE(limit.near());
  std::this_thread::sleep_for(std::chrono::milliseconds(220));
  EXPECT_TRUE(limit.near()) << "0.2 s left beside the reserve, and the last round took as long";
  EXPECT_FALSE(TimeLimit().near());
}

TEST(TimeLimit, remembers_the_longest_round) {
  TimeLimit limit(3);
  limit.near();
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  limit.near();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_TRUE(limit.near()) << "0.4 s left beside the reserve, and the round before the last took 0.6";
}

TEST(TimeLimit, keeps_time_to_leave) {
  EXPECT_FALSE(TimeLimit(60).must_end_round(50));
  EXPECT_TRUE(TimeLimit(60).must_end_round(58));
  EXPECT_FALSE(TimeLimit(60).must_end_drawing(58));
  EXPECT_TRUE(TimeLimit(60).must_end_drawing(59.5));
}

TEST(TimeLimit, ends_drawing_a_second_early) {
  EXPECT_TRUE(TimeLimit(1).must_end_drawing(0));
  EXPECT_FALSE(TimeLimit(60).must_end_drawing(0));
  EXPECT_FALSE(TimeLimit().must_end_drawing(0));
}

}  // namespace test_time_limit
}  // namespace tessera::cli
