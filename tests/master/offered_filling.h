// A collage filled by a matcher that offers the test's candidates.
#pragma once

#include <gtest/gtest.h>

#include "master/filling.h"
#include "offering_matcher.h"

namespace tessera::test {

class OfferedFilling : public testing::Test {
 protected:
  static const std::vector<Shape>& library() {
    static const std::vector<Shape> shapes = synthetic_library(4);
    return shapes;
  }

  static CollageSettings settings() {
    CollageSettings s;
    s.pieces.min_scale_px = 20;
    s.pieces.max_scale_px = 90;
    return s;
  }

  explicit OfferedFilling(const CollageSettings& s = settings(), int width_px = 200, int height_px = 140)
      : canvas_(make_rectangle_canvas(width_px, height_px)),
        context_(make_matching_context(s, std::uint32_t(library().size()))),
        collage_(canvas_, s, context_, shapes_),
        filling_(collage_, context_, s, matcher_, statistics_) {}

  const Canvas canvas_;
  MatchingContext context_;
  VectorShapes shapes_{library()};
  master::Collage collage_;
  OfferingMatcher matcher_{library()};
  RunStatistics statistics_;
  master::Filling filling_;
};

}  // namespace tessera::test
