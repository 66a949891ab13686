// What it costs that drawings repeat themselves: of n pieces of one drawing each is worth less by the logarithm of n.
#pragma once

#include <cstdint>
#include <map>

#include "core/replacing/replacement.h"

namespace tessera {

class Repetition {
 public:
  explicit Repetition(const ReplacementWindow& window);

  /// Of its area, what one more piece of the drawing costs.
  float cost(ShapeId drawing) const;

  void add(ShapeId drawing) { ++copies_[drawing]; }
  void remove(ShapeId drawing) { --copies_[drawing]; }

 private:
  float cost_;
  std::map<ShapeId, std::uint32_t> copies_;  // on the whole canvas
};

}  // namespace tessera
