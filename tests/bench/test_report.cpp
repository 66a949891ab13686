#include "bench/report.h"
#include "text/text_table.h"

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace tessera::bench {
namespace test_report {

TEST(Report, TableAlignsItsColumns) {
  TextTable table({"", "pieces", "s"});
  table.add({"ours", "12", "0.125"});
  table.add({"the paper", "7", ""});
  EXPECT_EQ(table.text(),
            "           pieces      s\n"
            "ours           12  0.125\n"
            "the paper       7\n");
}

TEST(Report, NumbersOfThreeDigits) {
  EXPECT_EQ(short_number(2164000000.), "2.16e+09");
  EXPECT_EQ(short_number(0.06421), "0.0642");
  EXPECT_EQ(rounded(12.34567), 12.346);
}

TEST(Report, SaysWhereItCannotBeWritten) {
  EXPECT_THROW(write_report({"", {{"benchmark", "none"}}}, "/proc/none.json"), EnvironmentError);
}

}  // namespace test_report
}  // namespace tessera::bench
