// One chunk of a data set of an untrusted file, unpacked by us: HDF5's own filters inflate to whatever the stored bytes
// ask for, read past what is too short, and let the file say that its checksums do not count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "library/hdf5/hdf5_handles.h"

namespace tessera {

/// How the chunks of a data set are packed: as our writer does, shuffled and deflated or neither, with a Fletcher-32
/// checksum in any case.
struct ChunkPacking {
  std::size_t bytes = 0;          // of a chunk when it is unpacked
  std::size_t element_bytes = 1;  // shuffled by these
  bool deflated = false;
};

/// The chunk that begins at `corner`, exactly packing.bytes of it. Throws Hdf5Error that names `what` and the chunk's
/// first row where it is missing, too large, not packed like that, or not what its checksum says.
std::vector<std::uint8_t> read_chunk(hid_t data_set, std::span<const hsize_t> corner, const ChunkPacking& packing,
                                     const std::string& what);

/// How many bytes the chunk has in the file. It is looked up chunk by chunk: HDF5's questions about all of them
/// (H5Dget_num_chunks, H5Dget_chunk_info, H5Dget_storage_size) walk an index whose length a forged file may declare at
/// will.
std::uint64_t stored_chunk_bytes(hid_t data_set, std::span<const hsize_t> corner, const std::string& what);

/// The checksum as HDF5 computes it (H5Z_FILTER_FLETCHER32).
std::uint32_t fletcher32(std::span<const std::uint8_t> bytes);

}  // namespace tessera
