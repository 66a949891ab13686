// Finds the place where a piece overlaps others least.
#pragma once

#include "products/nesting/layout/nest_random.h"
#include "products/nesting/layout/nest_scene.h"

namespace tessera {

struct NestPlace {
  NestPose pose;
  double cost = 0;  // NestScene::cost
};

/// The best place for a piece. It samples places on the whole strip, round the present place and flush with the boxes of
/// others, and moves the best few downhill. The present place where none is better.
NestPlace best_place(NestScene& scene, int piece, NestRandom& random);

/// The best place for a new piece, with `times` as many samples. False where no angle fits onto the strip.
bool place_for_new(NestScene& scene, int item, int times, NestRandom& random, NestPlace& place);

}  // namespace tessera
