// HDF5 serves one thread at a time.
#pragma once

#include <mutex>

namespace tessera::matching {

/// Held while a library file is read.
class Hdf5Turn {
 public:
  Hdf5Turn() : lock_(mutex_) {}

 private:
  inline static std::mutex mutex_;
  std::lock_guard<std::mutex> lock_;
};

}  // namespace tessera::matching
