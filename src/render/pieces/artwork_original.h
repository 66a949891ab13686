// Finds the file that a shape was made from: in the library itself, or where it was at build time.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/geometry/similarity.h"
#include "core/shape/shape.h"

namespace tessera {

struct ArtworkOriginal {
  std::vector<std::uint8_t> bytes;  // empty: there is no original to draw from
  std::string reason;               // then the reason, in the same words for all drawings with this reason
};

/// Reasons why a drawing is not made from its original.
inline constexpr char kOriginalMissing[] =
    "original missing; put the drawings back where they were or beside the library, or build the library again";
inline constexpr char kOriginalChanged[] = "original changed since the library was built";
inline constexpr char kOriginalNoFile[] = "original is no regular file, not readable or too large";
inline constexpr char kOriginalUnknown[] = "library made by an older version: build it again";
inline constexpr char kOriginalReadOtherwise[] =
    "original is turned as its EXIF data say, which the older version that made the library did not do; build the "
    "library "
    "again";

/// The embedded file, otherwise the file at Artwork::path or Artwork::path_beside_library, but only if its SHA-256 is that
/// of the build. A library may come from anywhere and name any path, but it cannot know the hash of a file that its maker
/// never had. A missing original is no error: the user may have tidied up the folder.
ArtworkOriginal artwork_original(const Artwork& artwork);

/// Maps coordinates of the drawn shape to the artwork frame.
Similarity artwork_from_shape(const Artwork& artwork);

/// The curves of a shape in the direction of its drawing: for a mirror image (Artwork::mirrored) mirrored back. It works in
/// both directions.
std::vector<std::vector<Vec2>> as_drawn(const Artwork& artwork, std::vector<std::vector<Vec2>> curves);

}  // namespace tessera
