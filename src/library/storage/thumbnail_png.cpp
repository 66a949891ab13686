#include "library/storage/thumbnail_png.h"

#include <algorithm>
#include <string_view>

#include "library/storage/library_layout.h"

namespace tessera {
namespace {

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kHeaderBytes = 13;
constexpr std::size_t kFrameBytes = 12;  // of each chunk: length, kind, checksum

std::uint32_t big_endian(std::span<const std::uint8_t> bytes) {
  return std::uint32_t(bytes[0]) << 24 | std::uint32_t(bytes[1]) << 16 | std::uint32_t(bytes[2]) << 8 | bytes[3];
}

struct Chunk {
  std::string_view kind;
  std::span<const std::uint8_t> content;
};

/// Takes off the first chunk. Where there is none, returns one without a kind.
Chunk take_chunk(std::span<const std::uint8_t>& bytes) {
  if (bytes.size() < kFrameBytes) return {};
  const std::size_t length = big_endian(bytes);
  if (length > bytes.size() - kFrameBytes) return {};
  const Chunk chunk{{reinterpret_cast<const char*>(bytes.data()) + 4, 4}, bytes.subspan(8, length)};
  bytes = bytes.subspan(kFrameBytes + length);
  return chunk;
}

bool is_header(const Chunk& chunk) {
  // Bit depth 8, colour type RGBA, the only compression, the only filtering, not interlaced.
  constexpr std::uint8_t kKind[] = {8, 6, 0, 0, 0};
  if (chunk.kind != "IHDR" || chunk.content.size() != kHeaderBytes) return false;
  const auto is_side = [](std::uint32_t px) { return px >= 1 && px <= std::uint32_t(layout::kMaxThumbnailSide_px); };
  return is_side(big_endian(chunk.content)) && is_side(big_endian(chunk.content.subspan(4))) &&
         std::ranges::equal(chunk.content.subspan(8), kKind);
}

}  // namespace

bool is_thumbnail_png(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kPngSignature.size() || !std::equal(kPngSignature.begin(), kPngSignature.end(), bytes.begin(),
                                                         [](char c, std::uint8_t b) { return std::uint8_t(c) == b; }))
    return false;
  bytes = bytes.subspan(kPngSignature.size());
  if (!is_header(take_chunk(bytes))) return false;
  Chunk chunk = take_chunk(bytes);
  while (chunk.kind == "IDAT") chunk = take_chunk(bytes);
  return chunk.kind == "IEND" && chunk.content.empty() && bytes.empty();
}

}  // namespace tessera
