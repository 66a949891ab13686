// Finds the shapes of a library that a query shows, wholly or in part. It looks up the query's PADs and arcs in indexes
// of the library; each pair gives a pose. The poses are tested on the query's curves, and the best ones are refined and
// compared (paper, section 3.3 and Figs. 26 and 27).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/geometry/similarity.h"
#include "core/recognition/known_shapes.h"
#include "core/recognition/query.h"

namespace tessera {

struct RecognitionSettings {
  /// Query units for one px of the library's drawings, if known; then shapes are searched at their drawn scale only.
  std::optional<float> query_per_drawn_px;
  std::size_t most = 10;  // largest number of shapes in the answer
};

struct Recognition {
  ShapeId shape{};
  Similarity query_from_shape;
  /// The fraction of the query's boundary that the shape follows, weighted by closeness: 0 to about 1.
  float similarity = 0;
  float query_length = 0;  // of the query that was compared (with or without its noise), query units
};
/// The better answer first; ties go by shape.
inline bool operator<(const Recognition& a, const Recognition& b) {
  return a.similarity != b.similarity ? a.similarity > b.similarity : a.shape < b.shape;
}

/// The answers in order, only the best one of each shape.
std::vector<Recognition> best_of_each(std::vector<Recognition> found);

/// The outline of a shape, shape frame.
using OutlineOf = std::function<Outline(ShapeId)>;

/// The `most` best of these shapes, the best first, each once. For several batches of shapes, the answer is the best of
/// the batches' answers.
std::vector<Recognition> recognised(const Query& query, const KnownShapes& shapes, const RecognitionSettings& settings,
                                    const OutlineOf& outline_of);

}  // namespace tessera
