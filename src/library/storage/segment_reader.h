// Reads models, or parts of them, from a library file (segment_layout.h). The file is untrusted: everything that is read is
// checked.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/matching/model_source.h"
#include "files/regular_file.h"
#include "library/storage/segment_layout.h"

namespace tessera {

class SegmentReader {
 public:
  /// `path`: for messages. `begins`: the places of the segments in the file. The last segment holds the rest of `shapes`.
  SegmentReader(std::string path, std::shared_ptr<const FileDescriptor> file, SegmentKind kind, std::uint32_t shapes,
                std::vector<std::uint64_t> begins);

  const SegmentKind& kind() const { return kind_; }

  /// The models of the shapes in `range` with these smoothing levels, which the file must have. `owners`: of these shapes.
  /// Like all functions here, throws InputError that names the file where something is damaged.
  std::vector<ShapeModel> models(const ShapeRange& range, const std::vector<int>& levels, const ModelParts& parts,
                                 std::span<const SegmentOwner> owners) const;
  /// All PADs of each shape, one smoothing level after the other.
  std::vector<LibraryPad> pads(const ShapeRange& range, const std::vector<int>& levels,
                               std::span<const SegmentOwner> owners) const;
  /// Models with boundary, tangents, interior and colours, for consecutive shapes within one segment.
  std::vector<ShapeModel> contours(const ShapeRange& range, std::span<const SegmentOwner> owners) const;
  /// Reads the 2 n + 1 key points of one PAD into `points`.
  void keypoints(ShapeId shape, int level, std::uint32_t sample, const SegmentOwner& owner,
                 ModelSample::Step* points) const;
  /// An order of the PADs of a level, for the shapes of a range within one segment; PADs are numbered shape by shape.
  std::vector<std::uint32_t> pad_order(const ShapeRange& range, int level) const;

 private:
  struct Part;  // the part of a range within one segment
  static std::vector<Part> parts_of(const ShapeRange& range, std::span<const SegmentOwner> owners);

  const SegmentLayout& layout_of(std::uint32_t segment) const;
  std::vector<std::uint8_t> read(std::uint32_t segment, std::size_t at, std::size_t bytes) const;
  void read_into(void* data, std::uint32_t segment, std::size_t at, std::size_t bytes) const;
  template <class Row, class SetRow>
  void add_rows(std::span<ShapeModel> models, const Part& part, std::size_t section_at, SetRow set_row,
                const char* what) const;
  void add_sketches(std::span<ShapeModel> models, const Part& part) const;
  void add_contours(std::span<ShapeModel> models, const Part& part) const;
  void add_level(std::span<ShapeModel> models, const Part& part, int level, bool keypoints) const;
  template <class SetPad>
  void read_pads(const Part& part, int level, SetPad&& set_pad) const;
  [[noreturn]] void fail(const std::string& what) const;
  const LevelSection& section_of(const SegmentLayout& layout, int level) const;

  std::string path_;
  std::shared_ptr<const FileDescriptor> file_;
  SegmentKind kind_;
  std::uint32_t shapes_;
  std::vector<std::uint64_t> begins_;
  SegmentLayout whole_;  // layout of a segment of kSegmentShapes shapes
  SegmentLayout last_;
};

}  // namespace tessera
