#include "core/replacing/repetition.h"

#include <algorithm>
#include <array>

namespace tessera {
namespace {

/// The natural logarithm of 1, 2, ...; more copies cost no more.
constexpr std::array<float, 16> kLog = {0,          0.6931472f, 1.0986123f, 1.3862944f, 1.6094379f, 1.7917595f,
                                        1.9459101f, 2.0794415f, 2.1972246f, 2.3025851f, 2.3978953f, 2.4849066f,
                                        2.5649494f, 2.6390573f, 2.7080502f, 2.7725887f};

}  // namespace

Repetition::Repetition(const ReplacementWindow& window) : cost_(window.repetition_cost) {
  for (const DrawingUses& uses : window.uses) copies_[uses.drawing] = uses.elsewhere;
  for (const WindowPiece& piece : window.moving) add(piece.drawing);
}

float Repetition::cost(ShapeId drawing) const {
  const auto found = copies_.find(drawing);
  const std::uint32_t copies = found == copies_.end() ? 0 : found->second;
  return cost_ * kLog[std::min<std::size_t>(copies, kLog.size() - 1)];
}

}  // namespace tessera
