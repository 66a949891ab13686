// One column of a library file: a data set whose first dimension counts rows. Writing appends rows. Reading takes any range
// of rows and touches only the chunks that hold it. Both throw Hdf5Error that names the data set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <vector>

#include "library/hdf5/hdf5_handles.h"
#include "library/storage/library_chunk.h"
#include "library/storage/library_layout.h"

namespace tessera {

/// Creates the data set: in chunks, with checksums, units and a description; shuffled and deflated where the column says
/// so.
class ColumnWriter {
 public:
  ColumnWriter(hid_t file, const layout::Column& column);

  std::size_t rows() const { return rows_; }
  /// `data` holds rows x elements_per_row(column) elements of the column's type, row by row.
  void append(const void* data, std::size_t rows);

 private:
  layout::Column column_;
  Hdf5Handle data_set_;
  std::size_t rows_ = 0;
};

/// Opens the data set of an untrusted file. Refuses anything but such a column: other types or shapes, links or storage
/// outside the file, other filters than our writer's. Every chunk is checked when it is read (library_chunk.h).
class ColumnReader {
 public:
  ColumnReader(hid_t file, const layout::Column& column);
  /// Empty where the file has no data set of this name, like files of older versions.
  static std::optional<ColumnReader> if_present(hid_t file, const layout::Column& column);

  const layout::Column& column() const { return column_; }
  std::size_t rows() const { return rows_; }
  /// The bytes of the column in the file.
  std::uint64_t stored_bytes() const;
  /// The bytes of all rows in memory, as the file declares them; whether the file really holds data for them is not
  /// checked.
  std::uint64_t declared_bytes() const;

  /// Rows [begin, end), 0 <= begin <= end <= rows(). Element is the column's type (char for text).
  template <class Element>
  std::vector<Element> read(std::size_t begin, std::size_t end) const {
    std::vector<Element> data((end - begin) * layout::row_bytes(column_) / sizeof(Element));
    read_into(data.data(), begin, end);
    return data;
  }

 private:
  void read_into(void* data, std::size_t begin, std::size_t end) const;
  std::vector<hsize_t> corner(std::size_t first_row) const;
  const std::vector<std::uint8_t>& chunk(std::size_t first_row) const;

  layout::Column column_;
  Hdf5Handle data_set_;
  std::size_t rows_ = 0;
  std::size_t chunk_rows_ = 0;
  ChunkPacking packing_;
  struct Kept {
    std::size_t first_row;
    std::vector<std::uint8_t> bytes;
  };
  // The latest chunks, latest first: shapes are often read one at a time, in any order, and a chunk holds many.
  mutable std::list<Kept> kept_;
};

}  // namespace tessera
