// The checkpoints in the folder of one result: the latest, checkpoint.h5, and the one before it,
// checkpoint.previous.h5.
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

  /// Stores `bytes` as the latest checkpoint; the latest one so far becomes the previous one. Both are on the disk when
  /// the function returns, and at every moment there is a whole checkpoint. Throws EnvironmentError with the reason;
  /// the latest checkpoint then stays as it was.
  void keep(std::span<const std::uint8_t> bytes) const;

  /// Removes both checkpoints. Throws EnvironmentError.
  void remove() const;

 private:
  void keep_as_previous() const;

  std::string latest_;
  std::string previous_;
};

}  // namespace tessera
