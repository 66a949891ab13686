#include "artwork/silhouette.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "artwork/alpha_regions.h"
#include "artwork/images/alpha.h"
#include "artwork/images/artwork_page.h"
#include "artwork/images/colour_conversion.h"
#include "artwork/images/page_pixels.h"
#include "artwork/images/png_encoder.h"
#include "artwork/open_artwork_page.h"
#include "artwork/solid_coverage.h"
#include "artwork/style_picture.h"
#include "core/style/style_measure.h"

namespace tessera {
namespace {

/// A drawing is drawn again only where that gains at least this factor of resolution.
constexpr double kLeastZoom = 1.15;
constexpr int kColoursSide_px = 64;
constexpr float kLeastSeen = 0.02f;
/// Margin round the drawing, for parts that were too faint at first.
constexpr int kMargin_px = 4;

/// The alpha channel; empty where `bgra` is.
cv::Mat alpha_of(const cv::Mat& bgra) {
  cv::Mat alpha;
  if (!bgra.empty()) cv::extractChannel(bgra, alpha, 3);
  return alpha;
}

/// Whether translucent pixels lie apart from opaque ones, so that alpha alone may misjudge them.
bool has_translucent_parts(const cv::Mat& bgra) {
  constexpr int kEdge_px = 2;
  constexpr int kLeastPixels = 8;
  const cv::Mat alpha = alpha_of(bgra);
  cv::Mat beside_opaque;
  cv::dilate(alpha >= kOpaqueAlpha, beside_opaque, square(kEdge_px));
  return cv::countNonZero((alpha >= kFaintRegions.clear_alpha) & ~beside_opaque) >= kLeastPixels;
}

/// The part with the drawing and a margin; empty where nothing is drawn.
cv::Rect drawn_part(const cv::Mat& bgra, float edge_opacity) {
  const cv::Mat alpha = alpha_of(bgra);
  const cv::Rect part = cv::boundingRect(alpha >= int(std::ceil(255 * edge_opacity)));
  if (part.empty()) return {};
  const cv::Rect grown = part + cv::Size(2 * kMargin_px, 2 * kMargin_px) - cv::Point(kMargin_px, kMargin_px);
  return grown & cv::Rect({0, 0}, bgra.size());
}

struct Drawing {
  int longest_side_px = 0;
  cv::Rect part;
  cv::Mat bgra;  // only that part
};

/// The drawing at the wanted resolution. A small drawing on a large page is drawn a second time.
Drawing drawn_finely(const ArtworkPage& page, const cv::Mat& first, float edge_opacity) {
  const cv::Rect part = drawn_part(first, edge_opacity);
  if (part.empty()) return {kSilhouetteSide_px, {}, {}};
  const double wanted = double(kSilhouetteSide_px) / std::max(part.width, part.height);
  const double possible = double(page.finest_side_px()) / kSilhouetteSide_px;
  const double zoom = std::min(wanted, possible);
  if (zoom < kLeastZoom) return {kSilhouetteSide_px, part, first(part)};

  Drawing finer;
  finer.longest_side_px = int(kSilhouetteSide_px * zoom);
  const cv::Rect zoomed(cv::Point2d(part.tl()) * zoom, cv::Point2d(part.br()) * zoom);
  finer.part = zoomed & cv::Rect({0, 0}, page_size_px(page, finer.longest_side_px));
  finer.bgra = page.draw(finer.longest_side_px, finer.part);
  return finer;
}

/// A drawing, and its body where that differs from alpha.
struct Judged {
  Drawing drawing;
  cv::Mat body = {};  // CV_8U; empty: it is alpha
  int loose_parts = 0;
  bool loses_parts = false;
};

Judged judged(const ArtworkPage& page, const cv::Mat& first, const TracingRules& rules) {
  const float edge_opacity = rules.edge_opacity;
  const bool is_literal = rules.opaque || edge_opacity != kEdgeOpacity;
  if (is_literal || !has_translucent_parts(first)) return {drawn_finely(page, first, edge_opacity)};
  // All of a shadow must be in the picture, as it is recognised by the way in which it fades.
  Drawing seen = drawn_finely(page, first, kLeastSeen);
  const cv::Mat alpha = alpha_of(seen.bgra);
  const SolidCoverage solid = solid_coverage(alpha, page.source_px(seen.longest_side_px));
  if (solid.coverage.data == alpha.data) return {drawn_finely(page, first, edge_opacity), {}, 0, solid.loses_parts};
  return {std::move(seen), solid.coverage, solid.loose_parts, solid.loses_parts};
}

/// The values of a CV_8U matrix as 0..1.
Grid<float> grid_of(const cv::Mat& alpha) {
  Grid<float> grid(alpha.cols, alpha.rows);
  for (int y = 0; y < alpha.rows; ++y) {
    for (int x = 0; x < alpha.cols; ++x) grid(x, y) = float(alpha.at<std::uint8_t>(y, x)) / 255;
  }
  return grid;
}

cv::Mat thumbnail_of(const cv::Mat& page_bgra) {
  const double scale = double(kThumbnailSide_px) / std::max(page_bgra.cols, page_bgra.rows);
  const auto side = [&](int length) { return std::max(1, cvRound(length * scale)); };
  cv::Mat small;
  cv::resize(page_bgra, small, {side(page_bgra.cols), side(page_bgra.rows)}, 0, 0, cv::INTER_AREA);
  return straightened(small);
}

ArtworkColour colour_of(const cv::Mat& straight_bgra) {
  const cv::Mat lab = lab_image_of(straight_bgra);
  const cv::Mat alpha = alpha_of(straight_bgra);
  cv::Vec3d sum(0, 0, 0);
  double weight = 0, squares = 0;
  for (int y = 0; y < lab.rows; ++y) {
    for (int x = 0; x < lab.cols; ++x) {
      const double a = alpha.at<std::uint8_t>(y, x);
      const cv::Vec3d colour(lab.at<cv::Vec3f>(y, x));
      sum += a * colour;
      squares += a * colour.dot(colour);
      weight += a;
    }
  }
  if (weight == 0) return {};
  const cv::Vec3d mean = sum * (1 / weight);
  const double variance = std::max(0., squares / weight - mean.dot(mean));
  return {{float(sum[0] / weight), float(sum[1] / weight), float(sum[2] / weight)}, float(std::sqrt(variance))};
}

/// The colours of `drawing` in the page's frame, reduced to a few pixels for each cell of a ColourGrid.
ColourRaster colours_of(const Drawing& drawing) {
  if (drawing.bgra.empty()) return {};
  const double scale = std::min(1., double(kColoursSide_px) / std::max(drawing.bgra.cols, drawing.bgra.rows));
  const cv::Size size(std::max(1, cvRound(drawing.bgra.cols * scale)), std::max(1, cvRound(drawing.bgra.rows * scale)));
  cv::Mat small;
  cv::resize(drawing.bgra, small, size, 0, 0, cv::INTER_AREA);
  small = straightened(small);
  const cv::Mat lab = lab_image_of(small);
  ColourRaster raster{Grid<Lab>(size.width, size.height),
                      grid_of(alpha_of(small)),
                      {float(drawing.part.x), float(drawing.part.y)},
                      {float(drawing.bgra.cols) / float(size.width), float(drawing.bgra.rows) / float(size.height)}};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const cv::Vec3f& c = lab.at<cv::Vec3f>(y, x);
      raster.colour(x, y) = {c[0], c[1], c[2]};
    }
  }
  return raster;
}

}  // namespace

Silhouette make_silhouette(std::span<const std::uint8_t> bytes, const std::string& path, const TracingRules& rules) {
  const std::unique_ptr<ArtworkPage> page = open_artwork_page(bytes, path);
  const cv::Mat first = page->draw(kSilhouetteSide_px, cv::Rect({0, 0}, page_size_px(*page, kSilhouetteSide_px)));
  const Judged judgement = judged(*page, first, rules);
  const Drawing& drawing = judgement.drawing;
  const cv::Size size = page_size_px(*page, drawing.longest_side_px);
  const cv::Mat thumbnail = thumbnail_of(first);

  Silhouette silhouette;
  silhouette.path = path;
  silhouette.width_px = size.width;
  silhouette.height_px = size.height;
  const cv::Mat alpha = alpha_of(drawing.bgra);
  silhouette.alpha = grid_of(alpha);
  silhouette.origin_px = {float(drawing.part.x), float(drawing.part.y)};
  silhouette.source_px = page->source_px(drawing.longest_side_px);
  if (!judgement.body.empty()) silhouette.body = grid_of(judgement.body);
  silhouette.loose_parts = judgement.loose_parts;
  silhouette.loses_parts = judgement.loses_parts;
  silhouette.loses_text = page->loses_text();
  silhouette.loses_pictures = page->loses_pictures();
  silhouette.drawn_px =
      float(std::max(page->natural_size().width, page->natural_size().height) / drawing.longest_side_px);
  silhouette.colour = colour_of(thumbnail);
  silhouette.style = measure_style(style_raster_of(drawing.bgra));
  silhouette.colours = colours_of(drawing);
  silhouette.thumbnail_png = png_of(thumbnail);
  return silhouette;
}

}  // namespace tessera
