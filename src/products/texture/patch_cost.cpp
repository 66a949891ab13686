#include "products/texture/patch_cost.h"

#include <algorithm>

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
      under_(2 * (photo.elements.size() + kFirstElement)),
      is_seen_(photo.elements.size() + kFirstElement, 0) {}

double PatchCost::operator()(const Patch& patch, const CountedPart& part) {
  count(patch, part);
  int bad = 0, ground = 0;
  double uses = 0, stand = 0, near = 0;
  for (const int thing : seen_) {
    const CellCounts &shown = under_[2 * std::size_t(thing)], &joint = under_[2 * std::size_t(thing) + 1];
    ground += joint.all;
    if (thing == kGroundThing) {
      ground += shown.all;
    } else if (thing == kCutThing) {
      bad += kElementCell * shown.unlaid;
    } else {
      const auto index = std::size_t(thing - kFirstElement);
      const CellElement& element = photo_.elements[index];
      const int overlapped = kElementCell * shown.taken + kRoomCell * joint.taken;
      if (!has_middle_in(patch, element)) {
        bad += kElementCell * shown.hole;
      } else if (!canvas_.may_overlap(index, overlapped)) {
        bad += kElementCell * (shown.all - shown.taken);
      } else {
        bad += overlapped;
        uses += double(canvas_.uses(index));
        ++stand;
        if (canvas_.has_copy_near(index, element.middle + patch.shift(), kApart_elements * photo_.element_side))
          near += kNearCopy * element.area;
      }
    }
  }
  const double cells = double(patch.side) * patch.side;
  const double too_bare = std::max(0., ground - photo_.ground_part * cells);
  return (bad + kElementCell * (kNoise * cells + near + too_bare)) * (1 + (stand > 0 ? use_cost_ * uses / stand : 0));
}

void PatchCost::count(const Patch& patch, const CountedPart& part) {
  for (const int thing : seen_) {
    under_[2 * std::size_t(thing)] = under_[2 * std::size_t(thing) + 1] = {};
    is_seen_[std::size_t(thing)] = 0;
  }
  seen_.clear();
  for (int y = 0; y < patch.side; ++y) {
    const CellRun* runs = photo_.runs.ptr<CellRun>(patch.from.y + y) + patch.from.x;
    const CellCounts* before = part.before(y);
    for (int x = 0, next = 0; x < patch.side; x = next) {
      const CellRun& run = runs[x];
      next = std::min(x + run.length, patch.side);
      const auto slot = std::size_t(run.slot);
      if (!is_seen_[slot / 2]) {
        is_seen_[slot / 2] = 1;
        seen_.push_back(run.slot / 2);
      }
      under_[slot].add(before[x], before[next]);
    }
  }
}

}  // namespace tessera
