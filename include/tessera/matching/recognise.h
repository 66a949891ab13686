/// @file
/// Recognition: finds the known outlines that a query shows, wholly or in part.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "tessera/matching/export.h"
#include "tessera/matching/library.h"
#include "tessera/matching/outline.h"
#include "tessera/matching/similarity.h"

namespace tessera::matching {

struct RecogniseSettings {
  std::size_t most = 10;  ///< the most outlines that are returned
  /// Query units for one unit of the known outlines, or for one px of a library's drawings. Where it is given, other sizes
  /// are not searched. It helps where the query shows little of an outline. Allowed: above 1e-120 and below 1e120. Throws
  /// Error where the largest known outline is more than 1e20 times as large as the smallest, or where the library does not
  /// know how large its shapes were drawn.
  std::optional<double> scale = {};
};

struct Recognised {
  std::size_t known = 0;  ///< index of the known outline
  /// The part of the query's length that the known outline follows, weighted by closeness: 0 to about 1.
  double similarity = 0;
  /// The same length divided by the geometric mean of the lengths of query and known outline: 1 for an outline and itself.
  /// It tells known from unknown queries.
  double score = 0;
  Similarity query_from_known;
};

/// Known outlines with indexes of their PADs (paper, section 3.3) and of arcs of their boundaries, so that a query is
/// compared with few of them.
class TESSERA_MATCHING_API KnownOutlines {
 public:
  /// `outlines`: at least one. The closed curve of each with the largest area, and the holes within it, become known.
  /// Throws Error that names the outline, like check(), and where an outline has no closed curve or no area, is longer than
  /// 8 square roots of its area, or has a boundary longer than 100. An outline takes about 80 KB of memory and about 10 ms
  /// of one core.
  explicit KnownOutlines(const std::vector<Outline>& outlines);

  /// All shapes of a library, in its order. Throws Error where the file is damaged.
  explicit KnownOutlines(const Library& library);

  ~KnownOutlines();
  KnownOutlines(KnownOutlines&&) noexcept;
  KnownOutlines& operator=(KnownOutlines&&) noexcept;

  std::size_t size() const;

  /// The known outlines that match the query best, by similarity, the best first, each once. Outlines that have nothing in
  /// common with the query are left out. If the best outline has a score below 0.4, the query is usually none of them; take
  /// less for a small part of an outline. Open curves may run in either direction, but all in the same one. Mirror images
  /// are not recognised.
  ///
  /// Computes on all cores that the process may use, in threads that stay. A process that was forked after the first call
  /// cannot use them, and gets an Error. Several threads may call it at once. Throws Error as check() does.
  std::vector<Recognised> recognise(const Outline& query, const RecogniseSettings& settings = {}) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tessera::matching
