// A collage grown round a seed while its time is taken: each shape once (paper, Fig. 28).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/field/canvas.h"
#include "core/settings/settings.h"
#include "core/shape/cached_shapes.h"
#include "master/collage_loop.h"

namespace tessera::bench {

/// Shapes that lie in memory.
class GivenShapes : public CachedShapes {
 public:
  explicit GivenShapes(std::vector<Shape> shapes) : shapes_(std::move(shapes)) {}

  const std::vector<Shape>& all() const { return shapes_; }

 protected:
  Shape load(ShapeId id) override { return shapes_[index_of(id)]; }

 private:
  std::vector<Shape> shapes_;
};

/// What of a collage is the same for all matchers.
struct SeededCollage {
  Canvas canvas;
  CollageSettings settings;
};

/// A square with room for so many shapes, with shape 0 in its middle as the seed. The others, each once, grow round it: they dock to what stands, never to the square's edge. No random dockings, and no improving: who finds no
/// docking by descriptors finds none.
SeededCollage make_seeded_collage(std::size_t shapes);

/// When a method must stop: processor time of this process, and pieces beside the seed.
struct CollageLimits {
  double processor_s = 0;
  int pieces = 0;  // 0: no limit
};

/// Asks whether the time is over.
using TimeIsOver = std::function<std::optional<StopReason>()>;
/// Makes the matcher, which may ask the question while it works. Its time does not count.
using MakeMatcher = std::function<std::unique_ptr<Matcher>(const TimeIsOver&)>;

struct TimedCollage {
  std::unique_ptr<Matcher> matcher;
  std::vector<Placement> placements;                        // the seed first
  double preparation_s = 0;                                 // processor time, before the loop
  double processor_s = 0;                                   // of the loop, all threads
  double wall_s = 0;                                        // of the loop
  std::vector<std::pair<double, std::size_t>> pieces_at_s;  // processor time of the loop, and pieces beside the seed
  RunStatistics statistics;

  std::size_t pieces() const { return placements.size() - 1; }
};

TimedCollage make_timed_collage(const SeededCollage& collage, const CollageSettings& settings, GivenShapes& shapes,
                                const CollageLimits& limits, const MakeMatcher& make);

}  // namespace tessera::bench
