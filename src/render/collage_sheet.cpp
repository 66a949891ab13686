#include "render/collage_sheet.h"

#include <algorithm>
#include <filesystem>
#include <opencv2/core.hpp>

#include "artwork/drawers/drawers.h"
#include "artwork/images/alpha.h"
#include "core/base/count_text.h"
#include "core/base/error.h"
#include "files/regular_file.h"
#include "library/sheet.h"
#include "result/folder/folder_name.h"
#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

constexpr int kCell_px = 320;
constexpr int kCaption_px = 34;  // two lines
constexpr int kMaxColumns = 6;

constexpr std::size_t kMostPictureBytes = std::size_t(512) << 20;
/// Enough for a decoded picture of 20,000 x 20,000 px and its file.
constexpr DrawerSettings kDrawers{.bytes_per_process = std::size_t(2) << 30};

/// The picture shrunk into a cell, in cairo's format (premultiplied BGRA); empty where there is none.
cv::Mat picture(Drawers& drawers, const std::string& folder) {
  const std::string path = fs::path(folder) / "collage.png";
  try {
    return premultiplied(drawers.decode_png(read_regular_file(path, kMostPictureBytes), path, kCell_px));
  } catch (const InputError&) {
    return {};
  }
}

std::vector<cv::Mat> pictures_of(const std::vector<RankedResult>& results, std::size_t count) {
  Drawers drawers(kDrawers);
  std::vector<cv::Mat> pictures;
  for (std::size_t k = 0; k < count; ++k) pictures.push_back(picture(drawers, results[k].card.folder));
  return pictures;
}

/// The layout, with cells as high as the highest picture.
SheetLayout layout_for(const std::vector<cv::Mat>& pictures) {
  int height_px = 1;
  for (const cv::Mat& picture : pictures) height_px = std::max(height_px, picture.rows);
  return make_sheet_layout(pictures.size(), kCell_px, height_px, kCaption_px, kMaxColumns);
}

void draw_picture(const Sheet& sheet, std::size_t cell, const cv::Mat& bgra) {
  const SheetLayout& layout = sheet.layout();
  const int x_px = layout.x_px(cell) + (layout.cell_width_px - bgra.cols) / 2;
  const int y_px = layout.y_px(cell) + (layout.cell_height_px - bgra.rows) / 2;
  cv::Mat pixels = bgra;  // shared; cairo only reads them
  const CairoSurface surface(cairo_image_surface_create_for_data(pixels.data, CAIRO_FORMAT_ARGB32, pixels.cols,
                                                                 pixels.rows, int(pixels.step)));
  cairo_set_source_surface(sheet.cairo(), surface.get(), x_px, y_px);
  cairo_paint(sheet.cairo());
  cairo_set_source_rgb(sheet.cairo(), 0, 0, 0);  // lets go of the surface
}

std::string measures(const Quality& q) {
  return fixed(100 * q.coverage, 1) + " % covered, " + fixed(100 * q.overlap, 2) + " % overlap, " +
         fixed(100 * q.shared_boundary, 0) + " % shared";
}

std::string title(const std::vector<RankedResult>& results, std::size_t shown) {
  std::string text = count_text(results.size(), "collage") + ", best first";
  if (shown < results.size()) text += ", " + std::to_string(shown) + " shown";
  return text;
}

}  // namespace

std::vector<std::uint8_t> collage_sheet(const std::vector<RankedResult>& results, const std::string& path) {
  const std::size_t shown = std::min(results.size(), kMaxSheetCollages);
  const std::vector<cv::Mat> pictures = pictures_of(results, shown);
  const Sheet sheet(layout_for(pictures), title(results, shown));
  for (std::size_t k = 0; k < shown; ++k) {
    const RankedResult& result = results[k];
    if (!pictures[k].empty()) draw_picture(sheet, k, pictures[k]);
    sheet.caption(k, 0,
                  std::to_string(result.rank) + ". " + printable_utf8(folder_name(result.card.folder)) +
                      (is_unfinished(result.card) ? " (unfinished): " : ": ") + fixed(result.score, 2));
    sheet.caption(k, 1, measures(result.card.quality));
  }
  return sheet.png(path);
}

}  // namespace tessera
