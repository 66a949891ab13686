// Keeps sprites within a budget of memory, for several threads.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "render/pieces/sprite.h"

namespace tessera {

/// Each sprite is made once as long as there is room. Otherwise the sprite whose last use is longest ago is dropped, and
/// made again when it is needed. Sprites in use stay.
class SpriteCache {
 public:
  /// Makes a sprite with at most side_px x side_px pixels. Any of the threads calls it, also at the same time with
  /// different arguments. While a sprite is made it counts three times: its drawing and the drawing process' copy of it are
  /// in memory, too.
  using Make = std::function<Sprite(std::size_t slot, int side_px)>;

  SpriteCache(std::size_t budget_bytes, Make make);

  /// Waits until there is room. A thread holds only one sprite at a time, so that some thread can always go on. Throws what
  /// `make` throws.
  std::shared_ptr<const Sprite> get(std::size_t slot, int side_px);

 private:
  using Key = std::pair<std::size_t, int>;
  struct Entry {
    std::shared_ptr<const Sprite> sprite;  // null: it is being made
    std::size_t bytes = 0;
    std::uint64_t last_use = 0;
  };

  std::shared_ptr<const Sprite> handed_out(Entry& entry);
  bool make_room(std::size_t bytes);

  const std::size_t budget_bytes_;
  const Make make_;
  std::mutex mutex_;
  std::condition_variable changed_;  // a sprite was made or given back
  std::map<Key, Entry> entries_;
  std::size_t bytes_ = 0;
  std::size_t in_use_ = 0;
  std::uint64_t uses_ = 0;
};

}  // namespace tessera
