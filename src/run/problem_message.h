// The message of rank 0 to all workers about the problem, once they have its job (comm/archive.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include "comm/archive.h"
#include "run/collage_problem.h"

namespace tessera {

/// The part of a problem that comes from files which only rank 0 reads, and the digests of files that every rank reads.
struct ProblemMessage {
  std::uint64_t library_digest = 0;  // of the library's content
  std::uint64_t overlay_digest = 0;  // Job::overlay_digest
  CanvasFindings found;
};

}  // namespace tessera

namespace tessera::comm {

template <class T>
requires kIsOneOf<T, Texel>
inline constexpr bool kSentAsBytes<T> = true;

/// The finest level; the other levels follow from it.
inline Grid<Texel> finest_level(const ColourTarget& colour) {
  const ColourLevel& finest = colour.levels().front();
  Grid<Texel> texels(int(finest.width), int(finest.height));
  std::copy_n(colour.texels().begin(), texels.data().size(), texels.data().begin());
  return texels;
}

template <class T>
requires kIsOneOf<T, SizeMap, Overlays, CanvasFindings, ProblemMessage>
inline constexpr bool kSentByMembers<T> = true;

}  // namespace tessera::comm

namespace boost::serialization {

template <class Archive>
void serialize(Archive& archive, tessera::SizeMap& map, unsigned) {
  auto& [part, cells_per_px] = map;
  tessera::comm::send_members(archive, part, cells_per_px);
}

/// Sends overlays; a level or map without cells means that there is none. The picture that the result keeps is not sent,
/// because rank 0 writes the result.
template <class Archive>
void serialize(Archive& archive, tessera::Overlays& overlays, unsigned) {
  auto& [colour, sizes, shown_png] = overlays;
  tessera::Grid<tessera::Texel> finest;
  float px_per_texel = 0;
  tessera::SizeMap map;
  if constexpr (Archive::is_saving::value) {
    if (colour) finest = tessera::comm::finest_level(*colour);
    if (colour) px_per_texel = colour->px_per_texel();
    if (sizes) map = *sizes;
  }
  tessera::comm::send_members(archive, finest, px_per_texel, map);
  if constexpr (Archive::is_loading::value) {
    colour = finest.data().empty() ? nullptr : std::make_shared<const tessera::ColourTarget>(finest, px_per_texel);
    sizes = map.part.data().empty() ? nullptr : std::make_shared<const tessera::SizeMap>(std::move(map));
  }
}

template <class Archive>
void serialize(Archive& archive, tessera::CanvasFindings& found, unsigned) {
  auto& [size_factor, room_part, overlays] = found;
  tessera::comm::send_members(archive, size_factor, room_part, overlays);
}

template <class Archive>
void serialize(Archive& archive, tessera::ProblemMessage& problem, unsigned) {
  auto& [library_digest, overlay_digest, found] = problem;
  tessera::comm::send_members(archive, library_digest, overlay_digest, found);
}

}  // namespace boost::serialization
