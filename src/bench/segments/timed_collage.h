// Grows a collage round a seed and measures the time; each shape is used once (paper, Fig. 28).
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

/// Shapes in memory.
class GivenShapes : public CachedShapes {
 public:
  explicit GivenShapes(std::vector<Shape> shapes) : shapes_(std::move(shapes)) {}

  const std::vector<Shape>& all() const { return shapes_; }

 protected:
  Shape load(ShapeId id) override { return shapes_[index_of(id)]; }

 private:
  std::vector<Shape> shapes_;
};

/// The canvas and the settings that all matchers get.
struct SeededCollage {
  Canvas canvas;
  CollageSettings settings;
};

/// A square with room for this many shapes. Shape 0 lies in its middle as the seed. The others, each once, grow round
/// it: they dock to pieces, never to the square's edge. Only descriptors find dockings: there are no random ones, and
/// the collage is not improved.
SeededCollage make_seeded_collage(std::size_t shapes);

/// The limits of a method: the processor time of this process since its loop began, and the pieces without the seed.
struct CollageLimits {
  double processor_s = 0;
  int pieces = 0;  // 0: no limit
};

/// Returns why a method must stop now; nullopt: it may go on.
using TimeIsOver = std::function<std::optional<StopReason>()>;
/// Makes the matcher, which may ask this function while it works. The time of making it is not counted.
using MakeMatcher = std::function<std::unique_ptr<Matcher>(const TimeIsOver&)>;

struct TimedCollage {
  std::unique_ptr<Matcher> matcher;
  std::vector<Placement> placements;                        // the seed is the first
  double preparation_s = 0;                                 // processor time before the loop
  double processor_s = 0;                                   // of the loop, all threads
  double wall_s = 0;                                        // of the loop
  std::vector<std::pair<double, std::size_t>> pieces_at_s;  // processor time of the loop, and pieces without the seed
  RunStatistics statistics;

  std::size_t pieces() const { return placements.size() - 1; }
};

/// Fills the canvas of `collage` with the matcher and `settings`, until no piece fits or a limit is reached.
TimedCollage make_timed_collage(const SeededCollage& collage, const CollageSettings& settings, GivenShapes& shapes,
                                const CollageLimits& limits, const MakeMatcher& make);

}  // namespace tessera::bench
