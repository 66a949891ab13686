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

#include "artwork/images/alpha.h"
#include "artwork/nearest_pixels.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "core/geometry/rasterise.h"
#include "job/picture_size.h"
#include "layers/svg_image.h"
#include "render/ground_continuation.h"
#include "render/ground_strips.h"
#include "render/pieces/piece_drawing.h"
#include "render/pieces/sprite_cache.h"
#include "render/pieces/surroundings_drawing.h"

namespace tessera {
namespace {

constexpr const char* kPhotoGroundId = "photo-ground";
constexpr double kMostPixels = 64e6;
constexpr int kMostTimes = 3;
/// Pixels of two photos are the same if they differ by no more, of 255.
constexpr double kSamePixel = 4;
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
/// Cut elements that would be thinner than twice so many joints are left to the ground.
constexpr double kSliver = 1.3;
constexpr std::size_t kSpriteBytes = std::size_t(256) << 20;

/// The size of the picture; a multiple of it where the picture is a smaller copy of the canvas, so that the edges between
/// photos are averaged, too.
cv::Size ground_size(const CollageReport& report) {
  const cv::Size picture = picture_size_px(report.output, *report.canvas);
  const int times = std::clamp(report.canvas->width_px / picture.width, 1, kMostTimes);
  const double scale = std::min(double(times), std::sqrt(kMostPixels / (double(picture.width) * picture.height)));
  return {std::max(1, int(picture.width * scale)), std::max(1, int(picture.height * scale))};
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
    reach_px_ += kContinuation_px;
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
    show_nearest(cv::Mat(window.size(), CV_8U, cv::Scalar(255)), kGroundAlpha, part);
    spread(kGroundAlpha, part);
    // In wide gaps, where all photos show other elements, these are shown, with a joint round the pieces.
    show_nearest(beyond_joints(is_piece), kAnyAlpha, part);
    continue_ground(is_piece, part.pixels);
    soften(seams(is_piece, part), part.pixels);
    return part.pixels(cv::Rect(reach, square.size())).clone();
  }

 private:
  static constexpr int kNobody = -1;

  /// An image of a piece on the canvas.
  struct Image {
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
    for (const Vec2 offset : report_.canvas->period.offsets()) {
      Placement image = placement;
      image.canvas_from_shape = moved(placement.canvas_from_shape, offset);
      std::optional<PieceDrawing> drawing = surroundings_drawing(image, report_.shapes[slot], ground_px_);
      if (!drawing) continue;
      drawing->slot = slot;
      // Whatever reaches into a square is known as a whole, so that squares agree at their edges.
      reach_px_ = std::max(reach_px_, std::min(kMostReach_px, std::max(drawing->box.width, drawing->box.height)));
      images_.push_back({scaled(image.canvas_from_shape, float(ground_px_)), *drawing});
    }
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
    return draw_rows(drawing, *sprites_.get(drawing.slot, drawing.sprite_side_px), box.y, box.br().y);
  }

  static bool is_shown(const Part& part, cv::Point at) { return part.pixels.at<cv::Vec4b>(at)[3] > 0; }

  /// Shows the photo of the nearest owner in these places (CV_8U) where nothing is shown yet.
  void show_nearest(const cv::Mat& places, int least_alpha, Part& part) {
    const NearestPixels owned(part.owners != kNobody);
    const cv::Mat owners = part.owners.clone();  // as they are now
    for (int y = 0; y < owners.rows; ++y) {
      for (int x = 0; x < owners.cols; ++x) {
        if (!places.at<std::uint8_t>(y, x) || is_shown(part, {x, y})) continue;
        if (const auto owner = owned.nearest({x, y})) show(owners.at<int>(*owner), {x, y}, least_alpha, part);
      }
    }
  }

  /// Shows photos beyond the places where they are the nearest, where nothing is shown yet.
  void spread(int least_alpha, Part& part) {
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

  /// Whether the photo of `image` shows something else at this place than what is shown there.
  bool differs(int image, cv::Point at, const Part& part) const {
    const auto photo = part.photos.find(image);
    const cv::Rect box = images_[std::size_t(image)].surroundings.box & part.window;
    const cv::Point place = at + part.window.tl();
    if (photo == part.photos.end() || !box.contains(place)) return true;
    const cv::Vec4b &a = photo->second.at<cv::Vec4b>(place - box.tl()), &b = part.pixels.at<cv::Vec4b>(at);
    return a[3] < 255 || cv::norm(a, b, cv::NORM_INF) > kSamePixel;
  }

  /// The pixels of the ground beside another photo, unless both photos are the same there: CV_8U.
  cv::Mat seams(const cv::Mat& is_piece, const Part& part) const {
    cv::Mat found = cv::Mat::zeros(is_piece.size(), CV_8U);
    const auto look = [&](cv::Point a, cv::Point b) {
      const int first = part.owners.at<int>(a), second = part.owners.at<int>(b);
      if (first == second || first == kNobody || second == kNobody) return;
      if (is_piece.at<std::uint8_t>(a) || is_piece.at<std::uint8_t>(b)) return;
      if (differs(first, b, part) || differs(second, a, part))
        found.at<std::uint8_t>(a) = found.at<std::uint8_t>(b) = 255;
    };
    for (int y = 0; y < found.rows; ++y) {
      for (int x = 0; x < found.cols; ++x) {
        if (x + 1 < found.cols) look({x, y}, {x + 1, y});
        if (y + 1 < found.rows) look({x, y}, {x, y + 1});
      }
    }
    return found;
  }

  /// The places that are farther from all pieces than a joint is wide, without slivers: CV_8U.
  cv::Mat beyond_joints(const cv::Mat& is_piece) const {
    const NearestPixels pieces(is_piece);
    cv::Mat beyond(is_piece.size(), CV_8U);
    for (int y = 0; y < beyond.rows; ++y) {
      for (int x = 0; x < beyond.cols; ++x)
        beyond.at<std::uint8_t>(y, x) = pieces.distance_px({x, y}) > joint_px_ ? 255 : 0;
    }
    const int across = 2 * int(std::lround(kSliver * joint_px_)) + 1;
    cv::morphologyEx(beyond, beyond, cv::MORPH_OPEN,
                     cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(across, across)));
    return beyond;
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

/// The page, averaged where it is larger than the picture.
cv::Mat in_picture_size(const cv::Mat& page, const CollageReport& report) {
  const cv::Size picture = picture_size_px(report.output, *report.canvas);
  if (page.cols <= picture.width) return page;
  cv::Mat small;
  cv::resize(page, small, picture, 0, 0, cv::INTER_AREA);
  return small;
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
  const cv::Mat image = straightened(in_embedded_size(in_picture_size(tile.page, report)));
  tile.svg = svg_image(image, kPhotoGroundId);
  tile.svg_size = image.size();
  return tile;
}

}  // namespace tessera
