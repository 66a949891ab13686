// Reads and unpacks one chunk of a data set of an untrusted file. HDF5's own filters are not safe for that: they inflate to
// whatever the stored bytes ask for, read past the end of short data, and let the file switch its checksums off.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "library/hdf5/hdf5_handles.h"

namespace tessera {

/// The packing of a data set's chunks. Our writer either shuffles and deflates them or does neither, and always adds a
/// Fletcher-32 checksum.
struct ChunkPacking {
  std::size_t bytes = 0;          // of an unpacked chunk
  std::size_t element_bytes = 1;  // unit of shuffling
  bool deflated = false;
};

/// The chunk that begins at `corner`, exactly packing.bytes bytes. Throws Hdf5Error that names `what` and the chunk's first
/// row, where the chunk is missing, too large, packed in another way, or its checksum is wrong.
std::vector<std::uint8_t> read_chunk(hid_t data_set, std::span<const hsize_t> corner, const ChunkPacking& packing,
                                     const std::string& what);

/// The bytes of the chunk in the file. Each chunk is looked up by itself: HDF5's functions about all chunks
/// (H5Dget_num_chunks, H5Dget_chunk_info, H5Dget_storage_size) walk an index whose length a forged file may declare freely.
std::uint64_t stored_chunk_bytes(hid_t data_set, std::span<const hsize_t> corner, const std::string& what);

/// The checksum as HDF5 computes it (H5Z_FILTER_FLETCHER32).
std::uint32_t fletcher32(std::span<const std::uint8_t> bytes);

}  // namespace tessera
