// Replacement trials on this rank's cores.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "core/base/stop.h"
#include "core/replacing/replacer.h"
#include "core/replacing/window_pieces.h"
#include "core/shape/shape_source.h"

namespace tessera {

class OwnReplacer : public Replacer {
 public:
  /// `shapes`, of the whole library, outlives it; only the thread that asks reads them. That thread calls `check_stop` while
  /// it reads and again and again while `threads` others (at least 1) work; `check_stop` may throw.
  OwnReplacer(ShapeSource& shapes, int threads, StopCheck check_stop);

  int breadth() const override { return threads_; }
  void post_replace(std::vector<ReplacementWindow> windows) override { posted_ = std::move(windows); }
  std::vector<ReplacementOutcome> take_replaced() override;

 private:
  struct Kept {
    HoleShape shape;
    std::uint64_t used = 0;  // the question that needed it last
  };
  const HoleShape& kept(ShapeId id);
  HoleShapes shapes_of(const std::vector<ReplacementWindow>& windows);
  void forget_some();

  ShapeSource& shapes_;
  int threads_;
  StopCheck check_stop_;
  std::vector<ReplacementWindow> posted_;
  std::map<ShapeId, Kept> kept_;
  std::uint64_t questions_ = 0;
};

}  // namespace tessera
