// The limits of this process, as messages name them.
#include "core/base/process_limits.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace tessera {
namespace test_process_limits {

TEST(ProcessLimits, AreToldWhereTheyAreSet) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto text_with = [&](rlim_t bytes) {
    const rlimit limit{bytes, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string text = process_limits();
    setrlimit(RLIMIT_FSIZE, &before);
    return text;
  };
  EXPECT_EQ(text_with(65536).find("; limits of this process: files of 64 KiB (ulimit -f)"), 0u);
  EXPECT_EQ(text_with(rlim_t(5) << 20).find("; limits of this process: files of 5 MiB (ulimit -f)"), 0u);
  EXPECT_EQ(process_limits().find("ulimit -f") == std::string::npos, before.rlim_cur == RLIM_INFINITY);
}

}  // namespace test_process_limits
}  // namespace tessera
