#include "products/texture/patch_cost.h"

#include <algorithm>
#include <cstdint>

namespace tessera {
namespace {

/// The part of a patch that may be bad without being much worse than a perfect one.
constexpr double kNoise = 0.01;
/// Copies of an element nearer than so many elements of mean size cost this part of their area.
constexpr double kApart_elements = 3;
constexpr double kNearCopy = 0.5;

}  // namespace

PatchCost::PatchCost(const PhotoCells& photo, const LayoutCanvas& canvas, double use_cost)
    : photo_(photo),
      canvas_(canvas),
      use_cost_(use_cost),
      fates_(photo.elements.size(), kUnseen),
      overlapped_(photo.elements.size()) {}

double PatchCost::operator()(const Patch& patch, const CanvasPart& part) {
  find_fates(patch, part);
  double uses = 0, count = 0, near = 0;
  for (const std::size_t element : seen_) {
    if (fates_[element] != kStands) continue;
    uses += double(canvas_.uses(element));
    ++count;
    const cv::Point middle = photo_.elements[element].middle + patch.shift();
    if (canvas_.has_copy_near(element, middle, kApart_elements * photo_.element_side))
      near += kNearCopy * photo_.elements[element].area;
  }
  const double cells = double(patch.side) * patch.side;
  const double too_bare = std::max(0., ground_ - photo_.ground_part * cells);
  const double bad = badness(patch, part) + kElementCell * (kNoise * cells + near + too_bare);
  for (const std::size_t element : seen_) fates_[element] = kUnseen;
  return bad * (1 + (count > 0 ? use_cost_ * uses / count : 0));
}

/// Finds the elements of the patch, and what would become of them.
void PatchCost::find_fates(const Patch& patch, const CanvasPart& part) {
  seen_.clear();
  ground_ = 0;
  for (int y = 0; y < patch.side; ++y) {
    const int *shown = photo_.cells.ptr<int>(patch.from.y + y) + patch.from.x, *above = part.above.ptr<int>(y);
    const int* rooms = photo_.rooms.ptr<int>(patch.from.y + y) + patch.from.x;
    for (int x = 0; x < patch.side; ++x) {
      ground_ += shown[x] == kGroundCell;
      if (shown[x] <= 0 && rooms[x] == 0) continue;
      const auto element = std::size_t(shown[x] > 0 ? shown[x] : rooms[x]) - 1;
      if (fates_[element] == kUnseen) {
        fates_[element] = has_middle_in(patch, photo_.elements[element]) ? kStands : kOutside;
        overlapped_[element] = 0;
        seen_.push_back(element);
      }
      if (above[x] > 0) overlapped_[element] += shown[x] > 0 ? kElementCell : kRoomCell;
    }
  }
  for (const std::size_t element : seen_) {
    if (fates_[element] == kStands && !canvas_.may_overlap(element, overlapped_[element])) fates_[element] = kSkipped;
  }
}

/// kElementCell for each cell that would be a hole, and all overlaps.
int PatchCost::badness(const Patch& patch, const CanvasPart& part) const {
  int bad = 0;
  for (int y = 0; y < patch.side; ++y) {
    const int *shown = photo_.cells.ptr<int>(patch.from.y + y) + patch.from.x, *above = part.above.ptr<int>(y);
    const int* rooms = photo_.rooms.ptr<int>(patch.from.y + y) + patch.from.x;
    const std::uint8_t* below = part.below.ptr(y);
    for (int x = 0; x < patch.side; ++x) {
      const Fate fate = shown[x] > 0 ? fates_[std::size_t(shown[x]) - 1] : kUnseen;
      if (above[x] > 0) {
        if (fate == kStands) bad += kElementCell;
        if (rooms[x] > 0 && fates_[std::size_t(rooms[x]) - 1] == kStands) bad += kRoomCell;
      } else if (shown[x] == kCutCell) {
        if (below[x] != kLaidGround) bad += kElementCell;
      } else if (fate == kSkipped || (fate == kOutside && below[x] == kHole)) {
        bad += kElementCell;
      }
    }
  }
  return bad;
}

}  // namespace tessera
