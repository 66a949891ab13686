#include <algorithm>
#include <numeric>

#include "bench/blocking/recogniser.h"
#include "core/base/rank_pool.h"

namespace tessera::bench {
namespace {

std::vector<Curve> curves_of(const Outline& outline) {
  std::vector<Curve> curves;
  for (const std::vector<Vec2>& points : outline.curves) curves.push_back({points, true});
  return curves;
}

/// The mean size of the library's shapes, mask px: a common length for all queries and shapes.
double mean_unit_px(const SilhouetteLibrary& library) {
  double sum = 0;
  for (const KnownSilhouette& shape : library.shapes) sum += double(shape.unit_px);
  return sum / double(std::max<std::size_t>(1, library.shapes.size()));
}

class DescriptorRecogniser : public Recogniser {
 public:
  DescriptorRecogniser(std::unique_ptr<ShapeDescriptor> descriptor, const SilhouetteLibrary& library)
      : descriptor_(std::move(descriptor)),
        unit_px_(mean_unit_px(library)),
        own_size_(library.shapes.size()),
        common_size_(library.shapes.size()) {
    parallel_for(library.shapes.size(), [&](std::size_t i) {
      const KnownSilhouette& shape = library.shapes[i];
      const std::vector<Curve> curves = curves_of(shape.outline);
      own_size_[i] = descriptor_->describe(curves, 0);
      common_size_[i] = descriptor_->describe(curves, float(unit_px_ / double(shape.unit_px)));
    });
  }

  std::string name() const override { return descriptor_->name(); }

  std::vector<std::uint32_t> recognise(const ClippedQuery& query) const override {
    const Description wanted = descriptor_->describe(query.curves, query.size ? float(unit_px_ * *query.size) : 0.f);
    const std::vector<Description>& known = query.size ? common_size_ : own_size_;
    std::vector<float> distances;
    for (const Description& description : known) distances.push_back(descriptor_->distance(wanted, description));
    std::vector<std::uint32_t> nearest(known.size());
    std::iota(nearest.begin(), nearest.end(), 0u);
    const std::size_t told = std::min(kMostTold, nearest.size());
    std::partial_sort(nearest.begin(), nearest.begin() + std::ptrdiff_t(told), nearest.end(),
                      [&](std::uint32_t a, std::uint32_t b) {
                        return distances[a] != distances[b] ? distances[a] < distances[b] : a < b;
                      });
    nearest.resize(told);
    return nearest;
  }

 private:
  std::unique_ptr<ShapeDescriptor> descriptor_;
  double unit_px_;
  std::vector<Description> own_size_;     // each shape by its own size
  std::vector<Description> common_size_;  // for queries of a known scale
};

}  // namespace

std::unique_ptr<Recogniser> make_descriptor_recogniser(std::unique_ptr<ShapeDescriptor> descriptor,
                                                       const SilhouetteLibrary& library) {
  return std::make_unique<DescriptorRecogniser>(std::move(descriptor), library);
}

}  // namespace tessera::bench
