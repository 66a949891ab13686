// Lays pieces of a puzzle one after the other: finds the open places beside laid pieces, appraises them, and follows the
// best arrangements.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "products/puzzle/pieces/piece_matches.h"
#include "products/puzzle/pieces/puzzle_contact.h"
#include "products/puzzle/pieces/puzzle_piece.h"

namespace tessera {

/// A place that a piece may have in one arrangement.
struct PuzzlePlace {
  int piece = 0;
  Similarity pose = {};
  std::vector<Beside> beside = {};  // for each point of its boundary
  float agreement = 0;              // of pictures and boundaries: the sum of see_neighbour()
  float worth = 0;
  int whole_sides = 0;  // matches from corner to corner that led to it; one side may have several
};

struct LaidPiece {
  int piece = 0;
  Similarity pose = {};  // puzzle_from_piece
};

struct Arrangement {
  std::vector<LaidPiece> laid;  // the frame comes first, if there is one
  std::vector<bool> used;       // by piece
  std::vector<PuzzlePlace> places;
  double worth = 0;
  bool frame_is_open = false;  // places along the frame are searched, too
};

/// The least part of a piece's weighted boundary that must touch others in the end. A straight side agrees with any other,
/// so a piece that touches less does not belong there.
inline constexpr float kLeastTouching = 0.2f;

/// Lays pieces. It refers to its arguments, which may change between two calls.
class PuzzleArranger {
 public:
  /// `frame`: the number of the last piece if that is a frame, else -1. `watch` is called often with the number of laid
  /// pieces; what it throws ends the work.
  PuzzleArranger(const std::vector<PuzzlePiece>& pieces, const std::vector<std::vector<PieceMatch>>& matches,
                 const PuzzleScale& scale, int frame, std::function<void(std::size_t)> watch)
      : pieces_(pieces),
        matches_(matches),
        scale_(scale),
        frame_(frame),
        watch_(std::move(watch)) {}

  std::size_t pieces_count() const { return pieces_.size() - (frame_ < 0 ? 0 : 1); }
  PosedPiece posed(const LaidPiece& laid) const { return {&pieces_[std::size_t(laid.piece)], laid.pose}; }
  bool is_frame(const LaidPiece& laid) const { return laid.piece == frame_; }
  LaidPiece frame() const { return {frame_, {}}; }
  const PuzzleScale& scale() const { return scale_; }
  std::vector<PosedPiece> laid_pieces(const Arrangement& in) const;

  /// An arrangement of one piece, or of the frame.
  Arrangement beginning(int first) const;

  /// Lays one more piece. Places that it takes away are removed, places beside it are added.
  void lay(const PuzzlePlace& place, Arrangement& in) const;

  /// Finds all places beside laid pieces, for an arrangement that was not made by lay() alone.
  void find_places(Arrangement& in) const;

  /// Follows `starts`, `width` arrangements at a time, and returns the one with most pieces. With more than one it branches
  /// over places that exclude each other.
  Arrangement followed_to_the_end(std::vector<Arrangement> starts, int width) const;

  /// Settles all pieces along their neighbours; the first one stays.
  void settle_all(Arrangement& in) const;

  /// Takes out pieces of which less than this part of the weighted boundary touches others, until there is no such piece.
  /// The first piece stays.
  void drop_loose(float least_touching, Arrangement& in) const;

  /// Takes out pieces whose boundary has much gap compared with what touches, because they lie where others belong. The
  /// first piece stays.
  void drop_misfits(Arrangement& in) const;

  std::size_t placed(const Arrangement& in) const;

  /// The part of the boundary of all pieces that is beside a narrow gap.
  double gaps(const Arrangement& in) const;

  /// Whether all pieces lie and fit.
  bool whole(const Arrangement& in) const;

  /// The agreement of all pieces. A boundary beside a narrow gap counts more against it than a touching one counts for it.
  double coherence(const Arrangement& in) const;

  /// Calls `watch`.
  void report(const Arrangement& in) const { watch_(placed(in)); }

 private:
  std::vector<PosedPiece> neighbours(const PosedPiece& piece, const Arrangement& in, int but = -1) const;
  /// Parts of a piece's weighted boundary.
  struct Boundary {
    float touching = 0, beside_gaps = 0;
    float agreement = 0;  // from see_neighbour()
  };
  Boundary boundary_of(const LaidPiece& laid, const Arrangement& in) const;
  void settle(PuzzlePlace& place, const std::vector<PosedPiece>& around) const;
  void appraise(PuzzlePlace& place) const;
  bool is_worth_laying(const PuzzlePlace& place) const;
  bool same_place(const PuzzlePlace& a, const PuzzlePlace& b) const;
  bool exclude_each_other(const PuzzlePlace& a, const PuzzlePlace& b) const;
  bool joins_a_place(const PuzzlePlace& place, Arrangement& in) const;
  void add_place(PuzzlePlace place, Arrangement& in) const;
  void add_places_beside(const LaidPiece& laid, Arrangement& in) const;
  Arrangement with_open_frame(Arrangement one) const;
  void branch(const Arrangement& one, bool with_excluded, std::vector<Arrangement>& next) const;
  bool same(const Arrangement& a, const Arrangement& b) const;
  void keep_best(std::vector<Arrangement>& all, int width) const;

  const std::vector<PuzzlePiece>& pieces_;
  const std::vector<std::vector<PieceMatch>>& matches_;
  const PuzzleScale& scale_;
  int frame_;
  std::function<void(std::size_t)> watch_;
};

}  // namespace tessera
