#include "products/first_collage/first_job.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/count_text.h"
#include "job/toml_string.h"
#include "job/written_job.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr const char* kAuthor = "tessera";

/// Smaller pieces would be cruder than the field in which they are placed.
constexpr double kSmallest_px = 8;
constexpr double kLargestBySmallest = 5;
constexpr std::size_t kFewestPieces = 150, kMostPieces = 300;
/// The smallest size, as a part of the side of the square that each piece would have. Measured: of 200 pieces planned like
/// this, 125 to 180 fill a canvas; fewer where the shapes are more like rectangles.
constexpr double kSmallestByMean = 0.4;

std::string number_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string canvas_lines(const FirstCanvas& canvas) {
  const std::string size = "size_px = [" + std::to_string(canvas.width_px) + ", " + std::to_string(canvas.height_px);
  if (canvas.file.empty()) return size + "]  # file = \"heart.svg\" fills a drawing's shape instead\n";
  return "file = " + toml_string(canvas.file) + "\n" + size + "]  # the box that the drawing is scaled into\n";
}

}  // namespace

FirstSizes first_sizes(double area_px2, std::size_t shapes) {
  const double pieces = double(std::clamp(shapes, kFewestPieces, kMostPieces));
  // Even, so that half of both sizes is in whole px, and the ratio is exactly five to one.
  const double smallest_px = std::max(kSmallest_px, 2 * std::round(kSmallestByMean * std::sqrt(area_px2 / pieces) / 2));
  return {smallest_px, kLargestBySmallest * smallest_px};
}

std::string first_job(const std::string& source, const std::string& library, std::size_t shapes,
                      const FirstCanvas& canvas) {
  const FirstSizes sizes = first_sizes(canvas.area_px2, shapes);
  const std::string text =
      "# A first collage of " + printable_utf8(source) + ", " + count_text(shapes, "shape") +
      ". Change what you like, then: tessera collage THIS_FILE\n"
      "# Every key of a job: docs/job-format.md\n"
      "\n"
      "seed = 1          # another number, another collage\n"
      "quality = \"good\"  # \"draft\" for a quick look, \"best\" for the last run\n"
      "\n"
      "[library]\n"
      "file = " +
      toml_string(library) +
      "\n"
      "# exclude = [\"owl*\"]  # drawings that are not to appear, by name; include = [...] names those that are\n"
      "\n"
      "[canvas]\n" +
      canvas_lines(canvas) +
      "\n"
      "[pieces]\n"
      "# The smallest and the largest size: the square root of a piece's area, px of the canvas. Half of both gives\n"
      "# four times as many pieces. Keep them within five to one, so that the pieces can move together.\n"
      "scale_px = [" +
      number_text(sizes.smallest_px) + ", " + number_text(sizes.largest_px) +
      "]\n"
      "balance = 0.5  # about as much area of small pieces as of large ones\n"
      "# rotation_deg = [-30, 30]  # nearly upright; without it pieces turn freely\n"
      "# uses = 1                  # each drawing once at most\n"
      "\n"
      "[objective]\n"
      "repetition_exponent = 1  # how much it costs to use a drawing again; 0.3 covers more, with more repetition\n"
      "\n";
  return with_written_mark(text, kAuthor);
}

bool is_first_job(const std::string& text) { return has_written_mark(text, kAuthor); }

bool is_unedited_first_job(const std::string& text) { return is_as_written(text, kAuthor); }

}  // namespace tessera
