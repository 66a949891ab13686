// A library larger than its file: its shapes, then the same mirrored, then others stretched and mirrored.
#pragma once

#include "bench/inputs/shape_variation.h"
#include "core/matching/matcher.h"
#include "core/shape/cached_shapes.h"
#include "library/storage/library_file.h"

namespace tessera::bench {

/// Variation 0 changes nothing, 1 mirrors. Later ones stretch by up to 1.5 along and across; every second is mirrored.
ShapeVariation variation_number(std::uint32_t number);

inline constexpr std::uint32_t kMostVariedShapes = 1'000'000;

/// Checks --sizes. Throws InputError.
void check_varied_sizes(const std::vector<std::uint32_t>& sizes);

/// Changes the PADs of the model of shape `number`, whose outline is that of an earlier shape.
void change_pads(ShapeModel& model, std::uint32_t number);

/// Shape i is variation i / n of shape i % n in a file of n shapes. Shapes are made when they are asked for; only the
/// outlines of the file are kept. From kDifferent on the same outlines come again, with changed PADs in their models:
/// each element by up to a fiftieth. Making a hundred thousand outlines takes 15 minutes of a core, a million some
/// hours.
class VariedShapes : public CachedShapes {
 public:
  explicit VariedShapes(const LibraryFile& library);

  /// Makes the shapes of the range on all cores.
  std::vector<Shape> shapes(const ShapeRange& range) const;
  std::vector<ShapeModel> models(const ShapeRange& range, const MatchingContext& context) const;

  static constexpr std::uint32_t kDifferent = 20'000;

  /// The digest of the file from which they are made.
  std::uint64_t content_digest() const { return digest_; }

  /// The time spent on making whole shapes that were asked for one at a time.
  double making_s() const { return making_s_; }

 protected:
  Shape load(ShapeId id) override;

 private:
  Shape make(ShapeId id) const;

  std::vector<Shape> outlines_;
  PadParameters pad_;
  std::uint64_t digest_;
  double making_s_ = 0;
};

}  // namespace tessera::bench
