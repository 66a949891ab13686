// Exact areas of candidates on the free field as it is, some of them computed before they are asked for.
#pragma once

#include <map>
#include <tuple>

#include "core/collage/exact_terms.h"
#include "core/collage/pool.h"
#include "core/shape/shape_source.h"

namespace tessera::master {

class ExactChecks {
 public:
  /// All arguments outlive the checks.
  ExactChecks(ShapeSource& shapes, const FreeField& free, const OpenedField& opened, const PieceSettings& pieces)
      : shapes_(shapes),
        free_(free),
        opened_(opened),
        pieces_(pieces) {}

  ExactAreas areas(const Candidate& candidate);
  /// Never changes what areas() says, only how long that takes.
  void compute_ahead(const Candidate& candidate);
  /// Forgets what depends on the fields within this window, where they have changed.
  void forget(const Window& changed);
  void forget_all() { ahead_.clear(); }

 private:
  using Key = std::tuple<ShapeId, float, float, float, float>;  // shape and pose
  struct Known {
    Window window;  // of the nodes that the areas depend on
    ExactAreas areas;
  };
  static Key key_of(const Candidate& candidate);
  ExactAreas compute(const Candidate& candidate);

  ShapeSource& shapes_;
  const FreeField& free_;
  const OpenedField& opened_;
  const PieceSettings& pieces_;
  std::map<Key, Known> ahead_;
};

}  // namespace tessera::master
