#include "render/keep_out_strips.h"

#include <algorithm>
#include <cmath>

#include "artwork/images/alpha.h"
#include "render/pieces/cairo_paint.h"

namespace tessera {
namespace {

cv::Rect whole_px(const cv::Rect2d& r) {
  const cv::Point low(int(std::floor(r.x)), int(std::floor(r.y)));
  return {low, cv::Point(int(std::ceil(r.x + r.width)), int(std::ceil(r.y + r.height)))};
}

}  // namespace

KeepOutStrips::KeepOutStrips(const KeepOutDrawing& drawing, double picture_px, cv::Size picture)
    : drawing_(drawing),
      picture_px_(picture_px) {
  if (drawing.page.empty()) return;
  const cv::Rect2d& place = drawing.place_px;
  const cv::Rect2d place_in_picture(place.tl() * picture_px, place.size() * picture_px);
  page_.box = whole_px(place_in_picture) & cv::Rect({0, 0}, picture);
  const float px_of_page = float(place_in_picture.width / drawing.page.cols);
  page_.picture_from_artwork = {px_of_page, 0, float(place_in_picture.x), float(place_in_picture.y)};
  sprite_ = shrunk({premultiplied(drawing.page), 1}, kSupersampling * double(px_of_page));
}

void KeepOutStrips::draw(int top, cv::Mat rows) const {
  const int begin = std::max(top, page_.box.y);
  const int end = std::min(top + rows.rows, page_.box.br().y);
  if (begin >= end) return;
  cv::Mat drawn = draw_rows(page_, sprite_, begin, end);
  if (!drawing_.clip.empty()) {
    const cv::Rect window(page_.box.x, begin, drawn.cols, drawn.rows);
    cut_to(filled_coverage(drawing_.clip, {float(picture_px_), 0, 0, 0}, window), drawn);
  }
  lay_over(drawn, rows(cv::Rect(page_.box.x, begin - top, page_.box.width, end - begin)));
}

}  // namespace tessera
