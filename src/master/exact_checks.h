// Exact areas of candidates on the present free field. Some of them are computed before somebody asks for them.
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
  /// Computes the areas before they are needed. It changes how long areas() takes, never what areas() says.
  void compute_ahead(const Candidate& candidate);
  /// Forgets the areas that depend on field nodes within this window, because these have changed.
  void forget(const Window& changed);
  void forget_all() { ahead_.clear(); }

 private:
  using Key = std::tuple<ShapeId, float, float, float, float>;  // shape and pose
  struct Known {
    Window window;  // nodes that the areas depend on
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
