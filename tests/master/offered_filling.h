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

  explicit OfferedFilling(const CollageSettings& s = settings(), const Canvas& canvas = make_rectangle_canvas(200, 140),
                          const std::vector<Shape>& shapes = library())
      : canvas_(canvas),
        context_(make_matching_context(s, std::uint32_t(shapes.size()))),
        shapes_(shapes),
        collage_(canvas_, s, context_, shapes_),
        matcher_(shapes),
        filling_(collage_, context_, s, matcher_, statistics_) {}

  const Canvas canvas_;
  MatchingContext context_;
  VectorShapes shapes_;
  master::Collage collage_;
  OfferingMatcher matcher_;
  RunStatistics statistics_;
  master::Filling filling_;
};

}  // namespace tessera::test
