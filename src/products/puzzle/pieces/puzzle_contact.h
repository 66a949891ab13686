// Compares the boundaries of two puzzle pieces, and finds the best pose of a piece between laid ones.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/similarity.h"
#include "products/puzzle/pieces/puzzle_piece.h"

namespace tessera {

/// The neighbourhood of a point of a piece's boundary; with several neighbours the largest value counts.
enum class Beside : std::uint8_t { nothing, gap, contact };

struct PosedPiece {
  const PuzzlePiece* piece = nullptr;
  Similarity pose;  // puzzle_from_piece; for a frame the identity
};

/// `there * here`: applies `here` first.
Similarity followed_by(const Similarity& here, const Similarity& there);

/// The inverse of a rotation and a shift.
Similarity rigid_inverse(const Similarity& pose);

/// Whether one piece can touch the other.
bool may_touch(const PosedPiece& a, const PosedPiece& b, float reach);

/// Whether a point lies in the piece; for a frame, in the area around it.
bool covers(const PosedPiece& piece, Vec2 p);

/// Whether they overlap by more than the errors of their outlines.
bool overlap(const PosedPiece& a, const PosedPiece& b, const PuzzleScale& scale);

/// The distance from the edges, which are blurred, at which pictures are compared.
float inside_from_edge(const PuzzleScale& scale);

/// How well the pictures of two pieces agree beside a point of their common boundary, each a little inside its own piece:
/// from 1, where one continues the other, to -1, for unrelated pictures. 0: unknown. The directions point outward and have
/// unit length.
float pictures_agree(const PuzzlePiece& here, Vec2 at_here, Vec2 outside_here, const PuzzlePiece& there, Vec2 at_there,
                     Vec2 outside_there, const PuzzleScale& scale);

/// Raises `beside`, one for each point of `piece`, by what `neighbour` is to it. Returns how well the pictures agree and
/// how close the boundaries are along the points in contact, as a sum over them.
float see_neighbour(const PosedPiece& piece, const PosedPiece& neighbour, const PuzzleScale& scale,
                    std::vector<Beside>& beside);

/// The piece's pose shifted, and turned about its centre by an angle with that tangent.
Similarity moved(const PosedPiece& piece, Vec2 shift, double turn);

/// The near pose in which the boundary lies best along those of the neighbours: least squares of the distances in
/// Gauss-Newton steps. It does not slide along straight lines.
Similarity settled(PosedPiece piece, const std::vector<PosedPiece>& neighbours, const PuzzleScale& scale, int steps);

}  // namespace tessera
