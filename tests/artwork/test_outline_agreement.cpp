// Outlines to cut and pictures of the same drawing agree in their areas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <polyclipping/clipper.hpp>
#include <regex>

#include "artwork/artwork_render.h"
#include "artwork/artwork_shape.h"
#include "artwork/outlines/flat_path.h"
#include "artwork/outlines/svg_outlines.h"
#include "core/base/error.h"

namespace tessera {
namespace test_outline_agreement {

namespace fs = std::filesystem;

constexpr int kSide_px = 2048;

std::vector<fs::path> openclipart() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator("/usr/share/openclipart/svg")) {
    if (entry.path().extension() == ".svg" && entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::uint8_t> bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The drawing with only opaque fills; empty if the drawing contains other elements.
std::vector<std::uint8_t> plain(const std::vector<std::uint8_t>& bytes) {
  static const std::regex kOther(R"(<(flowRoot|text|image|filter|mask|marker)\b)");
  const std::string style =
      "<style>*{stroke:none!important;opacity:1!important;fill-opacity:1!important;stop-opacity:1!important}</style>";
  std::string text(bytes.begin(), bytes.end());
  const std::size_t end = text.rfind("</svg>");
  if (end == std::string::npos || std::regex_search(text, kOther)) return {};
  text.insert(end, style);
  return {text.begin(), text.end()};
}

struct Size {
  double area = 0, perimeter = 0;  // px
};

/// The area and perimeter of the union of all outlines, on a page of `side_px`.
Size union_of(const SvgOutlines& found) {
  namespace clip = ClipperLib;
  constexpr double kFine = 1000;
  const double scale = kSide_px / std::max(found.page_mm.width, found.page_mm.height);
  clip::Paths all;
  for (const SvgOutline& outline : found.outlines) {
    clip::Paths own;
    for (const FlatSubpath& subpath : flat_path(outline.steps, 0.01 / scale)) {
      clip::Path& path = own.emplace_back();
      for (const cv::Point2d p : subpath.points)
        path.emplace_back(std::llround(p.x * scale * kFine), std::llround(p.y * scale * kFine));
    }
    clip::SimplifyPolygons(own, outline.even_odd ? clip::pftEvenOdd : clip::pftNonZero);
    clip::Clipper clipper;
    clipper.AddPaths(all, clip::ptSubject, true);
    clipper.AddPaths(own, clip::ptClip, true);
    clipper.Execute(clip::ctUnion, all, clip::pftNonZero, clip::pftNonZero);
  }
  const clip::cInt width = std::llround(found.page_mm.width * scale * kFine),
                   height = std::llround(found.page_mm.height * scale * kFine);
  clip::Clipper page;
  page.AddPaths(all, clip::ptSubject, true);
  page.AddPath({{0, 0}, {width, 0}, {width, height}, {0, height}}, clip::ptClip, true);
  page.Execute(clip::ctIntersection, all, clip::pftNonZero, clip::pftNonZero);
  Size size;
  for (const clip::Path& path : all) {
    size.area += clip::Area(path) / (kFine * kFine);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const clip::IntPoint a = path[i], b = path[(i + 1) % path.size()];
      size.perimeter += std::hypot(double(b.X - a.X), double(b.Y - a.Y)) / kFine;
    }
  }
  size.area = std::abs(size.area);
  return size;
}

/// The drawn area in px of kSide_px. It is drawn at a finer scale, because on touching edges two half-covered pixels add up to more than
/// half.
double drawn_area(const std::vector<std::uint8_t>& bytes, const std::string& path) {
  constexpr int kFiner = 4;
  const cv::Mat page = render_artwork(bytes, path, kFiner * kSide_px, Background::kept);
  double area = 0;
  for (int y = 0; y < page.rows; ++y) {
    for (int x = 0; x < page.cols; ++x) area += page.at<cv::Vec4b>(y, x)[3] / 255.0;
  }
  return area / (kFiner * kFiner);
}

/// Compares the first `count` plain drawings that `library build` accepts, of every `step`th drawing.
void expect_agreement(std::size_t count, std::size_t step) {
  const std::vector<fs::path> files = openclipart();
  if (files.empty()) GTEST_SKIP() << "openclipart-svg is not installed";
  std::size_t compared = 0;
  for (std::size_t i = 0; i < files.size() && compared < count; i += step) {
    const std::vector<std::uint8_t> bytes = plain(bytes_of(files[i]));
    if (bytes.empty()) continue;
    const std::string path = files[i].string();
    try {
      if (std::holds_alternative<SkipReason>(shape_from_artwork(bytes, path, {.pad = {}}))) continue;
    } catch (const InputError&) {
      continue;
    }
    const SvgOutlines found = svg_outlines(bytes, path);
    if (found.page_mm.empty()) continue;
    const Size size = union_of(found);
    EXPECT_NEAR(drawn_area(bytes, path), size.area, 0.001 * size.area + 0.1 * size.perimeter) << path;
    ++compared;
  }
  EXPECT_EQ(compared, count);
}

TEST(OutlineAgreement, WithWhatIsDrawnOfSomeOpenclipart) { expect_agreement(6, 41); }
TEST(LongOutlineAgreement, WithWhatIsDrawnOfManyOpenclipart) { expect_agreement(500, 1); }

}  // namespace test_outline_agreement
}  // namespace tessera
