// The models of a library as data sets of its file, a segment each (segment_layout.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/pad/pad.h"
#include "library/hdf5/hdf5_handles.h"
#include "library/storage/segment_layout.h"
#include "library/storage/segment_reader.h"

namespace tessera {

/// Makes the models of the shapes that are written, segment by segment: some 170 MB are held.
class SegmentWriter {
 public:
  SegmentWriter(hid_t file, const PadParameters& pad);

  /// `shape` as it will be read.
  void append(const Shape& shape, const SegmentOwner& owner);
  /// Writes the last segment. Throws Hdf5Error, as append().
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

/// Where the segments lie in the file of a library of so many shapes.
struct SegmentPlaces {
  std::vector<std::uint64_t> begins;
  std::uint64_t bytes = 0;
};

/// Nothing where the file has no models, or those of another version: then they are made when shapes are loaded. Throws
/// Hdf5Error where they are damaged.
SegmentPlaces segment_places(hid_t file, const PadParameters& pad, std::uint32_t shapes);

/// All smoothing levels.
SegmentKind library_segments(const PadParameters& pad);

}  // namespace tessera
