#include "files/lack_of_memory.h"

#include <new>
#include <opencv2/core.hpp>

namespace tessera {

int with_lack_of_memory_named(const std::function<int()>& work) try {
  return work();
} catch (const cv::Exception& error) {
  if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
  throw;
}

}  // namespace tessera
