#include "core/matching/matcher.h"

#include <algorithm>
#include <stdexcept>

namespace tessera {

std::uint32_t bin_limit_for(const DistanceHistogram& histogram, std::uint64_t most) {
  std::uint64_t sum = 0;
  for (std::uint32_t bin = 0; bin < kDistanceBins; ++bin) {
    const bool first_pairs = sum == 0;
    sum += histogram[bin];
    if (sum > most && !first_pairs) return bin;
    if (sum > most) return bin + 1;
  }
  return kDistanceBins;
}

void expect_bins_of(std::size_t counted, const std::vector<std::uint32_t>& bins) {
  if (!bins.empty() && bins.size() != counted)
    throw std::logic_error("bins of other samples than those that are counted");
}

RefinedDocking feasible_docking(const Docking& docking, const DockingTerms& terms, const ShapeModel& shape) {
  return {docking, terms, true, extent_of(shape.boundary, docking.canvas_from_shape), shape.perimeter, shape.radius};
}

void rank_by_draw(std::vector<Docking>& dockings) {
  for (Docking& docking : dockings) docking.key = -float(docking.source - kTangentSource);
}

void keep_shortlist(std::vector<Docking>& dockings) {
  std::sort(dockings.begin(), dockings.end(), docks_better);
  if (dockings.size() > kShortlist) dockings.resize(kShortlist);
}

void write_patches(const std::vector<FieldPatch>& patches, Grid<float>& field) {
  for (const FieldPatch& patch : patches) {
    const float* from = patch.value.data();
    for (int y = patch.window.y0; y < patch.window.y1; ++y, from += patch.window.width()) {
      std::copy(from, from + patch.window.width(), field.row(y) + patch.window.x0);
    }
  }
}

FieldPatch read_patch(const Grid<float>& field, const Window& window) {
  FieldPatch patch{window, {}};
  patch.value.reserve(std::size_t(window.width()) * window.height());
  for (int y = window.y0; y < window.y1; ++y) {
    patch.value.insert(patch.value.end(), field.row(y) + window.x0, field.row(y) + window.x1);
  }
  return patch;
}

}  // namespace tessera
