#include "artwork/artwork_render.h"

#include "artwork/images/alpha.h"
#include "artwork/open_artwork_page.h"
#include "core/base/error.h"
#include "files/regular_file.h"

namespace tessera {

cv::Mat render_artwork(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px,
                       Background background) {
  if (longest_side_px < 1 || longest_side_px > kMaxArtworkSide_px) {
    throw InputError(path + ": cannot be drawn " + std::to_string(longest_side_px) + " px large; allowed are 1 to " +
                     std::to_string(kMaxArtworkSide_px));
  }
  const std::unique_ptr<ArtworkPage> page = open_artwork_page(bytes, path, background);
  const cv::Rect whole({0, 0}, page_size_px(*page, longest_side_px));
  cv::Mat drawing = page->draw(longest_side_px, whole);
  straighten(drawing);
  return drawing;
}

std::vector<std::uint8_t> read_artwork_file(const std::string& path) {
  return read_regular_file(path, kMaxArtworkFileBytes);
}

}  // namespace tessera
