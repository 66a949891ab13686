// The picture of a result as blocks of a page.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "report/page.h"
#include "result/folder/finished_result.h"

namespace tessera {

/// PictureData of web/src/data.ts for collage.png in the folder; its tiles, of `most_bytes` in all, are appended to the
/// page's blocks. `number`: of the picture on its page. Null, with a warning for the page, where collage.png is
/// missing or damaged. Throws EnvironmentError.
nlohmann::ordered_json picture_data(const std::string& folder, const WholeResult& result, std::size_t number,
                                    std::size_t most_bytes, Page& page);

}  // namespace tessera
