#include "render/pieces/sprite_cache.h"

#include <utility>

namespace tessera {
namespace {

constexpr std::size_t kCopies = 3;

}  // namespace

SpriteCache::SpriteCache(std::size_t budget_bytes, Make make) : budget_bytes_(budget_bytes), make_(std::move(make)) {}

std::shared_ptr<const Sprite> SpriteCache::get(std::size_t slot, int side_px) {
  const Key key(slot, side_px);
  const std::size_t most_bytes = kCopies * 4 * std::size_t(side_px) * std::size_t(side_px);
  std::unique_lock lock(mutex_);
  for (;;) {
    const auto found = entries_.find(key);
    if (found != entries_.end() && found->second.sprite) return handed_out(found->second);
    if (found == entries_.end() && make_room(most_bytes)) break;
    changed_.wait(lock);
  }
  entries_[key].bytes = most_bytes;
  bytes_ += most_bytes;
  ++in_use_;
  lock.unlock();
  std::shared_ptr<const Sprite> sprite;
  std::exception_ptr error;
  try {
    sprite = std::make_shared<const Sprite>(make_(slot, side_px));
  } catch (...) {
    error = std::current_exception();
  }
  lock.lock();
  --in_use_;
  bytes_ -= most_bytes;
  changed_.notify_all();
  if (error) {
    entries_.erase(key);
    std::rethrow_exception(error);
  }
  Entry& entry = entries_[key];
  entry.sprite = sprite;
  entry.bytes = sprite->bytes();
  bytes_ += entry.bytes;
  return handed_out(entry);
}

/// Hands out a sprite. When it is given back, threads that wait for room are woken.
std::shared_ptr<const Sprite> SpriteCache::handed_out(Entry& entry) {
  entry.last_use = ++uses_;
  ++in_use_;
  return {entry.sprite.get(), [this, kept = entry.sprite](const Sprite*) mutable {
            const std::lock_guard lock(mutex_);
            kept.reset();
            --in_use_;
            changed_.notify_all();
          }};
}

/// Makes room. A sprite larger than the budget is made when no other is in use.
bool SpriteCache::make_room(std::size_t bytes) {
  while (bytes_ + bytes > budget_bytes_) {
    auto oldest = entries_.end();
    for (auto it = entries_.begin(); it != entries_.end(); ++it) {
      const bool idle = it->second.sprite.use_count() == 1;
      if (idle && (oldest == entries_.end() || it->second.last_use < oldest->second.last_use)) oldest = it;
    }
    if (oldest == entries_.end()) return in_use_ == 0;
    bytes_ -= oldest->second.bytes;
    entries_.erase(oldest);
  }
  return true;
}

}  // namespace tessera
