// The baseline for mosaics without its program: the division of images into tiles, and drawings as images.
#include "bench/baselines/metapixel.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "formula_library.h"
#include "support/scratch_folder.h"

namespace tessera::bench {
namespace test_metapixel {

TEST(TileGrid, HasTheAspectAndTheNumber) {
  const TileGrid grid = tile_grid({1024, 683}, 3000);
  EXPECT_EQ(grid.columns, 67);
  EXPECT_EQ(grid.rows, 45);
  EXPECT_EQ(grid.tile_px, 64);
}

/// The program can read its mosaic again: at most 8192 px each way and 50 million px.
RC_GTEST_PROP(TileGridProperty, IsNeverTooLarge, ()) {
  const cv::Size image(*rc::gen::inRange(1, 8000), *rc::gen::inRange(1, 8000));
  RC_PRE(image.width <= 8 * image.height && image.height <= 8 * image.width);
  const auto pieces = std::size_t(*rc::gen::inRange(1, 60'000));
  const TileGrid grid = tile_grid(image, pieces);
  const double width_px = double(grid.columns) * grid.tile_px, height_px = double(grid.rows) * grid.tile_px;
  RC_ASSERT(grid.columns >= 1 && grid.rows >= 1 && grid.tile_px >= 8);
  RC_ASSERT(width_px <= 8192 && height_px <= 8192 && width_px * height_px <= 50e6);
  if (pieces >= 3000) RC_ASSERT(std::abs(double(grid.columns) * grid.rows / double(pieces) - 1) < 0.06);
}

TEST(Tiles, OutlinesAreNoTiles) {
  const test::FormulaLibrary library(3);
  const test::ScratchFolder folder;
  EXPECT_THROW(write_tiles(LibraryFile(library.path()), "#ffffff", folder.path("")), InputError);
}

}  // namespace test_metapixel
}  // namespace tessera::bench
