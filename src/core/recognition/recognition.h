// Finds the shapes of a library that a query shows, wholly or in part: the query's PADs and arcs are looked up in indexes of the library's; each
// pair gives a pose, poses are tried on the query's curves, the best are made better and compared (paper, section 3.3 and
// Figs. 26 and 27).
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
  /// Query units for one px of the library's drawings, where it is known: shapes are then looked for at their drawn scale.
  std::optional<float> query_per_drawn_px;
  std::size_t most = 10;  // shapes that are told
};

struct Recognition {
  ShapeId shape{};
  Similarity query_from_shape;
  /// How much of the query's boundary the shape follows, and how closely: 0 to about 1.
  float similarity = 0;
  float query_length =
      0;  // that the similarity is a part of, query units; the query's without its noise, where that fits better
};
/// The better one first; equal ones by their numbers.
inline bool operator<(const Recognition& a, const Recognition& b) {
  return a.similarity != b.similarity ? a.similarity > b.similarity : a.shape < b.shape;
}

/// The answers in order, of each shape the best one alone.
std::vector<Recognition> best_of_each(std::vector<Recognition> found);

/// The outline of a shape, shape frame.
using OutlineOf = std::function<Outline(ShapeId)>;

/// The `most` best of these shapes, the best first, each once. The answer for several lots of shapes is the best of what
/// each lot gives.
std::vector<Recognition> recognised(const Query& query, const KnownShapes& shapes, const RecognitionSettings& settings,
                                    const OutlineOf& outline_of);

}  // namespace tessera
