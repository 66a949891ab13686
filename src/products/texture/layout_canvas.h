// A canvas in cells, which repeats both ways, with elements laid on it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "products/texture/photo_cells.h"

namespace tessera {

/// A place of the canvas without an element: not reached by a patch yet, ground of the photo, or a hole.
enum BelowCell : std::uint8_t { kOpen, kLaidGround, kHole };

/// A square of the photo, and where it is laid.
struct Patch {
  cv::Point from;  // its upper left cell in the photo
  cv::Point to;    // and on the canvas
  int side = 1;    // cells

  cv::Point shift() const { return to - from; }
  cv::Rect in_photo() const { return {from, cv::Size(side, side)}; }
};

/// Cells of a canvas, copied into one piece.
struct CanvasPart {
  cv::Mat above;  // CV_32S: 0 where no element lies
  cv::Mat below;  // CV_8U: BelowCell
};

class LayoutCanvas {
 public:
  /// `photo` must outlive it.
  LayoutCanvas(const PhotoCells& photo, cv::Size size);

  cv::Size size() const { return above_.size(); }
  CanvasPart part(const cv::Rect& region) const;
  /// Whether an element may lie where it overlaps others so much: kElementCell for each of its cells that is taken,
  /// kRoomCell for each of the joint round it.
  bool may_overlap(std::size_t element, int overlapped) const;
  /// Whether a copy of the element lies nearer than `distance` to this place of its middle.
  bool has_copy_near(std::size_t element, cv::Point middle, double distance) const;
  /// The number of copies of the element.
  std::size_t uses(std::size_t element) const { return middles_[element].size(); }

  /// Lays the elements whose middles are in the patch, those that overlap least first. Elements that would overlap others
  /// too much are left out.
  void lay(const Patch& patch);
  /// No place is open any more.
  void close();

  /// Takes away all elements whose middles are in this square, until it is laid anew. undo() brings them back.
  void clear(cv::Point corner, int side);
  /// How much better the canvas has become since clear(): kElementCell for each cell in a hole, and all overlaps.
  int gain() const;
  /// Makes the canvas what it was before clear().
  void undo();

  /// A cell of each hole that is wider than a slit.
  std::vector<cv::Point> wide_holes() const;
  /// The elements in the order in which they were laid, moved by multiples of a step.
  std::vector<LaidElement> laid(int step_px) const;

 private:
  struct Instance {
    std::size_t element = 0;
    cv::Point shift;  // cells
    int overlapped = 0;
    bool stands = true;
  };

  /// The state that clear() keeps for undo().
  struct Before {
    cv::Rect region;  // cells that may change
    cv::Mat above, below;
    std::vector<std::size_t> cleared;  // in laid_
    std::size_t laid = 0;              // size of laid_
    int badness = 0;                   // of the region and the cleared elements
  };

  cv::Point wrapped(cv::Point at) const;
  /// Calls visit(box of the canvas, the same box in the region) for all parts of a region, which may reach over an edge.
  template <class Visit>
  void for_each_box(const cv::Rect& region, const Visit& visit) const;
  template <class Visit>
  void for_each_cell(std::size_t element, cv::Point shift, const Visit& visit) const;
  int overlap(std::size_t element, cv::Point shift) const;
  void lay(std::size_t element, cv::Point shift, int overlapped);
  void lay_below(const Patch& patch);
  int holes_in(const cv::Rect& region) const;

  const PhotoCells* photo_;
  cv::Mat above_;  // CV_32S: the index in laid_ of the element that covers a cell, plus 1; 0: none
  cv::Mat below_;  // CV_8U
  std::vector<Instance> laid_;
  std::vector<std::vector<cv::Point>> middles_;  // of each element's copies
  int reach_ = 0;                                // how far an element's cells and joint lie from its middle at most
  Before before_;
};

/// Whether the element's middle is in the patch.
bool has_middle_in(const Patch& patch, const CellElement& element);

}  // namespace tessera
