// The methods that the benchmark `blocking` compares: each names the shapes that are most similar to a query.
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
  std::vector<Curve> curves;   // at least one
  double noise_px = 0;         // standard deviation of the curves' noise; 0: unknown
  std::optional<double> size;  // query px for one px of the known masks; nullopt: unknown
};

/// Most shapes that a recogniser names for a query.
inline constexpr std::size_t kMostTold = 10;

class Recogniser {
 public:
  virtual ~Recogniser() = default;

  virtual std::string name() const = 0;
  /// The nearest shapes as indices in the library's list, the best first, at most kMostTold. Several threads may call
  /// it.
  virtual std::vector<std::uint32_t> recognise(const ClippedQuery& query) const = 0;
};

/// A recogniser that compares the query with every shape by a descriptor and names the nearest. It has the descriptor's
/// name.
std::unique_ptr<Recogniser> make_descriptor_recogniser(std::unique_ptr<ShapeDescriptor> descriptor,
                                                       const SilhouetteLibrary& library);

}  // namespace tessera::bench
