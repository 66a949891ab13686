// Reads the parts of a library file, with one class for each group of columns. All classes throw Hdf5Error where it is
// damaged. read() functions with numbers as result return a digest (part_digest.h) of what they read for each shape.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/shape/shape.h"
#include "library/storage/library_column.h"

namespace tessera {

/// The shapes [begin, end) of the file, and the shapes in memory that are filled from them.
struct ShapeBatch {
  std::size_t begin;
  std::size_t end;
  Shape* shapes;

  std::size_t count() const { return end - begin; }
};

/// Reads names, lengths and colours.
class HeadReader {
 public:
  HeadReader(hid_t file, const layout::Columns& columns);
  void read(const ShapeBatch& range) const;
  std::size_t shapes() const { return name_.rows(); }
  std::vector<const ColumnReader*> columns() const;

 private:
  ColumnReader name_, perimeter_, radius_, mean_lab_;
  std::optional<ColumnReader> colour_spread_, drawn_scale_, colour_grid_;
};

class OutlineReader {
 public:
  OutlineReader(hid_t file, const layout::Columns& columns);
  std::vector<std::uint64_t> read(const ShapeBatch& range) const;
  std::size_t curves() const { return first_point_.rows() - 1; }
  std::size_t points() const { return points_.rows(); }
  std::vector<const ColumnReader*> columns() const { return {&first_curve_, &first_point_, &points_}; }

 private:
  ColumnReader first_curve_, first_point_, points_;
};

class FieldReader {
 public:
  FieldReader(hid_t file, const layout::Columns& columns);
  std::vector<std::uint64_t> read(const ShapeBatch& range) const;
  std::vector<const ColumnReader*> columns() const { return {&distance_, &scale_, &extent_}; }

 private:
  ColumnReader distance_, scale_, extent_;
};

/// Reads one smoothing level.
class LevelReader {
 public:
  LevelReader(hid_t file, const layout::LevelColumns& columns, std::size_t level);
  std::vector<std::uint64_t> read(const ShapeBatch& range, int pad_levels) const;
  std::vector<const ColumnReader*> columns() const {
    return {&points_, &perimeter_, &lengths_, &keypoints_, &convexity_};
  }

 private:
  std::size_t level_;
  ColumnReader points_, perimeter_, lengths_, keypoints_, convexity_;
};

/// Reads some bytes for each shape.
class BytesReader {
 public:
  /// A shape has at most `most` bytes.
  BytesReader(hid_t file, const layout::Column& first, const layout::Column& bytes, std::size_t most);
  void read(const ShapeBatch& range, std::vector<std::uint8_t> Artwork::*target) const;
  std::uint64_t bytes() const { return bytes_.rows(); }
  std::vector<const ColumnReader*> columns() const { return {&first_, &bytes_}; }

 private:
  std::size_t most_;
  ColumnReader first_, bytes_;
};

/// Reads what lies round drawings in their photos.
class SurroundingsReader {
 public:
  SurroundingsReader(hid_t file, const layout::Columns& columns);
  void read(const ShapeBatch& range) const;
  std::uint64_t bytes() const { return png_ ? png_->bytes() : 0; }
  std::vector<const ColumnReader*> columns() const;

 private:
  std::optional<BytesReader> png_;  // libraries of older versions have none
  std::optional<ColumnReader> margin_;
};

/// Reads paths, hash, geometry and thumbnail.
class ArtworkReader {
 public:
  /// `folder`: the present folder of the library.
  ArtworkReader(hid_t file, const layout::Columns& columns, const std::filesystem::path& folder);
  void read(const ShapeBatch& range) const;
  std::vector<const ColumnReader*> columns() const;

 private:
  void read_files(const ShapeBatch& range) const;

  std::filesystem::path folder_;
  ColumnReader path_, size_, centroid_, unit_;
  BytesReader thumbnail_;
  std::optional<ColumnReader> beside_, sha256_, reader_;
};

}  // namespace tessera
