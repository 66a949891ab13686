// A library larger than its file: its shapes, then the same mirrored, then stretched and mirrored in other ways.
#pragma once

#include "bench/inputs/shape_variation.h"
#include "core/matching/matcher.h"
#include "core/shape/cached_shapes.h"
#include "library/storage/library_file.h"

namespace tessera::bench {

/// Variation 0 changes nothing, 1 mirrors; the further ones stretch by up to 1.5 both ways, every second one mirrored.
ShapeVariation variation_number(std::uint32_t number);

inline constexpr std::uint32_t kMostVariedShapes = 1'000'000;

/// Of --sizes. Throws InputError.
void check_varied_sizes(const std::vector<std::uint32_t>& sizes);

/// The model of shape `number`, whose outline is that of an earlier one, gets PADs of its own.
void change_pads(ShapeModel& model, std::uint32_t number);

/// Shape i is variation i / n of shape i % n of the file's n. Made when asked for: only outlines are kept of the file.
/// From kDifferent on the outlines come again, and models with other PADs, each element changed by up to a fiftieth: to
/// make a hundred thousand outlines takes 15 minutes of a core, a million some hours.
class VariedShapes : public CachedShapes {
 public:
  explicit VariedShapes(const LibraryFile& library);

  /// Makes the shapes of the range on all cores.
  std::vector<Shape> shapes(const ShapeRange& range) const;
  std::vector<ShapeModel> models(const ShapeRange& range, const MatchingContext& context) const;

  static constexpr std::uint32_t kDifferent = 20'000;

  /// Of the file that they are made of.
  std::uint64_t content_digest() const { return digest_; }

  /// The time spent on making whole shapes for those who asked for one at a time.
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
