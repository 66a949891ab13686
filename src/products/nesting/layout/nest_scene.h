// Pieces on a strip that may overlap while the search separates them: their poses, how deep each two overlap, and the
// weight of that.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "products/nesting/layout/posed_shape.h"

namespace tessera {

struct NestPose {
  int angle = 0;
  NestPoint shift;
};

/// Called for every piece that is moved, by the thread that searches, with NestScene::work. What it throws ends the search.
using NestWatch = std::function<void(std::uint64_t work)>;

class NestScene {
 public:
  /// `shapes` outlives the scene. The scene has no pieces until they are added.
  NestScene(const PosedItems& shapes, double height, double spacing, NestWatch watch = {});

  int size() const { return int(items_.size()); }
  double height() const { return height_; }
  double length() const { return length_; }
  double spacing() const { return spacing_; }
  int item(int piece) const { return items_[std::size_t(piece)]; }
  const NestPose& pose(int piece) const { return poses_[std::size_t(piece)]; }
  const std::vector<NestPose>& poses() const { return poses_; }
  const PosedShape& shape(int item, int angle) const { return (*shapes_)[std::size_t(item)][std::size_t(angle)]; }
  const PosedShape& shape(int piece) const { return shape(item(piece), pose(piece).angle); }
  int angles_of(int item) const { return int((*shapes_)[std::size_t(item)].size()); }
  /// The bounding box of the piece itself in its pose.
  NestBox own_box(int piece) const;

  /// The shifts, from low to high, that keep the shape on the strip. Empty where it is too large by more than rounding
  /// (nest_tuning::kInset); a shape as large as the strip has one place.
  NestBox range(const PosedShape& shape) const;
  /// Whether the shape can lie on the strip.
  bool fits(const PosedShape& shape) const {
    const NestBox free = range(shape);
    return free.low.x <= free.high.x && free.low.y <= free.high.y;
  }

  void set_length(double length) { length_ = length; }
  /// The length up to which the pieces reach in x.
  double used_length() const;

  void add(int item, const NestPose& pose);
  void remove_last();
  /// Sets the poses of all pieces; weights become 1 again.
  void restore(const std::vector<NestPose>& poses);
  void move(int piece, const NestPose& pose);
  /// Moves every piece onto the strip, at another of its angles where it is too long. False where a piece has no such
  /// angle; then nothing changes.
  bool clamp_all();

  /// The weighted overlap of the piece in that pose, or any number above `most` where it is more. Piece -1 is a new piece
  /// of `item`, with all weights 1.
  double cost(int item, int piece, const NestPose& pose, double most);
  double overlap_of(int piece) const;           // in its pose, not weighted
  double weighted_overlap_of(int piece) const;  // in its pose
  double overlap() const;                       // of all pairs, not weighted
  void grow_weights();

  void check_stop() const {
    if (watch_) watch_(work_);
  }
  /// The number of pairs that were compared; a budget counts these.
  std::uint64_t work() const { return work_; }

 private:
  bool clamp(int piece, NestPose& pose) const;
  void near(const PosedShape& shape, NestPoint shift, int but);
  void fill_row(int piece);
  std::size_t at(int a, int b) const { return std::size_t(a) * stride_ + std::size_t(b); }
  void widen(std::size_t pieces);
  void set_box(int piece);

  const PosedItems* shapes_;
  double height_;
  double length_ = 0;
  double spacing_;
  NestWatch watch_;
  std::vector<int> items_;
  std::vector<NestPose> poses_;
  std::vector<double> low_x_, low_y_, high_x_, high_y_;  // bounding boxes of the boundaries
  std::size_t stride_ = 0;
  std::vector<double> overlap_;  // of each two pieces, symmetric
  std::vector<double> weight_;
  std::vector<int> near_;
  std::uint64_t work_ = 0;
};

}  // namespace tessera
