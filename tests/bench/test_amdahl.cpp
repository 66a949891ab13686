// The fit of Amdahl's law.
#include "bench/amdahl.h"

#include <gtest/gtest.h>

namespace tessera::bench {
namespace test_amdahl {

TEST(Amdahl, FindsThePartsThatTheTimesWereMadeOf) {
  const AmdahlFit fit = fit_amdahl({{1, 12}, {2, 7}, {4, 4.5}, {10, 3}});
  EXPECT_NEAR(fit.serial_s, 2, 1e-9);
  EXPECT_NEAR(fit.parallel_s, 10, 1e-9);
  EXPECT_NEAR(fit.serial_share(), 2. / 12, 1e-9);
  EXPECT_NEAR(fit.loop_s(5), 4, 1e-9);
}

TEST(Amdahl, OneNumberOfWorkersSaysNothingOfASerialPart) {
  const AmdahlFit fit = fit_amdahl({{2, 5}, {2, 5}});
  EXPECT_EQ(fit.serial_s, 0);
  EXPECT_NEAR(fit.loop_s(2), 5, 1e-9);
}

}  // namespace test_amdahl
}  // namespace tessera::bench
