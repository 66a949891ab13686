// The checkpoints of one result's folder: checkpoint.h5, and the one before it as checkpoint.previous.h5.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tessera {

class CheckpointFolder {
 public:
  explicit CheckpointFolder(const std::string& folder);

  const std::string& latest() const { return latest_; }
  const std::string& previous() const { return previous_; }
  bool has_latest() const;
  bool has_previous() const;
  bool has_any() const { return has_latest() || has_previous(); }

  /// `bytes` become the latest checkpoint, that one the previous; both are on the disk when this returns. There is
  /// never a moment without a whole checkpoint. Throws EnvironmentError with the reason; the latest one is untouched
  /// then.
  void keep(std::span<const std::uint8_t> bytes) const;

  /// Removes all of them. Throws EnvironmentError.
  void remove() const;

 private:
  void keep_as_previous() const;

  std::string latest_;
  std::string previous_;
};

}  // namespace tessera
