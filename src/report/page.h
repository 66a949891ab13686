// A page that shows results: the program's template with data put into it. web/ makes the template.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tessera {

/// kFormat of web/src/data.ts.
inline constexpr int kPageFormat = 1;

/// Bytes beside the data of a page: "outlines", "tile-0-1-0-2" (web/src/data.ts).
struct PageBlock {
  std::string name;
  std::vector<std::uint8_t> bytes;
};

struct Page {
  std::string title;  // any bytes
  std::string json;   // PageData of web/src/data.ts
  std::vector<PageBlock> blocks;
  std::vector<std::string> warnings;  // what the page lacks, and why
};

/// Calls `write` with the parts of the page's HTML, one after the other. Nothing in the data can end the element that it
/// stands in.
void write_page(const Page& page, const std::function<void(std::string_view)>& write);

/// The data and the blocks as JSON: {"data": ..., "blocks": {NAME: base64}}, for a page that is already open.
std::string page_json(const Page& page);

}  // namespace tessera
