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
  std::size_t most = 10;  ///< outlines that are told
  /// Query units for one unit of the known outlines, or for one px of a library's drawings, where it is known: other sizes are
  /// then not looked for. It helps where little of an outline is seen. Above 1e-120 and below 1e120. It is refused with an Error
  /// where the largest known outline is more than 1e20 times as large as the smallest, and where the library does not know
  /// how large its shapes were drawn.
  std::optional<double> scale = {};
};

struct Recognised {
  std::size_t known = 0;  ///< index of the known outline
  /// How much of the query's length the known outline follows, and how closely: 0 to about 1.
  double similarity = 0;
  /// The same length as a part of the geometric mean of both lengths, the query's and the known outline's: 1 of an outline and
  /// itself. It tells known from unknown.
  double score = 0;
  Similarity query_from_known;
};

/// Known outlines with indexes of their PADs (paper, section 3.3) and of arcs of their boundaries: a query looks at few of them.
class TESSERA_MATCHING_API KnownOutlines {
 public:
  /// `outlines`: at least one. Of each, the closed curve with the largest area and the holes within it are known. Throws
  /// Error, which names the outline, as check() does, and where an outline has no closed curve, no area, or is longer than 8
  /// square roots of its area, or its boundary than 100. An outline takes about 80 KB of memory and about 10 ms of one core.
  explicit KnownOutlines(const std::vector<Outline>& outlines);

  /// All shapes of a library, by their places in it. Throws Error where the file is damaged.
  explicit KnownOutlines(const Library& library);

  ~KnownOutlines();
  KnownOutlines(KnownOutlines&&) noexcept;
  KnownOutlines& operator=(KnownOutlines&&) noexcept;

  std::size_t size() const;

  /// The best known outlines by similarity, the best first, each once; those that the query has nothing in common with are
  /// left out. A query whose best outline has a score below 0.4 is, as a rule, none of them; of a small part of an outline
  /// take less. Open curves may run either way, all the same way. Mirror images are not recognised.
  ///
  /// It computes on all cores that the process may use, in threads that stay; a process that was forked after the first call
  /// cannot use them, and gets an Error. It may be called by several threads at once. Throws Error as check() does.
  std::vector<Recognised> recognise(const Outline& query, const RecogniseSettings& settings = {}) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tessera::matching
