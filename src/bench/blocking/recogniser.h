// Who recognises the queries of the benchmark `blocking`.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/blocking/known_silhouettes.h"
#include "bench/descriptors/shape_descriptor.h"
#include "core/recognition/curve.h"

namespace tessera::bench {

struct ClippedQuery {
  std::vector<Curve> curves;   // one at least
  double noise_px = 0;         // standard deviation of the curves' noise, where somebody told it
  std::optional<double> size;  // query px for one px of the known masks, where it is known
};

/// So many shapes are told for a query.
inline constexpr std::size_t kMostTold = 10;

class Recogniser {
 public:
  virtual ~Recogniser() = default;

  virtual std::string name() const = 0;
  /// The nearest shapes, as places in the library's list; the best first, at most kMostTold. Several threads may call
  /// it.
  virtual std::vector<std::uint32_t> recognise(const ClippedQuery& query) const = 0;
};

/// By PADs (core/recognition). The library must outlive it.
std::unique_ptr<Recogniser> make_pad_recogniser(const SilhouetteLibrary& library);

/// By the least distance of a descriptor, whose name is its own: every shape is compared.
std::unique_ptr<Recogniser> make_descriptor_recogniser(std::unique_ptr<ShapeDescriptor> descriptor,
                                                       const SilhouetteLibrary& library);

}  // namespace tessera::bench
