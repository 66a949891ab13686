// The HTML template of pages, web/dist/report.html, embedded by the build (cmake/EmbedText.cmake).
#pragma once

#include <string_view>

namespace tessera {

std::string_view page_template();

}  // namespace tessera
