// Runs replacement trials on this rank's cores.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/stop.h"
#include "core/base/task_pool.h"
#include "core/replacing/replacer.h"
#include "core/replacing/window_pieces.h"
#include "core/shape/shape_source.h"

namespace tessera {

class OwnReplacer : public Replacer {
 public:
  /// `shapes` (of the whole library) and `pool` must outlive this object. Only the calling thread reads shapes. It
  /// calls `check_stop`, which may throw, while it reads and while the threads of the pool work.
  OwnReplacer(ShapeSource& shapes, TaskPool& pool, StopCheck check_stop);
  /// Uses a pool of its own with `threads` threads instead of `pool`.
  OwnReplacer(ShapeSource& shapes, int threads, StopCheck check_stop);

  int breadth() const override { return pool_.breadth(); }
  void post_replace(std::vector<ReplacementWindow> windows) override { posted_ = std::move(windows); }
  std::vector<ReplacementOutcome> take_replaced() override;

 private:
  struct Kept {
    HoleShape shape;
    std::uint64_t used = 0;  // number of the last question that needed the shape
  };
  const HoleShape& kept(ShapeId id);
  HoleShapes shapes_of(const std::vector<ReplacementWindow>& windows);
  void forget_some();

  ShapeSource& shapes_;
  std::unique_ptr<TaskPool> own_pool_;
  TaskPool& pool_;
  StopCheck check_stop_;
  std::vector<ReplacementWindow> posted_;
  std::map<ShapeId, Kept> kept_;
  std::uint64_t questions_ = 0;
};

}  // namespace tessera
