// The file a shape was made from, for the outputs: from the library itself or from where it was at build time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/shape/shape.h"

namespace tessera {

struct ArtworkOriginal {
  std::vector<std::uint8_t> bytes;  // empty where there is none to draw from
  std::string reason;               // then why, in words that are the same for all drawings of this fate
};

/// Why a drawing is not made from its original.
inline constexpr char kOriginalMissing[] =
    "original missing; put the drawings back where they were or beside the library, or build the library again";
inline constexpr char kOriginalChanged[] = "original changed since the library was built";
inline constexpr char kOriginalNoFile[] = "original is no regular file, not readable or too large";
inline constexpr char kOriginalUnknown[] = "library made by an older version: build it again";
inline constexpr char kOriginalReadOtherwise[] =
    "original is turned as its EXIF data say, which the older version that made the library did not do; build the "
    "library "
    "again";

/// The embedded file, else the one at Artwork::path or at Artwork::path_beside_library, but only one whose SHA-256 is
/// that of the build: a library may come from anywhere and name any path, but it cannot know the hash of a file that
/// its maker never had. A collage never fails because someone tidied up the clip art.
ArtworkOriginal artwork_original(const Artwork& artwork);

/// Maps coordinates of the shape as it is drawn to the artwork frame.
Similarity artwork_from_shape(const Artwork& artwork);

/// Curves of a shape as its drawing has them: of a mirror image (Artwork::mirrored) mirrored back. And the other way
/// round.
std::vector<std::vector<Vec2>> as_drawn(const Artwork& artwork, std::vector<std::vector<Vec2>> curves);

}  // namespace tessera
