// How the boundaries of two puzzle pieces lie to each other, and where a piece lies best between those that stand.
#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/similarity.h"
#include "products/puzzle/pieces/puzzle_piece.h"

namespace tessera {

/// What is beside a point of a piece's boundary; of several neighbours the largest holds.
enum class Beside : std::uint8_t { nothing, gap, contact };

struct PosedPiece {
  const PuzzlePiece* piece = nullptr;
  Similarity pose;  // puzzle_from_piece; of a frame the identity
};

/// `there * here`: first `here`.
Similarity followed_by(const Similarity& here, const Similarity& there);

/// Of a rotation and a shift.
Similarity rigid_inverse(const Similarity& pose);

/// Whether one can touch the other.
bool may_touch(const PosedPiece& a, const PosedPiece& b, float reach);

/// Whether a point lies in it; of a frame in what is round it.
bool covers(const PosedPiece& piece, Vec2 p);

/// Whether they overlap by more than their outlines' errors.
bool overlap(const PosedPiece& a, const PosedPiece& b, const PuzzleScale& scale);

/// How far from their edges, which are blurred, pictures are compared.
float inside_from_edge(const PuzzleScale& scale);

/// How alike the pictures of two pieces are beside a place of their common boundary, each a little inside its own: from
/// 1, as where one goes on in the other, to -1, as of strangers. 0: unknown. The directions point outside, unit length.
float pictures_agree(const PuzzlePiece& here, Vec2 at_here, Vec2 outside_here, const PuzzlePiece& there, Vec2 at_there,
                     Vec2 outside_there, const PuzzleScale& scale);

/// Raises `beside`, one of each point of `piece`, by what `neighbour` is to it. Returns how well the pictures agree and how
/// close the boundaries run along the points that come into contact, as a sum over them.
float see_neighbour(const PosedPiece& piece, const PosedPiece& neighbour, const PuzzleScale& scale,
                    std::vector<Beside>& beside);

/// The piece's pose shifted, and turned about its centre by an angle with that tangent.
Similarity moved(const PosedPiece& piece, Vec2 shift, double turn);

/// The pose near by in which the boundary lies best along those of the neighbours: least squares of the distances,
/// steps of Gauss and Newton. Along straight lines it stays.
Similarity settled(PosedPiece piece, const std::vector<PosedPiece>& neighbours, const PuzzleScale& scale, int steps);

}  // namespace tessera
