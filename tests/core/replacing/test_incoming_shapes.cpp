// The shapes that may come into a replacement window.
#include "core/replacing/incoming_shapes.h"

#include <gtest/gtest.h>

#include "core/settings/settings.h"
#include "support/synthetic_library.h"

namespace tessera {
namespace test_incoming_shapes {

const std::vector<Shape>& library() {
  static const std::vector<Shape> shapes = test::synthetic_library(4);
  return shapes;
}

std::vector<ShapeId> ids_of(const std::vector<IncomingShape>& incoming) {
  std::vector<ShapeId> ids;
  for (const IncomingShape& in : incoming) ids.push_back(in.shape);
  return ids;
}

const Box kWindow{{100, 100}, {300, 300}};

/// The shapes that may come in after pieces of 60 px of the given shapes were taken out at this place.
std::vector<ShapeId> let_in(std::vector<std::uint32_t> taken_out, Vec2 at, const Period& period = {}) {
  test::VectorShapes shapes(library());
  std::vector<FormerPiece> not_back;
  for (const std::uint32_t shape : taken_out) not_back.push_back({ShapeId{shape}, {60, 0, at.x, at.y}});
  return ids_of(shapes_for_window(kWindow, incoming_shapes(StanceTable(CollageSettings{}, 4), shapes, 1), not_back,
                                  period, shapes));
}

TEST(IncomingShapes, WhatWasTakenOutThereStaysOut) {
  const std::vector<ShapeId> all = {ShapeId{0}, ShapeId{1}, ShapeId{2}, ShapeId{3}};
  EXPECT_EQ(let_in({}, {200, 200}), all);
  EXPECT_EQ(let_in({1}, {200, 200}), (std::vector{ShapeId{0}, ShapeId{2}, ShapeId{3}}));
  EXPECT_EQ(let_in({1}, {80, 200}).size(), 3u) << "it reached into the window";
  EXPECT_EQ(let_in({1}, {60, 200}), all) << "it lay elsewhere";
  EXPECT_EQ(let_in({1}, {600, 200}, {400, 0}).size(), 3u) << "the image on a seamless canvas";
  EXPECT_EQ(let_in({1, 2}, {200, 200}).size(), 2u);
  EXPECT_EQ(let_in({1, 2, 3}, {200, 200}), all) << "too few would be left";
}

}  // namespace test_incoming_shapes
}  // namespace tessera
