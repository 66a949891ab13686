// What it costs that drawings repeat themselves: as the eye goes by large copies, an area costs a part of itself for
// each e-fold by which its drawing covers more than an even share. Summed over all drawings that is how far their
// shares' entropy is below that of even ones, on a canvas that is covered.
#pragma once

#include <vector>

#include "core/replacing/replacement.h"

namespace tessera {

/// What the area that one drawing covers costs, if each e-fold costs all of it: the integral of ln x, x in even shares.
/// At an even share more of it neither costs nor gains.
double repeated_px2(double area_px2, double even_share_px2);

class Repetition {
 public:
  explicit Repetition(const ReplacementWindow& window);

  /// What one more piece of the drawing costs.
  double cost_px2(ShapeId drawing, double scale_px) const;
  /// Of all pieces, but for a constant.
  double energy_px2() const { return energy_px2_; }

  void add(ShapeId drawing, double scale_px) { change(drawing, scale_px * scale_px); }
  void remove(ShapeId drawing, double scale_px) { change(drawing, -scale_px * scale_px); }

 private:
  double area_px2(ShapeId drawing) const;
  void change(ShapeId drawing, double by_px2);

  double cost_;
  double even_share_px2_;
  double energy_px2_ = 0;
  std::vector<DrawingArea> drawn_;  // ascending
};

}  // namespace tessera
