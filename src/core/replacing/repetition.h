// The cost of repeated drawings. It follows the eye, which notices large copies. First, area: an area costs a fraction
// of itself for each e-fold by which its drawing covers more than an even share. Summed over all drawings of a covered
// canvas, this measures how far the entropy of their shares is below that of even shares. Second, nearness: of two
// copies the smaller one's area costs a fraction, which falls to 0 a few of their sizes away.
#pragma once

#include <vector>

#include "core/geometry/period.h"
#include "core/replacing/replacement.h"

namespace tessera {

/// The cost of the area that one drawing covers, if each e-fold costs all of it. It is the integral of ln x, where x is
/// the area in even shares. At an even share a small change neither costs nor gains.
double repeated_px2(double area_px2, double even_share_px2);

/// The cost of two pieces of one drawing. At one place they cost all of the smaller one's area; the cost falls to 0 at
/// a distance of `reach_sizes` mean sizes.
double near_px2(const PlacedDrawing& a, const PlacedDrawing& b, float reach_sizes);

/// The cost of all pieces of a canvas, up to a constant. It does not depend on their order.
double repetition_px2(std::vector<PlacedDrawing> pieces, const RepetitionCosts& costs, const Period& period);

/// Running cost of repeated drawings inside one replacement window.
class Repetition {
 public:
  explicit Repetition(const ReplacementWindow& window);

  /// The additional cost of one more piece.
  double cost_px2(const PlacedDrawing& piece) const;
  /// The cost of all pieces, up to a constant.
  double energy_px2() const { return energy_px2_; }

  void add(const PlacedDrawing& piece);
  /// Removes a piece that was added with exactly these values.
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
