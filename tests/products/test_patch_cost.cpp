// The cost of a patch is what its definition says, cell by cell.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "products/random_labels.h"
#include "products/texture/patch_cost.h"
#include "products/texture/photo_cells.h"

namespace tessera {
namespace test_patch_cost {

const cv::Size kCanvas(40, 44);
constexpr double kUseCost = 0.5;

Patch random_patch(const PhotoCells& photo, int side) {
  return {{*rc::gen::inRange(0, photo.cells.cols - side + 1), *rc::gen::inRange(0, photo.cells.rows - side + 1)},
          {*rc::gen::inRange(0, kCanvas.width), *rc::gen::inRange(0, kCanvas.height)},
          side};
}

/// What becomes of the elements of a patch.
struct Fates {
  std::map<int, int> overlapped;  // of each number that cells or joints show
  double uses = 0, stand = 0, near = 0;
  std::map<int, bool> stands;
};

Fates fates_in(const PhotoCells& photo, const LayoutCanvas& canvas, const Patch& patch, const CanvasPart& part) {
  Fates fates;
  for (int y = 0; y < patch.side; ++y) {
    for (int x = 0; x < patch.side; ++x) {
      const int cell = photo.cells.at<int>(patch.from + cv::Point(x, y));
      const int room = photo.rooms.at<int>(patch.from + cv::Point(x, y));
      const bool is_taken = part.above.at<int>(y, x) > 0;
      if (cell > 0) fates.overlapped[cell] += is_taken ? kElementCell : 0;
      if (cell == kGroundCell && room > 0) fates.overlapped[room] += is_taken ? kRoomCell : 0;
    }
  }
  for (const auto& [number, overlapped] : fates.overlapped) {
    const auto index = std::size_t(number) - 1;
    const CellElement& element = photo.elements[index];
    const bool stands = has_middle_in(patch, element) && canvas.may_overlap(index, overlapped);
    fates.stands[number] = stands;
    if (!stands) continue;
    ++fates.stand;
    fates.uses += double(canvas.uses(index));
    if (canvas.has_copy_near(index, element.middle + patch.shift(), 3 * photo.element_side))
      fates.near += 0.5 * element.area;
  }
  return fates;
}

/// Whether a cell of the canvas would be a hole.
bool is_hole(const PhotoCells& photo, const Patch& patch, Fates& fates, int cell, bool is_taken, int below) {
  if (is_taken || cell == kGroundCell) return false;
  if (cell == kCutCell) return below != kLaidGround;
  if (fates.stands[cell]) return false;
  return has_middle_in(patch, photo.elements[std::size_t(cell) - 1]) || below == kHole;
}

double defined_cost(const PhotoCells& photo, const LayoutCanvas& canvas, const Patch& patch, const CanvasPart& part) {
  Fates fates = fates_in(photo, canvas, patch, part);
  int bad = 0, ground = 0;
  for (int y = 0; y < patch.side; ++y) {
    for (int x = 0; x < patch.side; ++x) {
      const int cell = photo.cells.at<int>(patch.from + cv::Point(x, y));
      ground += cell == kGroundCell;
      const bool is_taken = part.above.at<int>(y, x) > 0;
      bad += is_hole(photo, patch, fates, cell, is_taken, part.below.at<std::uint8_t>(y, x)) ? kElementCell : 0;
    }
  }
  for (const auto& [number, stands] : fates.stands) bad += stands ? fates.overlapped[number] : 0;
  const double cells = double(patch.side) * patch.side;
  const double too_bare = std::max(0., ground - photo.ground_part * cells);
  const double uses = fates.stand > 0 ? kUseCost * fates.uses / fates.stand : 0;
  return (bad + kElementCell * (0.01 * cells + fates.near + too_bare)) * (1 + uses);
}

RC_GTEST_PROP(PatchCost, IsWhatItsDefinitionSays, ()) {
  const LabelRuns labels(test::random_labels({70, 60}));
  const std::vector<PhotoElement> elements = find_elements(labels, {}).elements;
  RC_PRE(!elements.empty());
  const PhotoCells photo = photo_cells({labels, elements, label_roles(labels, elements, 0)});
  LayoutCanvas canvas(photo, kCanvas);
  const int side = *rc::gen::inRange(1, std::min(photo.cells.cols, photo.cells.rows));
  for (int laid = *rc::gen::inRange(0, 5); laid > 0; --laid) canvas.lay(random_patch(photo, side));
  if (*rc::gen::arbitrary<bool>()) canvas.close();
  PatchCost cost(photo, canvas, kUseCost);
  for (int i = 0; i < 5; ++i) {  // it keeps memory between calls
    const Patch patch = random_patch(photo, side);
    const CanvasPart part = canvas.part({patch.to, cv::Size(side, side)});
    RC_ASSERT(cost(patch, CountedPart(part)) == defined_cost(photo, canvas, patch, part));
  }
}

}  // namespace test_patch_cost
}  // namespace tessera
