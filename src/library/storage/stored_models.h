// The models of a library whose file holds them (segment_layout.h). It reads only the parts that a matcher needs.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/matching/matching_context.h"
#include "core/matching/model_source.h"
#include "library/storage/segment_reader.h"

namespace tessera {

class StoredModels : public ModelSource {
 public:
  /// Gives the owners of the shapes [begin, end) of the library.
  using Owners = std::function<std::vector<SegmentOwner>(const ShapeRange&)>;

  /// The reader's segments must have the PADs and levels of the context. `owners` is called once for each range.
  StoredModels(std::shared_ptr<const SegmentReader> segments, const MatchingContext& context, Owners owners);

  std::vector<ShapeModel> models(const ShapeRange& range, const ModelParts& parts) const override;
  std::vector<LibraryPad> pads(const ShapeRange& range) const override;
  std::vector<std::uint32_t> pad_order(const ShapeRange& range, std::size_t level) const override;
  bool supports_random_access() const override { return true; }
  std::vector<ShapeModel> contours(std::span<const ShapeId> shapes) const override;
  std::vector<ModelSample::Step> keypoints(std::span<const PadName> pads) const override;

 private:
  std::shared_ptr<const SegmentReader> segments_;
  std::vector<int> levels_;
  Owners owners_of_;
  /// The owners of these shapes. They are kept for single reads where a matcher asks for consecutive ranges.
  std::vector<SegmentOwner> owners_in(const ShapeRange& range) const;
  std::span<const SegmentOwner> kept_owners(const ShapeRange& range) const;

  mutable std::vector<SegmentOwner> owners_;  // of the shapes from first_owned_ on whose models were read
  mutable std::uint32_t first_owned_ = 0;
};

}  // namespace tessera
