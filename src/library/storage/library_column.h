// One column of a library file: a data set whose first dimension counts rows. Writing appends; reading takes any range
// of rows and touches only the chunks that hold it. Both throw Hdf5Error, which names the data set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "library/hdf5/hdf5_handles.h"
#include "library/storage/library_chunk.h"
#include "library/storage/library_layout.h"

namespace tessera {

/// Creates the data set: chunked, with checksums, units and description; shuffled and deflated where the column says
/// so.
class ColumnWriter {
 public:
  ColumnWriter(hid_t file, const layout::Column& column);

  std::size_t rows() const { return rows_; }
  /// `data` holds rows x elements_per_row(column) elements in the column's type, row by row.
  void append(const void* data, std::size_t rows);

 private:
  layout::Column column_;
  Hdf5Handle data_set_;
  std::size_t rows_ = 0;
};

/// Opens the data set of an untrusted file. Refuses what is not exactly such a column: another type or shape, links or
/// storage outside the file, other filters than our writer's. Every chunk is checked when it is read (library_chunk.h).
class ColumnReader {
 public:
  ColumnReader(hid_t file, const layout::Column& column);
  /// Nothing where the file has no data set of this name, as files of older versions.
  static std::optional<ColumnReader> if_present(hid_t file, const layout::Column& column);

  const layout::Column& column() const { return column_; }
  std::size_t rows() const { return rows_; }
  /// Bytes in the file.
  std::uint64_t stored_bytes() const;
  /// Bytes of all rows in memory; whether there is something behind them is not known yet.
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
  // The latest chunk: shapes are often read one at a time, and a chunk holds many.
  mutable std::size_t kept_row_ = 0;
  mutable std::vector<std::uint8_t> kept_;
};

}  // namespace tessera
