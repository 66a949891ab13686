#include "io/artwork/artwork_render.h"

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "io/artwork/alpha.h"
#include "io/artwork/artwork_page.h"

namespace tessera::io {

cv::Mat render_artwork(std::span<const std::uint8_t> bytes, const std::string& path, int longest_side_px) {
  if (longest_side_px < 1 || longest_side_px > kMaxArtworkSide_px) {
    throw InputError(path + ": cannot be drawn " + std::to_string(longest_side_px) + " px large; allowed are 1 to " +
                     std::to_string(kMaxArtworkSide_px));
  }
  const std::unique_ptr<ArtworkPage> page = open_artwork_page(bytes, path);
  const cv::Rect whole({0, 0}, page_size_px(*page, longest_side_px));
  return straightened(page->draw(longest_side_px, whole));
}

std::vector<std::uint8_t> read_artwork_file(const std::string& path) {
  std::error_code error;
  // A pipe or device would block or never end.
  if (!std::filesystem::is_regular_file(path, error)) throw InputError(path + ": not a readable file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw InputError(path + ": " + error.message());
  if (size > kMaxArtworkFileBytes) {
    throw InputError(path + ": " + std::to_string(size >> 20) + " MiB, more than the " +
                     std::to_string(kMaxArtworkFileBytes >> 20) + " MiB allowed");
  }
  std::vector<std::uint8_t> bytes(size);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
  if (!file) throw InputError(path + ": cannot be read");
  return bytes;
}

}  // namespace tessera::io
