#include "result/erased_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <system_error>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/geometry/rasterise.h"
#include "job/canvas/canvas_file.h"
#include "job/canvas/canvas_page.h"

namespace tessera {
namespace {

constexpr double kTouched_px2 = 4;
constexpr const char* kNeeded =
    "marks over the pieces that are to go, on a transparent or plain page, or painted over a copy of "
    "collage.png";

/// Refuses another aspect than the canvas'. Sizes in px are rounded, which matters most for small pictures.
void check_aspect(const CanvasPage& page, const std::string& where, const Canvas& canvas) {
  constexpr float kRounded = 0.01f;
  const auto near = [](int fitted_px, int side_px) {
    return float(std::abs(fitted_px - side_px)) <= 1 + kRounded * float(side_px);
  };
  if (near(page.width_px, canvas.width_px) && near(page.height_px, canvas.height_px)) return;
  throw InputError(where + ": found another aspect: fitted into the canvas it has " +
                   size_text(page.width_px, page.height_px) +
                   " px, needed: " + size_text(canvas.width_px, canvas.height_px) + ", as collage.png has it");
}

bool is_opaque(const cv::Mat& bgra) {
  cv::Mat alpha;
  cv::extractChannel(bgra, alpha, 3);
  return cv::countNonZero(alpha != 255) == 0;
}

/// 255 where two pages of the same size differ more than by compression. Differences thinner than 3 px do not count.
cv::Mat clearly_different(const cv::Mat& a, const cv::Mat& b) {
  constexpr int kClearly = 64;  // of 255, in one of the channels
  cv::Mat difference;
  cv::absdiff(a, b, difference);
  cv::Mat most;
  cv::reduce(difference.reshape(1, int(difference.total())), most, 1, cv::REDUCE_MAX);
  most = most.reshape(1, difference.rows);
  cv::Mat clearly = most >= kClearly;
  cv::morphologyEx(clearly, clearly, cv::MORPH_OPEN, cv::Mat::ones(3, 3, CV_8U));
  return clearly;
}

/// Draws the pages that are compared.
class Pages {
 public:
  Pages(const Canvas& canvas, const std::string& file)
      : box_(canvas.width_px, canvas.height_px),
        drawers_(canvas_drawer_settings({.width_px = canvas.width_px, .height_px = canvas.height_px, .file = file})) {}

  CanvasPage page(const std::vector<std::uint8_t>& bytes, const std::string& file, Background background) {
    return page_in_box(bytes, file, box_, drawers_, background);
  }

  /// The page of the picture. Empty where there is none or it is too large for artwork: then nothing is compared with it.
  cv::Mat picture(const std::string& file) {
    std::error_code error;
    if (file.empty() || !std::filesystem::exists(file, error)) return {};
    try {
      return page(read_canvas_file(file), file, Background::kept).bgra;
    } catch (const InputError&) {
      return {};
    }
  }

  /// The part of a page that differs from its ground. An opaque page without a plain ground is a photo: all of it, with `is_photo` set.
  Grid<float> shown(const std::vector<std::uint8_t>& bytes, const std::string& file, bool& is_photo) {
    try {
      return mask_coverage(page(bytes, file, Background::cut_out).bgra);
    } catch (const InputError&) {
      is_photo = true;
    }
    const cv::Mat whole = page(bytes, file, Background::kept).bgra;
    return Grid<float>(whole.cols, whole.rows, 1.f);
  }

 private:
  cv::Size box_;
  Drawers drawers_;
};

/// Whether `page` mostly shows the same as the picture. If so, only what differs is left in `shown`.
bool keep_painted_differences(const cv::Mat& page, const cv::Mat& picture, Grid<float>& shown) {
  if (picture.size() != page.size()) return false;
  const cv::Mat differs = clearly_different(page, picture);
  cv::Mat coverage(shown.height(), shown.width(), CV_32F, shown.row(0));
  const cv::Mat is_shown = coverage >= 0.5f;
  if (2 * cv::countNonZero(is_shown & differs) >= cv::countNonZero(is_shown)) return false;
  coverage.setTo(0, ~differs);
  return true;
}

double marked_px2(const Grid<float>& mask, const Outline& outline_px, Vec2 offset, float cells_per_px) {
  std::size_t cells = 0;
  const Similarity cells_from_canvas = scaled({1, 0, offset.x, offset.y}, cells_per_px);
  for (const Span& span : fill_spans(outline_px, cells_from_canvas, mask.bounds())) {
    const float* row = mask.row(span.y);
    cells += std::size_t(std::count_if(row + span.x0, row + span.x1, [](float part) { return part >= 0.5f; }));
  }
  return double(cells) / (double(cells_per_px) * double(cells_per_px));
}

}  // namespace

std::vector<int> pieces_in(const Box& box, const std::vector<PlacedPiece>& pieces) {
  std::vector<int> found;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Vec2 at = pieces[i].canvas_from_shape.translation();
    if (at.x >= box.low.x && at.x <= box.high.x && at.y >= box.low.y && at.y <= box.high.y) found.push_back(int(i));
  }
  return found;
}

ErasingMask erasing_mask(const std::string& file, const std::string& option, const Canvas& canvas,
                         const std::string& picture) {
  const std::string where = option + " " + file;
  const std::vector<std::uint8_t> bytes = read_canvas_file(file, option.c_str());
  Pages pages(canvas, file);
  const CanvasPage page = pages.page(bytes, file, Background::kept);
  check_aspect(page, where, canvas);
  bool is_photo = false;
  Grid<float> shown = pages.shown(bytes, file, is_photo);
  if (!keep_painted_differences(page.bgra, pages.picture(picture), shown) && is_photo) {
    throw InputError(
        where + ": an opaque picture without a plain background that is no copy of collage.png; needed: " + kNeeded);
  }
  ErasingMask mask{coverage_on_canvas(page, shown), is_opaque(page.bgra)};
  const std::vector<float>& cells = mask.cells.data();
  if (std::none_of(cells.begin(), cells.end(), [](float part) { return part >= 0.5f; })) {
    throw InputError(where + ": shows nothing; needed: " + kNeeded);
  }
  return mask;
}

std::vector<int> pieces_under(const Grid<float>& mask, const std::vector<JudgedPiece>& pieces, const Canvas& canvas,
                              double least_part) {
  const float cells_per_px = std::round(float(mask.width()) / float(canvas.width_px));
  std::vector<int> found;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    double touched_px2 = 0;
    for (const Vec2 offset : canvas.period.offsets()) {
      touched_px2 += marked_px2(mask, pieces[i].outline_px, offset, cells_per_px);
    }
    const double px2 = pieces[i].scale_px * pieces[i].scale_px;
    const double enough_px2 = std::max(std::min(kTouched_px2, 0.9 * px2), least_part * px2);
    if (touched_px2 >= enough_px2) found.push_back(int(i));
  }
  return found;
}

}  // namespace tessera
