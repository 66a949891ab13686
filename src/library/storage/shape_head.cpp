#include "library/storage/shape_head.h"

#include <algorithm>
#include <bit>
#include <span>

#include "core/base/digest.h"

namespace tessera {
namespace {

// part of the digest's definition: so many rows of a column are added at a time
constexpr std::size_t kDigestRows = 64;

template <class Element, class Get>
void add_column(const std::vector<ShapeHead>& heads, Digest& digest, Get get) {
  std::vector<Element> column;
  column.reserve(heads.size());
  for (const ShapeHead& head : heads) column.push_back(get(head));
  digest.add_all(std::span<const Element>(column));
}

/// Adds names as the file holds them: filled up with NULs.
void add_names(const std::vector<ShapeHead>& heads, Digest& digest) {
  std::vector<char> names(heads.size() * layout::kNameBytes, '\0');
  for (std::size_t i = 0; i < heads.size(); ++i)
    std::copy(heads[i].name.begin(), heads[i].name.end(), names.begin() + std::ptrdiff_t(i * layout::kNameBytes));
  digest.add_all(std::span<const char>(names));
}

void add_heads(const std::vector<ShapeHead>& heads, Digest& digest) {
  add_names(heads, digest);
  add_column<float>(heads, digest, [](const ShapeHead& head) { return head.perimeter; });
  add_column<float>(heads, digest, [](const ShapeHead& head) { return head.radius; });
  add_column<std::array<float, 3>>(heads, digest, [](const ShapeHead& head) { return head.mean_lab; });
  add_column<PartDigests>(heads, digest, [](const ShapeHead& head) { return head.part_digest; });
}

}  // namespace

std::uint64_t digest_of_heads(const PadParameters& pad, std::size_t shapes,
                              const std::function<std::vector<ShapeHead>(std::size_t begin, std::size_t end)>& heads) {
  Digest digest;
  digest.add(shapes);
  digest.add(std::uint64_t(pad.levels));
  digest.add(std::bit_cast<std::uint32_t>(pad.delta_tau));
  std::vector<std::uint32_t> variant_of;
  bool variants = false;
  for (std::size_t at = 0; at < shapes; at += kDigestRows) {
    const std::vector<ShapeHead> batch = heads(at, std::min(shapes, at + kDigestRows));
    add_heads(batch, digest);
    for (const ShapeHead& head : batch) {
      variants = variants || head.variant_of != variant_of.size();
      variant_of.push_back(head.variant_of);
    }
  }
  if (variants) digest.add_all(std::span<const std::uint32_t>(variant_of));
  return digest.value();
}

}  // namespace tessera
