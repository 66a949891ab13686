// Lack of memory inside OpenCV is reported like any other lack of memory.
#include "files/lack_of_memory.h"

#include <gtest/gtest.h>

#include <new>
#include <opencv2/core.hpp>

#include "core/base/error.h"

namespace tessera {
namespace test_lack_of_memory {

TEST(LackOfMemory, OfOpenCvIsNamedAndOtherErrorsPass) {
  EXPECT_EQ(with_lack_of_memory_named([] { return 3; }), 3);
  EXPECT_THROW(with_lack_of_memory_named([]() -> int { CV_Error(cv::Error::StsNoMem, "Failed to allocate 1 bytes"); }),
               std::bad_alloc);
  EXPECT_THROW(with_lack_of_memory_named([]() -> int { CV_Error(cv::Error::StsBadArg, "x"); }), cv::Exception);
  EXPECT_THROW(with_lack_of_memory_named([]() -> int { throw InputError("x"); }), InputError);
}

}  // namespace test_lack_of_memory
}  // namespace tessera
