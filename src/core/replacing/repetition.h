// What it costs that drawings repeat themselves, as the eye sees it, which goes by large copies. First by area: an area
// costs a part of itself for each e-fold by which its drawing covers more than an even share; summed over all drawings
// that is how far their shares' entropy is below that of even ones, on a canvas that is covered. Second by nearness: of
// two copies the smaller one's area costs a part that falls to nothing a few of their sizes away.
#pragma once

#include <vector>

#include "core/geometry/period.h"
#include "core/replacing/replacement.h"

namespace tessera {

/// What the area that one drawing covers costs, if each e-fold costs all of it: the integral of ln x, x in even shares.
/// At an even share more of it neither costs nor gains.
double repeated_px2(double area_px2, double even_share_px2);

/// What two pieces of one drawing cost, if those at one place cost all of the smaller one's area and those as far apart
/// as they reach nothing.
double near_px2(const PlacedDrawing& a, const PlacedDrawing& b, float reach_sizes);

/// Of all pieces of a canvas, but for a constant. The same in any order of them.
double repetition_px2(std::vector<PlacedDrawing> pieces, const RepetitionCosts& costs, const Period& period);

/// Of the pieces of a window, as they change.
class Repetition {
 public:
  explicit Repetition(const ReplacementWindow& window);

  /// What one more piece costs.
  double cost_px2(const PlacedDrawing& piece) const;
  /// Of all pieces, but for a constant.
  double energy_px2() const { return energy_px2_; }

  void add(const PlacedDrawing& piece);
  /// One that is there, as it was added.
  void remove(const PlacedDrawing& piece);

 private:
  double drawn_px2(ShapeId drawing) const;
  double of_area_px2(double drawn_px2) const;
  void change_area(ShapeId drawing, double by_px2);
  double of_nearness_px2(const PlacedDrawing& piece) const;

  RepetitionCosts costs_;
  double energy_px2_ = 0;
  std::vector<DrawingArea> drawn_;     // ascending
  std::vector<PlacedDrawing> pieces_;  // ascending by drawing
};

}  // namespace tessera
