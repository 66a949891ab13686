// What rank 0 tells all workers of the problem, once they have its job (comm/archive.h).
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "comm/archive.h"
#include "run/collage_problem.h"

namespace tessera {

/// The part of a problem that follows from files which rank 0 alone reads, and the digests of what every rank reads.
struct ProblemMessage {
  std::uint64_t library_digest = 0;  // of the library's content
  std::uint64_t overlay_digest = 0;  // Job::overlay_digest
  CanvasFindings found;
};

}  // namespace tessera

namespace tessera::comm {

template <class T>
requires kIsOneOf<T, Texel>
inline constexpr bool kSentAsItLies<T> = true;

/// The finest level alone: the others follow from it.
inline Grid<Texel> finest_level(const ColourTarget& colour) {
  const ColourLevel& finest = colour.levels().front();
  Grid<Texel> texels(int(finest.width), int(finest.height));
  std::copy_n(colour.texels().begin(), texels.data().size(), texels.data().begin());
  return texels;
}

/// An empty grid stands for none.
template <class Archive>
void serialize(Archive& archive, std::shared_ptr<const ColourTarget>& colour) {
  Grid<Texel> finest;
  float px_per_texel = 0;
  if (!Archive::kReads && colour) {
    finest = finest_level(*colour);
    px_per_texel = colour->px_per_texel();
  }
  archive(finest, px_per_texel);
  if constexpr (Archive::kReads)
    colour = finest.data().empty() ? nullptr : std::make_shared<const ColourTarget>(finest, px_per_texel);
}

/// A map without cells stands for none.
template <class Archive>
void serialize(Archive& archive, std::shared_ptr<const SizeMap>& sizes) {
  SizeMap map = !Archive::kReads && sizes ? *sizes : SizeMap();
  auto& [part, cells_per_px] = map;
  archive(part, cells_per_px);
  if constexpr (Archive::kReads)
    sizes = map.part.data().empty() ? nullptr : std::make_shared<const SizeMap>(std::move(map));
}

/// The picture that the result keeps is left out: rank 0 writes the result.
template <class Archive>
void serialize(Archive& archive, Overlays& overlays) {
  auto& [colour, sizes, shown_png] = overlays;
  archive(colour, sizes);
}

template <class Archive>
void serialize(Archive& archive, CanvasFindings& found) {
  auto& [size_factor, room_part, overlays] = found;
  archive(size_factor, room_part, overlays);
}

template <class Archive>
void serialize(Archive& archive, ProblemMessage& problem) {
  auto& [library_digest, overlay_digest, found] = problem;
  archive(library_digest, overlay_digest, found);
}

}  // namespace tessera::comm
