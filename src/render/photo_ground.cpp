#include "render/photo_ground.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>
#include <vector>

#include "artwork/artwork_render.h"
#include "artwork/images/alpha.h"
#include "artwork/images/image_header.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "core/geometry/extent.h"
#include "core/geometry/rasterise.h"
#include "job/picture_size.h"
#include "layers/svg_image.h"
#include "render/ground_strips.h"
#include "render/pieces/piece_drawing.h"
#include "render/pieces/sprite_cache.h"

namespace tessera {
namespace {

constexpr const char* kBackgroundId = "photo-ground";
constexpr double kMostPixels = 64e6;
/// The side of the squares in which the picture is made, one for each thread at a time, and the most px beyond a square
/// that count for it.
constexpr int kSquare_px = 1024;
constexpr int kMostReach_px = 512;
/// Each takes up to 100 MB while it is drawn.
constexpr std::size_t kSquaresAtOnce = 8;
/// The least alpha of a place that shows ground, and of one that shows anything: between those of the kinds
/// (kOtherElementAlpha), because edges are mixed.
constexpr int kGroundAlpha = 192, kAnyAlpha = 96;
/// The width of the joint that is kept round pieces in gaps where photos show other elements, as a part of a piece's size.
constexpr double kJoint = 0.06;
/// How far ground is continued beyond what photos show.
constexpr float kContinued_px = 12;
constexpr std::size_t kSpriteBytes = std::size_t(256) << 20;

cv::Size ground_size(const CollageReport& report) {
  const cv::Size picture = picture_size_px(report.output, *report.canvas);
  const double scale = std::min(1., std::sqrt(kMostPixels / (double(picture.width) * picture.height)));
  return {std::max(1, int(picture.width * scale)), std::max(1, int(picture.height * scale))};
}

/// The place of a shape's surroundings. Their page is the original's and a margin round it.
struct SurroundingsFrame {
  int page_side_px = 0;          // the longer one
  double px_per_artwork_px = 1;  // px of the page
  float margin_artwork_px = 0;
};

/// Empty where the shape has no surroundings, or has them in a size that is not the artwork's and a margin.
std::optional<SurroundingsFrame> surroundings_frame(const Artwork& artwork) {
  constexpr double kMostScale = 64, kRounded_px = 2;
  const std::optional<cv::Size2d> page = image_size_from_header(artwork.surroundings_png);
  const double around_px = 2. * artwork.surroundings_margin_px;
  if (!page || std::max(page->width, page->height) > kMaxArtworkSide_px) return {};
  const double px_per_artwork_px = (page->width - around_px) / artwork.width_px;
  if (!(px_per_artwork_px > 1 / kMostScale && px_per_artwork_px < kMostScale)) return {};
  if (std::abs(page->height - around_px - px_per_artwork_px * artwork.height_px) > kRounded_px + px_per_artwork_px)
    return {};
  return SurroundingsFrame{int(std::max(page->width, page->height)), px_per_artwork_px,
                           float(artwork.surroundings_margin_px / px_per_artwork_px)};
}

/// The surroundings as a sprite; nothing where they are damaged.
Sprite surroundings_sprite(const Artwork& artwork, Drawers& drawers) {
  try {
    const std::string name = artwork.path + " (surroundings)";
    const cv::Mat page = drawers.decode_png(artwork.surroundings_png, name, kMaxArtworkSide_px);
    return {premultiplied(page), surroundings_frame(artwork)->px_per_artwork_px};
  } catch (const InputError&) {
    return {cv::Mat::zeros(1, 1, CV_8UC4), 1};
  }
}

/// Draws the surroundings of pieces where these are the nearest.
class PhotoGround {
 public:
  PhotoGround(const CollageReport& report, cv::Size size, Drawers& drawers)
      : report_(report),
        ground_px_(double(size.width) / report.canvas->width_px),
        sprites_(kSpriteBytes, [&report, &drawers](std::size_t slot, int) {
          return surroundings_sprite(report.shapes[slot].artwork, drawers);
        }) {
    double area = 0;
    for (const Placement& placement : report.placements) {
      add_images(placement);
      area += double(placement.canvas_from_shape.scale()) * placement.canvas_from_shape.scale();
    }
    reach_px_ += 2 * int(std::ceil(kContinued_px)) + 1;
    const double size_px = std::sqrt(area / double(std::max<std::size_t>(1, report.placements.size()))) * ground_px_;
    joint_px_ = float(std::max(1., kJoint * size_px));
  }

  bool empty() const { return images_.empty(); }

  /// The pixels of the square: BGRA, opaque where there is a photo, else 0.
  cv::Mat drawn(const cv::Rect& square) {
    const cv::Point reach(reach_px_, reach_px_);
    const cv::Rect window(square.tl() - reach, square.br() + reach);
    Part part{window, owners_in(window), cv::Mat::zeros(window.size(), CV_8UC4), {}};
    const cv::Mat is_piece = part.owners != kNobody;
    show_nearest(part, kGroundAlpha);
    spread(part, kGroundAlpha);
    show_elements(is_piece, part);
    continue_ground(is_piece, part);
    return part.pixels(cv::Rect(reach, square.size())).clone();
  }

 private:
  static constexpr int kNobody = -1;

  /// An image of a piece on the canvas.
  struct Image {
    int page_side_px = 0;
    Similarity ground_from_shape;
    PieceDrawing surroundings;
  };

  /// A part of the ground while it is drawn.
  struct Part {
    cv::Rect window;
    cv::Mat owners;  // CV_32S: the image of the piece that lies there, or whose photo is shown, else kNobody
    cv::Mat pixels;  // CV_8UC4
    std::map<int, cv::Mat> photos;  // of the images, within their boxes and the window
  };

  void add_images(const Placement& placement) {
    const std::size_t slot = report_.shapes.slot_of(placement.shape);
    const Shape& shape = report_.shapes[slot];
    const std::optional<SurroundingsFrame> frame = surroundings_frame(shape.artwork);
    if (!frame) return;
    const float margin = frame->margin_artwork_px;
    for (const Vec2 offset : report_.canvas->period.offsets()) {
      Placement image = placement;
      image.canvas_from_shape = moved(placement.canvas_from_shape, offset);
      Image added{frame->page_side_px, scaled(image.canvas_from_shape, float(ground_px_)), {}};
      PieceDrawing& drawing = added.surroundings;
      drawing.slot = slot;
      // The frame of the page is that of the artwork, moved by the margin.
      Similarity& from_page = drawing.picture_from_artwork = picture_from_artwork(image, shape.artwork, ground_px_);
      const Vec2 corner = from_page.apply({-margin, -margin});
      from_page.tx = corner.x;
      from_page.ty = corner.y;
      if (shape.artwork.mirrored) drawing.mirrored_at_px = shape.artwork.centroid_px.x + margin;
      const Extent page = page_extent(shape.artwork, margin, drawing);
      if (!is_drawable(page)) continue;
      const Window box = nodes_round(page, {}, 0);
      drawing.box = {box.x0, box.y0, box.width(), box.height()};
      // Whatever reaches into a square is known as a whole, so that squares agree at their edges.
      reach_px_ = std::max(reach_px_, std::min(kMostReach_px, std::max(box.width(), box.height())));
      images_.push_back(added);
    }
  }

  /// The part of the ground that the page of the surroundings covers.
  static Extent page_extent(const Artwork& artwork, float margin, const PieceDrawing& drawing) {
    const Vec2 page{float(artwork.width_px) + 2 * margin, float(artwork.height_px) + 2 * margin};
    std::vector<Vec2> corners{{0, 0}, {page.x, 0}, {0, page.y}, page};
    if (drawing.mirrored_at_px) {
      for (Vec2& p : corners) p.x = 2 * *drawing.mirrored_at_px - p.x;
    }
    return extent_of(corners, drawing.picture_from_artwork);
  }

  /// Whether the numbers are those of a picture; a library may claim others.
  static bool is_drawable(const Extent& page) {
    constexpr float kMost_px = 1e7F;
    return page.low.x > -kMost_px && page.low.y > -kMost_px && page.high.x < kMost_px && page.high.y < kMost_px;
  }

  cv::Mat owners_in(const cv::Rect& window) const {
    cv::Mat owners(window.size(), CV_32S, cv::Scalar(kNobody));
    const Window within{window.x, window.y, window.br().x, window.br().y};
    for (std::size_t i = 0; i < images_.size(); ++i) {
      if ((images_[i].surroundings.box & window).empty()) continue;
      const Shape& shape = report_.shapes[images_[i].surroundings.slot];
      for (const Span& span : fill_spans(shape.outline, images_[i].ground_from_shape, within)) {
        int* row = owners.ptr<int>(span.y - window.y) - window.x;
        std::fill(row + span.x0, row + span.x1, int(i));
      }
    }
    return owners;
  }

  /// The owner of the nearest place that has one, for each place.
  static cv::Mat nearest_of(const cv::Mat& owners) {
    const cv::Mat is_nobody = owners == kNobody;
    cv::Mat distances, labels;
    cv::distanceTransform(is_nobody, distances, labels, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    std::vector<int> owner_of(owners.total() + 1, kNobody);  // of labels
    for (int y = 0; y < owners.rows; ++y) {
      for (int x = 0; x < owners.cols; ++x) {
        if (owners.at<int>(y, x) != kNobody) owner_of[std::size_t(labels.at<int>(y, x))] = owners.at<int>(y, x);
      }
    }
    cv::Mat nearest(owners.size(), CV_32S);
    for (int y = 0; y < owners.rows; ++y) {
      for (int x = 0; x < owners.cols; ++x) nearest.at<int>(y, x) = owner_of[std::size_t(labels.at<int>(y, x))];
    }
    return nearest;
  }

  /// Shows the image's photo at this place of the part, if it has something of such an alpha there.
  bool show(int image, cv::Point at, int least_alpha, Part& part) {
    const cv::Rect box = images_[std::size_t(image)].surroundings.box & part.window;
    const cv::Point place = at + part.window.tl();
    if (!box.contains(place)) return false;
    const auto [photo, is_new] = part.photos.try_emplace(image);
    if (is_new) photo->second = drawn_photo(image, box);
    const cv::Vec4b& from = photo->second.at<cv::Vec4b>(place - box.tl());
    if (from[3] < least_alpha) return false;
    cv::Vec4b& to = part.pixels.at<cv::Vec4b>(at);
    for (int c = 0; c < 3; ++c) to[c] = std::uint8_t(std::min(255, (from[c] * 255 + from[3] / 2) / from[3]));
    to[3] = 255;
    part.owners.at<int>(at) = image;
    return true;
  }

  cv::Mat drawn_photo(int image, const cv::Rect& box) {
    PieceDrawing drawing = images_[std::size_t(image)].surroundings;
    drawing.box = box;
    return draw_rows(drawing, *sprites_.get(drawing.slot, images_[std::size_t(image)].page_side_px), box.y, box.br().y);
  }

  static bool is_shown(const Part& part, cv::Point at) { return part.pixels.at<cv::Vec4b>(at)[3] > 0; }

  /// Shows the photo of the nearest owner where nothing is shown yet.
  void show_nearest(Part& part, int least_alpha) {
    const cv::Mat nearest = nearest_of(part.owners);
    for (int y = 0; y < nearest.rows; ++y) {
      for (int x = 0; x < nearest.cols; ++x) {
        const int image = nearest.at<int>(y, x);
        if (image != kNobody && !is_shown(part, {x, y})) show(image, {x, y}, least_alpha, part);
      }
    }
  }

  /// Shows photos beyond the places where they are the nearest, where nothing is shown yet.
  void spread(Part& part, int least_alpha) {
    std::deque<cv::Point> edge;
    for (int y = 0; y < part.pixels.rows; ++y) {
      for (int x = 0; x < part.pixels.cols; ++x) {
        if (is_shown(part, {x, y})) edge.emplace_back(x, y);
      }
    }
    const cv::Rect inside({}, part.window.size());
    for (; !edge.empty(); edge.pop_front()) {
      const int image = part.owners.at<int>(edge.front());
      for (const cv::Point step : {cv::Point(1, 0), cv::Point(0, 1), cv::Point(-1, 0), cv::Point(0, -1)}) {
        const cv::Point beside = edge.front() + step;
        if (!inside.contains(beside) || is_shown(part, beside)) continue;
        if (show(image, beside, least_alpha, part)) edge.push_back(beside);
      }
    }
  }

  /// In wide gaps where all photos show other elements, these are shown, with a joint round the pieces.
  void show_elements(const cv::Mat& is_piece, Part& part) {
    cv::Mat distances;
    cv::distanceTransform(~is_piece, distances, cv::DIST_L2, cv::DIST_MASK_5);
    const cv::Mat nearest = nearest_of(part.owners);
    for (int y = 0; y < nearest.rows; ++y) {
      for (int x = 0; x < nearest.cols; ++x) {
        const int image = nearest.at<int>(y, x);
        if (image == kNobody || is_shown(part, {x, y}) || distances.at<float>(y, x) <= joint_px_) continue;
        show(image, {x, y}, kAnyAlpha, part);
      }
    }
  }

  /// Continues the ground into places that show nothing, mirrored at its edge.
  static void continue_ground(const cv::Mat& is_piece, Part& part) {
    cv::Mat is_ground;
    cv::extractChannel(part.pixels, is_ground, 3);
    is_ground = (is_ground > 0) & ~is_piece;
    if (cv::countNonZero(is_ground) == 0) return;
    cv::Mat distances, labels;
    cv::distanceTransform(~is_ground, distances, labels, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    std::vector<cv::Point> place_of(is_ground.total() + 1);  // of labels
    for (int y = 0; y < is_ground.rows; ++y) {
      for (int x = 0; x < is_ground.cols; ++x) {
        if (is_ground.at<std::uint8_t>(y, x)) place_of[std::size_t(labels.at<int>(y, x))] = {x, y};
      }
    }
    const cv::Rect inside({}, part.window.size());
    for (int y = 0; y < is_ground.rows; ++y) {
      for (int x = 0; x < is_ground.cols; ++x) {
        if (is_shown(part, {x, y}) || distances.at<float>(y, x) > kContinued_px) continue;
        const cv::Point edge = place_of[std::size_t(labels.at<int>(y, x))], mirrored = 2 * edge - cv::Point(x, y);
        const bool has_mirrored = inside.contains(mirrored) && is_ground.at<std::uint8_t>(mirrored);
        part.pixels.at<cv::Vec4b>(y, x) = part.pixels.at<cv::Vec4b>(has_mirrored ? mirrored : edge);
      }
    }
  }

  const CollageReport& report_;
  const double ground_px_;  // px of the ground for one of the canvas
  int reach_px_ = 1;
  float joint_px_ = 0;
  std::vector<Image> images_;
  SpriteCache sprites_;
};

std::vector<cv::Rect> squares_of(cv::Size size) {
  std::vector<cv::Rect> squares;
  for (int y = 0; y < size.height; y += kSquare_px) {
    for (int x = 0; x < size.width; x += kSquare_px)
      squares.push_back(cv::Rect(x, y, kSquare_px, kSquare_px) & cv::Rect({}, size));
  }
  return squares;
}

/// The page below the photo: premultiplied BGRA.
cv::Mat page_below(const GroundTile& below, const CollageReport& report, cv::Size size) {
  cv::Mat page(size, CV_8UC4, cv::Scalar::all(0));
  const GroundStrips strips(below, double(size.width) / report.canvas->width_px, size);
  for (int y = 0; y < size.height && !strips.empty(); y += kStripRows) {
    const int rows = std::min(kStripRows, size.height - y);
    strips.rows(y, rows).copyTo(page.rowRange(y, y + rows));
  }
  return page;
}

/// Gives places without any pixel the mean colour of all others, if there are any.
void fill_empty_places(cv::Mat& page) {
  cv::Mat alpha;
  cv::extractChannel(page, alpha, 3);
  const cv::Mat is_empty = alpha == 0;
  const int empty = cv::countNonZero(is_empty);
  if (empty == 0 || std::size_t(empty) == page.total()) return;
  const cv::Scalar mean = cv::mean(page, ~is_empty);
  page.setTo(cv::Scalar(mean[0], mean[1], mean[2], 255), is_empty);
}

/// The page in the size of an embedded picture.
cv::Mat embedded(const cv::Mat& page) {
  const double scale = std::min(1., double(kMaxBitmapSide_px) / std::max(page.cols, page.rows));
  cv::Mat small;
  cv::resize(page, small, {std::max(1, cvRound(page.cols * scale)), std::max(1, cvRound(page.rows * scale))}, 0, 0,
             cv::INTER_AREA);
  return straightened(small);
}

}  // namespace

GroundTile photo_ground(const CollageReport& report, const GroundTile& below, Drawers& drawers,
                        const StopWatcher& stop) {
  const cv::Size size = ground_size(report);
  PhotoGround photo(report, size, drawers);
  if (photo.empty() && !report.placements.empty()) {
    throw InputError(
        "output.background: found \"" + std::string(kPhotoBackground) +
        "\", but no piece knows the photo round it; needed: a library that tessera library extract or tessera "
        "texture of this version made of a photo");
  }
  GroundTile tile;
  tile.page = page_below(below, report, size);
  const std::vector<cv::Rect> squares = squares_of(size);
  for (std::size_t first = 0; first < squares.size(); first += kSquaresAtOnce) {
    parallel_for(std::min(kSquaresAtOnce, squares.size() - first), [&](std::size_t i) {
      stop.check();
      const cv::Rect& square = squares[first + i];
      const cv::Mat drawn = photo.drawn(square);
      cv::Mat mask;
      cv::extractChannel(drawn, mask, 3);
      drawn.copyTo(tile.page(square), mask);
    });
  }
  fill_empty_places(tile.page);
  tile.size_px = cv::Size2d(report.canvas->width_px, report.canvas->height_px);
  tile.repeats = report.canvas->period.x_px > 0 && report.canvas->period.y_px > 0;
  const cv::Mat image = embedded(tile.page);
  tile.svg = svg_image(image, kBackgroundId);
  tile.svg_size = image.size();
  return tile;
}

}  // namespace tessera
