#include "products/puzzle/puzzle_making.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "artwork/artwork_render.h"
#include "artwork/images/png_encoder.h"
#include "core/base/error.h"
#include "core/base/portable_math.h"
#include "core/geometry/polygon.h"
#include "files/regular_file.h"
#include "job/canvas/canvas_edge.h"
#include "job/canvas/canvas_file.h"
#include "products/elements/photo_extraction.h"
#include "products/puzzle/frame_outline.h"
#include "products/puzzle/puzzle_geojson.h"
#include "text/number_text.h"

namespace tessera {
namespace {

constexpr int kLargestSide_px = 20'000;  // a turned piece is larger, and OpenCV warps at most 32,767
constexpr int kRim_px = 3;               // transparent, round each piece
constexpr int kSubpixels = 8;            // in each direction, for an edge's coverage
constexpr int kSubpixelBits = 8;         // of cv::fillPoly's coordinates

void check(const PuzzleRequest& request) {
  if (request.pieces < kFewestPuzzlePieces || request.pieces > kMostPuzzlePieces) {
    throw InputError("--pieces: found " + std::to_string(request.pieces) + ", allowed: from " +
                     std::to_string(kFewestPuzzlePieces) + " to " + std::to_string(kMostPuzzlePieces));
  }
}

/// The picture to cut, opaque within the outline. `outline`: empty for the whole picture.
struct Source {
  cv::Mat bgra;
  std::vector<Vec2> outline = {};
};

bool is_svg(const std::string& path) {
  const std::filesystem::path extension = std::filesystem::path(path).extension();
  return extension == ".svg" || extension == ".svgz";
}

/// The page with the colours of opaque parts continued some px beyond them, because the edge of a piece mixes with these.
cv::Mat with_colours_beyond(const cv::Mat& page) {
  constexpr double kReach_px = 2;
  cv::Mat own, weight, blurred;
  page.convertTo(own, CV_32FC4);
  cv::Mat result = page.clone();
  own.forEach<cv::Vec4f>([](cv::Vec4f& p, const int*) {
    const float alpha = p[3] / 255;
    for (int c = 0; c < 3; ++c) p[c] *= alpha;
  });
  cv::GaussianBlur(own, blurred, {0, 0}, kReach_px);
  result.forEach<cv::Vec4b>([&](cv::Vec4b& p, const int* at) {
    const cv::Vec4f& near = blurred.at<cv::Vec4f>(at[0], at[1]);
    if (p[3] < 255 && near[3] > 0) {
      for (int c = 0; c < 3; ++c) p[c] = cv::saturate_cast<std::uint8_t>(255 * near[c] / near[3]);
    }
    p[3] = 255;
  });
  return result;
}

/// Reads the shape in a size that suits its pieces.
Source shape_of(const PuzzleRequest& request, Drawers& drawers) {
  constexpr int kLeastSide_px = 1600;
  constexpr double kUsualPiece_px = 100;  // side of a piece, where the shape fills half of the page
  const int wished = int(kUsualPiece_px * std::sqrt(2.0 * request.pieces));
  const int side_px = std::min(std::max(kLeastSide_px, wished), kMaxArtworkSide_px);
  const cv::Mat page = drawers.render(read_regular_file(request.picture, kMaxPhotoBytes), request.picture, side_px);
  return {with_colours_beyond(page), frame_outline(traced_edge(mask_coverage(page), 1), request.picture)};
}

Source source_of(const PuzzleRequest& request, Drawers& drawers) {
  if (is_svg(request.picture)) return shape_of(request, drawers);
  return {drawers.photo(read_regular_file(request.picture, kMaxPhotoBytes), request.picture)};
}

/// The outline as a drawing of the page's size.
std::string frame_svg(const Source& source) {
  const std::string width = std::to_string(source.bgra.cols), height = std::to_string(source.bgra.rows);
  std::string path;
  for (const Vec2 p : source.outline) path += (path.empty() ? "M" : " ") + fixed(p.x, 3) + "," + fixed(p.y, 3);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height + "\" viewBox=\"0 0 " +
         width + " " + height + "\">\n<path d=\"" + path + "Z\"/>\n</svg>\n";
}

void check_size(const PuzzleRequest& request, const Source& source) {
  const cv::Size size = source.bgra.size();
  if (std::max(size.width, size.height) > kLargestSide_px) {
    throw InputError(request.picture + ": found " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                     " px, allowed: " + std::to_string(kLargestSide_px) + " px a side or less");
  }
  const double area = source.outline.empty() ? double(size.width) * size.height : signed_area(source.outline);
  const double piece_px = std::sqrt(area / request.pieces);
  if (piece_px >= kSmallestPuzzlePiece_px) return;
  throw InputError(request.picture + ": found " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                   " px, which gives pieces of " + std::to_string(int(piece_px)) +
                   " px; allowed: " + std::to_string(kSmallestPuzzlePiece_px) +
                   " px or more, with fewer pieces (--pieces) or a larger picture");
}

float unit_draw(std::uint64_t seed, std::uint64_t name) {
  return unit_float(std::uint32_t(mix_bits(mix_bits(seed) ^ mix_bits(name)) >> 32));
}

/// A random order: which piece gets which number.
std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t k = count; k > 1; --k) {
    const std::size_t other = std::min(k - 1, std::size_t(unit_draw(seed, 1'000'000 + k) * float(k)));
    std::swap(order[k - 1], order[other]);
  }
  return order;
}

std::string name_of(std::size_t place) {
  char name[32];
  std::snprintf(name, sizeof name, "piece_%03zu", place + 1);
  return name;
}

/// The part of each pixel that lies in the polygon, 0 to 255. In bands of rows, because subpixels take memory.
cv::Mat coverage(const std::vector<Vec2>& polygon, const cv::Size& size) {
  constexpr int kBand_px = 64;
  cv::Mat mask(size, CV_8UC1);
  for (int y = 0; y < size.height; y += kBand_px) {
    const cv::Size band(size.width, std::min(kBand_px, size.height - y));
    cv::Mat fine = cv::Mat::zeros(band * kSubpixels, CV_8UC1);
    std::vector<cv::Point> points;
    for (const Vec2 p : polygon) {
      const auto fixed = [](double x) {  // the centre of a pixel has whole numbers there
        return int(std::lround((x * kSubpixels - 0.5) * (1 << kSubpixelBits)));
      };
      points.emplace_back(fixed(p.x), fixed(double(p.y) - y));
    }
    cv::fillPoly(fine, std::vector<std::vector<cv::Point>>{points}, cv::Scalar(255), cv::LINE_8, kSubpixelBits);
    cv::resize(fine, mask.rowRange(y, y + band.height), band, 0, 0, cv::INTER_AREA);
  }
  return mask;
}

/// The piece, turned by that angle, on the smallest picture that holds it.
cv::Mat cut_out(const cv::Mat& picture, const std::vector<Vec2>& polygon, double turn_rad) {
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  std::vector<Vec2> turned;
  for (const Vec2 p : polygon) turned.push_back({float(c * p.x - s * p.y), float(s * p.x + c * p.y)});
  const Box box = bounding_box(turned);
  const Vec2 shift{float(kRim_px) - std::floor(box.low.x), float(kRim_px) - std::floor(box.low.y)};
  for (Vec2& p : turned) p = p + shift;
  const cv::Size size(int(std::ceil(box.width())) + 2 * kRim_px + 1, int(std::ceil(box.height())) + 2 * kRim_px + 1);
  // Pixel centres are whole numbers in OpenCV and halves here.
  const cv::Matx23d out_from_picture(c, -s, 0.5 * (c - s) + shift.x - 0.5, s, c, 0.5 * (s + c) + shift.y - 0.5);
  cv::Mat cut;
  cv::warpAffine(picture, cut, out_from_picture, size, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  cv::insertChannel(coverage(turned, size), cut, 3);
  return cut;
}

NewFile text_file(const std::string& name, const std::string& text) { return {name, {text.begin(), text.end()}}; }

}  // namespace

MadePuzzle make_puzzle(const PuzzleRequest& request, Drawers& drawers) {
  check(request);
  const Source source = source_of(request, drawers);
  check_size(request, source);
  const std::vector<std::vector<Vec2>> polygons =
      cut_puzzle({source.bgra.cols, source.bgra.rows, request.pieces, request.style, request.seed, source.outline});
  const std::vector<std::size_t> order = shuffled(polygons.size(), request.seed);
  MadePuzzle made{int(order.size()), source.bgra.cols, source.bgra.rows, {}, {}};
  std::vector<LaidPuzzlePiece> truth;
  for (std::size_t place = 0; place < order.size(); ++place) {
    const std::vector<Vec2>& polygon = polygons[order[place]];
    const double turn_rad = 2 * CV_PI * unit_draw(request.seed, 2'000'000 + place);
    made.files.push_back({"pieces/" + name_of(place) + ".png", png_of(cut_out(source.bgra, polygon, turn_rad))});
    const AreaMoment moment = area_moment(polygon);
    const double scale = std::sqrt(moment.area);
    truth.push_back({name_of(place),
                     {float(scale * std::cos(turn_rad)), float(-scale * std::sin(turn_rad)),
                      float(moment.x / moment.area), float(moment.y / moment.area)},
                     polygon});
  }
  made.files.push_back(text_file("truth/pieces.geojson", puzzle_geojson(truth)));
  if (source.outline.empty()) return made;
  made.frame = "frame.svg";
  made.files.push_back(text_file(made.frame, frame_svg(source)));
  return made;
}

}  // namespace tessera
