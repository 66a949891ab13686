// The part of the library on a device: how many bytes it will be is known before it is made.
#include <gtest/gtest.h>

#include "support/synthetic_library.h"
#include "worker/shard.h"

namespace tessera::worker {
namespace {

TEST(Shard, bytes_are_known_beforehand) {
  const std::vector<Shape> shapes = test::synthetic_library(3);
  for (const float max_scale_px : {40.f, 160.f, 600.f}) {
    CollageSettings settings;
    settings.pieces.max_scale_px = max_scale_px;
    const MatchingContext context = make_matching_context(settings, 3);
    const Shard shard =
        make_shard(make_match_record(context, {0, 3}), context.pad.levels, test::models_of(shapes, context, 0, 3));
    EXPECT_EQ(shard_bytes(context, 3), shard.bytes());
  }
  EXPECT_EQ(shard_bytes(make_matching_context(CollageSettings(), 1), 0), 0u);
}

}  // namespace
}  // namespace tessera::worker
