#include "library/storage/library_chunk.h"

#include <zlib.h>

#include <algorithm>
#include <bit>

namespace tessera {
namespace {

static_assert(std::endian::native == std::endian::little, "the columns are used as they lie in the file");

constexpr std::size_t kChecksumBytes = 4;

/// The most bytes that our writer stores: deflating adds a thousandth to bytes that do not shrink.
std::size_t most_stored_bytes(const ChunkPacking& packing) { return packing.bytes + packing.bytes / 500 + 64; }

std::vector<std::uint8_t> stored_bytes(hid_t data_set, std::span<const hsize_t> corner, const ChunkPacking& packing,
                                       const std::string& what) {
  const std::uint64_t size = stored_chunk_bytes(data_set, corner, what);
  if (size == 0) throw Hdf5Error(what + " is missing");
  if (size > most_stored_bytes(packing)) throw Hdf5Error(what + ": more bytes are stored than it can need");
  std::vector<std::uint8_t> stored(size);
  std::uint32_t skipped_filters = 0;
  hdf5_checked(H5Dread_chunk(data_set, H5P_DEFAULT, corner.data(), &skipped_filters, stored.data()), what);
  if (skipped_filters != 0) throw Hdf5Error(what + ": filters are skipped");
  return stored;
}

std::uint32_t little_endian(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | bytes[i];
  return value;
}

/// Checks the checksum at the end and returns the bytes without it.
std::span<const std::uint8_t> checked(std::span<const std::uint8_t> stored, const std::string& what) {
  if (stored.size() < kChecksumBytes) throw Hdf5Error(what + ": it is too short");
  const auto content = stored.first(stored.size() - kChecksumBytes);
  if (fletcher32(content) != little_endian(stored.last(kChecksumBytes)))
    throw Hdf5Error(what + ": the checksum does not agree");
  return content;
}

std::vector<std::uint8_t> inflated(std::span<const std::uint8_t> packed, std::size_t bytes, const std::string& what) {
  std::vector<std::uint8_t> result(bytes);
  uLongf written = uLongf(bytes);
  uLong used = uLong(packed.size());
  const int status = uncompress2(result.data(), &written, packed.data(), &used);
  if (status != Z_OK || written != bytes || used != packed.size())
    throw Hdf5Error(what + ": it does not inflate to its size");
  return result;
}

/// Undoes shuffling, which stores the first byte of every element, then the second byte, and so on.
std::vector<std::uint8_t> unshuffled(const std::vector<std::uint8_t>& shuffled, std::size_t element_bytes) {
  const std::size_t elements = shuffled.size() / element_bytes;
  std::vector<std::uint8_t> result(shuffled.size());
  for (std::size_t b = 0; b < element_bytes; ++b) {
    const std::uint8_t* from = shuffled.data() + b * elements;
    for (std::size_t i = 0; i < elements; ++i) result[i * element_bytes + b] = from[i];
  }
  return result;
}

}  // namespace

std::vector<std::uint8_t> read_chunk(hid_t data_set, std::span<const hsize_t> corner, const ChunkPacking& packing,
                                     const std::string& what) {
  const std::string chunk = what + " is damaged: the chunk of row " + std::to_string(corner[0]);
  const std::vector<std::uint8_t> stored = stored_bytes(data_set, corner, packing, chunk);
  const std::span<const std::uint8_t> content = checked(stored, chunk);
  if (packing.deflated) {
    std::vector<std::uint8_t> bytes = inflated(content, packing.bytes, chunk);
    return packing.element_bytes > 1 ? unshuffled(bytes, packing.element_bytes) : bytes;
  }
  if (content.size() != packing.bytes) throw Hdf5Error(chunk + ": it has another size");
  return {content.begin(), content.end()};
}

std::uint64_t stored_chunk_bytes(hid_t data_set, std::span<const hsize_t> corner, const std::string& what) {
  hsize_t size = 0;
  hdf5_checked(H5Dget_chunk_storage_size(data_set, corner.data(), &size), what);
  return size;
}

std::uint32_t fletcher32(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kWordsUntilOverflow = 360;
  std::uint32_t sum1 = 0, sum2 = 0;
  const auto fold = [](std::uint32_t sum) { return (sum & 0xffff) + (sum >> 16); };
  std::size_t words = bytes.size() / 2;
  const std::uint8_t* at = bytes.data();
  while (words > 0) {
    const std::size_t now = std::min(words, kWordsUntilOverflow);
    for (std::size_t i = 0; i < now; ++i, at += 2) {
      sum1 += std::uint32_t(at[0]) << 8 | at[1];
      sum2 += sum1;
    }
    words -= now;
    sum1 = fold(sum1);
    sum2 = fold(sum2);
  }
  if (bytes.size() % 2 != 0) {
    sum1 += std::uint32_t(*at) << 8;
    sum2 += sum1;
    sum1 = fold(sum1);
    sum2 = fold(sum2);
  }
  return fold(sum2) << 16 | fold(sum1);
}

}  // namespace tessera
