// The metadata blocks of an HDF5 file, and a change of one with a valid checksum. HDF5 itself has to survive it.
#pragma once

#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// A function of HDF5 that the library exports but does not declare.
extern "C" std::uint32_t H5_checksum_metadata(const void* bytes, std::size_t count, std::uint32_t start);

namespace tessera::test {

/// The begin and the length of a block without its checksum.
using MetadataBlock = std::pair<std::size_t, std::size_t>;

/// Finds object headers, B-trees, heaps and chunk indices, each followed by its checksum.
inline std::vector<MetadataBlock> metadata_blocks(const std::string& file) {
  constexpr std::size_t kLongest = 1500;
  std::vector<MetadataBlock> blocks;
  const auto holds = [&](std::size_t begin, std::size_t count) {
    std::uint32_t stored = 0;
    std::memcpy(&stored, file.data() + begin + count, sizeof stored);
    return stored != 0 && stored == H5_checksum_metadata(file.data() + begin, count, 0);
  };
  for (const char* kind : {"OHDR", "OCHK", "BTHD", "BTIN", "BTLF", "FRHP", "FHDB", "FHIB", "EAHD", "EAIB", "EASB",
                           "EADB", "FAHD", "FADB", "FSHD", "FSSE"}) {
    for (std::size_t at = file.find(kind); at != std::string::npos; at = file.find(kind, at + 4)) {
      for (std::size_t count = 8; count < kLongest && at + count + 4 <= file.size(); ++count) {
        if (!holds(at, count)) continue;
        blocks.emplace_back(at, count);
        break;
      }
    }
  }
  return blocks;
}

/// Changes up to three bytes of a block, and its checksum accordingly.
inline void forge_metadata(std::string& file, const MetadataBlock& block, std::mt19937& random) {
  const auto [begin, count] = block;
  constexpr unsigned char kBytes[] = {0, 1, 0x7f, 0x80, 0xff};
  for (std::size_t i = 1 + random() % 3; i > 0; --i)
    file[begin + 4 + random() % (count - 4)] = char(random() % 2 == 0 ? kBytes[random() % 5] : random());
  const std::uint32_t sum = H5_checksum_metadata(file.data() + begin, count, 0);
  std::memcpy(file.data() + begin + count, &sum, sizeof sum);
}

}  // namespace tessera::test
