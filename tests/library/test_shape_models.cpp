// Reading a few shapes of a library at a time gives the same models.
#include <gtest/gtest.h>

#include "core/matching/matching_context.h"
#include "library/storage/library_file.h"
#include "library/storage/shape_models.h"
#include "support/matching_scene.h"
#include "support/scratch_folder.h"

namespace tessera {
namespace test_shape_models {

TEST(ShapeModels, are_read_in_order_from_any_range) {
  constexpr std::size_t kShapes = 200;
  const test::ScratchFolder folder;
  const std::string path = folder.path("many.h5");
  Shape bean = test::shape_from_outline(test::bean_outline(), PadParameters());
  bean.artwork.width_px = bean.artwork.height_px = 600;
  LibraryWriter writer(path, PadParameters());
  for (std::size_t i = 0; i < kShapes; ++i) {
    bean.name = "bean " + std::to_string(i);
    bean.perimeter = 1 + float(i);  // makes the models different
    writer.append(bean);
  }
  writer.finish();

  const LibraryFile library(path);
  const MatchingContext context = make_matching_context(CollageSettings(), kShapes);
  const std::vector<ShapeModel> models = read_models(library, {10, 190}, context);
  ASSERT_EQ(models.size(), 180u);
  for (std::size_t i = 0; i < models.size(); ++i) EXPECT_EQ(models[i].perimeter, 11 + float(i));
  EXPECT_EQ(models.front().levels.size(), context.levels.size());
}

}  // namespace test_shape_models
}  // namespace tessera
