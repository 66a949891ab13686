// Every shape of the library is matched by exactly one worker, and reading a few at a time gives the same models.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "cli/library_part.h"
#include "core/matching/matching_context.h"
#include "io/library/shape_models.h"
#include "io/scratch_folder.h"
#include "support/matching_scene.h"

namespace tessera::cli {
namespace {

RC_GTEST_PROP(LibraryPart, parts_cover_the_library_evenly, ()) {
  const int shapes = *rc::gen::inRange(1, 1000);
  const int workers = *rc::gen::inRange(1, 40);
  std::uint32_t next = 0;
  for (int worker = 0; worker < workers; ++worker) {
    const ShapeRange part = library_part(std::size_t(shapes), worker, workers);
    RC_ASSERT(part.begin == next);
    RC_ASSERT(int(part.end - part.begin) <= shapes / workers + 1);
    next = part.end;
  }
  RC_ASSERT(next == std::uint32_t(shapes));
}

TEST(LibraryPart, models_are_read_in_order_from_any_range) {
  constexpr std::size_t kShapes = 200;
  const test::ScratchFolder folder;
  const std::string path = folder.path("many.h5");
  Shape bean = test::shape_from_outline(test::bean_outline(), PadParameters());
  bean.artwork.width_px = bean.artwork.height_px = 600;
  io::LibraryWriter writer(path, PadParameters());
  for (std::size_t i = 0; i < kShapes; ++i) {
    bean.name = "bean " + std::to_string(i);
    bean.perimeter = 1 + float(i);  // tells the models apart
    writer.append(bean);
  }
  writer.finish();

  const io::LibraryFile library(path);
  const MatchingContext context = make_matching_context(CollageSettings(), kShapes);
  const std::vector<ShapeModel> models = io::read_models(library, {10, 190}, context);
  ASSERT_EQ(models.size(), 180u);
  for (std::size_t i = 0; i < models.size(); ++i) EXPECT_EQ(models[i].perimeter, 11 + float(i));
  EXPECT_EQ(models.front().levels.size(), context.levels.size());
}

}  // namespace
}  // namespace tessera::cli
