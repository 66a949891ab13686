// The paper's Table 2: checks that a typing error would fail.
#include "bench/table2_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tessera::bench {
namespace test_table2_rows {

const Table2Row& row_of(std::string_view figure) {
  const auto rows = table2_rows();
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Table2Row& r) { return r.figure == figure; });
  EXPECT_NE(found, rows.end()) << figure;
  return *found;
}

TEST(Table2Rows, SharesAddUpAndFiguresAreDistinct) {
  std::set<std::string_view> figures;
  for (const Table2Row& row : table2_rows()) {
    EXPECT_TRUE(figures.insert(row.figure).second) << row.figure;
    const int percent = row.prune_percent + row.dock_percent + row.objective_percent + row.merge_percent;
    EXPECT_NEAR(percent, 100, 1) << row.figure << ": they are rounded";
    EXPECT_GT(row.pruned_percent, 99);
  }
  EXPECT_EQ(figures.size(), 10u);
}

TEST(Table2Rows, AsPrinted) {
  EXPECT_EQ(row_of("13a").candidates, 128);
  EXPECT_EQ(row_of("13a").iterations, 334);
  EXPECT_EQ(row_of("13a").total_min, 22.8);
  EXPECT_EQ(row_of("22").candidates, 734);
  EXPECT_EQ(row_of("22").iterations, 1421);
  EXPECT_EQ(row_of("22").total_min, 718.3);
  EXPECT_EQ(row_of("19").pads_per_shape, 50247);
  EXPECT_EQ(row_of("19").docking_choices, "1.1 x 10^9");
  EXPECT_EQ(row_of("1").iterations, 194);
}

TEST(Table2Rows, SumsOfTheColumns) {
  int candidates = 0;
  int pads = 0;
  int iterations = 0;
  double total_min = 0;
  for (const Table2Row& row : table2_rows()) {
    candidates += row.candidates;
    pads += row.pads_per_shape;
    iterations += row.iterations;
    total_min += row.total_min;
  }
  EXPECT_EQ(candidates, 1546);
  EXPECT_EQ(pads, 101152);
  EXPECT_EQ(iterations, 2472);
  EXPECT_NEAR(total_min, 1543.6, 1e-9);
}

}  // namespace test_table2_rows
}  // namespace tessera::bench
