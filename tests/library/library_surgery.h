// Changes of a library through the HDF5 API: its data sets as they are declared, and chunks packed as the program packs them.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "library/storage/library_chunk.h"
#include "library/storage/library_layout.h"

namespace tessera::test {

using layout::Column;

/// All data sets of a library.
std::vector<Column> all_columns();

/// Opens the file, which must succeed, and lets `change` work on it. Objects that HDF5 cannot make are then missing.
void change_library(const std::string& path, const std::function<void(hid_t)>& change);

struct OpenColumn {
  hid_t set;
  std::vector<hsize_t> dims, chunk;
  hsize_t rows() const { return dims[0]; }
  std::size_t chunk_rows() const { return chunk[0]; }
};

/// Opens the column. The caller closes `set`.
OpenColumn open_column(hid_t file, const Column& column);

ChunkPacking packing_of(const OpenColumn& open, const Column& column);

std::vector<std::uint8_t> deflated(const std::vector<std::uint8_t>& bytes);
std::vector<std::uint8_t> with_checksum(std::vector<std::uint8_t> bytes);
/// Packs `content` as the program would.
std::vector<std::uint8_t> packed(const std::vector<std::uint8_t>& content, const ChunkPacking& packing);

/// Reads the content of the chunk that begins at row `row`, and replaces it by bytes that are stored as they are.
std::vector<std::uint8_t> read_chunk_at(const OpenColumn& open, std::size_t row, const ChunkPacking& packing);
void store_chunk_at(const OpenColumn& open, std::size_t row, const std::vector<std::uint8_t>& bytes,
                    std::uint32_t skipped_filters = 0);

/// Replaces a column by an empty data set of another type, extent or storage. If HDF5 refuses, the column is missing.
void declare_anew(hid_t file, const Column& column, hid_t type, hid_t space, hid_t properties);

}  // namespace tessera::test
