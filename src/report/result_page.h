// The page of one result: its picture, its pieces, what was measured, and its job.
#pragma once

#include <cstddef>
#include <string>

#include "report/page.h"
#include "report/placed_result.h"

namespace tessera {

struct ResultPageSettings {
  std::size_t picture_bytes = 0;  // the most for tiles, before base64
  bool served = false;            // by tessera serve, so that the page can refine
};

/// Reads the result in a folder, finished or not; the page shows no picture where collage.png is missing or damaged. Throws
/// InputError where the folder holds no whole result, or its canvas cannot be read any more; EnvironmentError.
Page result_page(const std::string& folder, const ResultPageSettings& settings);

}  // namespace tessera
