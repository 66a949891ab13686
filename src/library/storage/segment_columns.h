// The models of a library as data sets of its file, one for each segment (segment_layout.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/pad/pad.h"
#include "library/hdf5/hdf5_handles.h"
#include "library/storage/segment_layout.h"
#include "library/storage/segment_reader.h"

namespace tessera {

/// Makes and writes the models of shapes, segment by segment. It holds some 170 MB.
class SegmentWriter {
 public:
  SegmentWriter(hid_t file, const PadParameters& pad);

  /// Adds a shape in the form in which it will be read.
  void append(const Shape& shape, const SegmentOwner& owner);
  /// Writes the last segment. Throws Hdf5Error, like append().
  void finish();

 private:
  void write();

  Hdf5Handle group_;
  PadParameters pad_;
  SegmentKind kind_;
  std::uint32_t segments_ = 0;
  std::vector<ShapeModel> models_;
  std::vector<SegmentOwner> owners_;
};

/// The places of the segments in the file of a library.
struct SegmentPlaces {
  std::vector<std::uint64_t> begins;
  std::uint64_t bytes = 0;
};

/// Finds the segments. Empty where the file has no models, or models of another version; models are then made when shapes
/// are loaded. Throws Hdf5Error where they are damaged.
SegmentPlaces segment_places(hid_t file, const PadParameters& pad, std::uint32_t shapes);

/// The kind of segments that a library file holds: with all smoothing levels.
SegmentKind library_segments(const PadParameters& pad);

}  // namespace tessera
