// texture_bench PHOTO TEXTURE: how far the elements of a texture are from those of its photo, beside image quilting of the
// same photo (image_quilting.h).
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>
#include <vector>

#include "artwork/images/photo.h"
#include "artwork/images/png_encoder.h"
#include "bench_main.h"
#include "copied_part.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "files/regular_file.h"
#include "image_quilting.h"
#include "products/elements/element_labels.h"
#include "products/elements/element_size.h"
#include "products/elements/photo_extraction.h"
#include "products/elements/segmentation/region_labels.h"
#include "text/number_text.h"
#include "texture_statistics.h"

namespace tessera::bench {
namespace {

/// Side of a block for quilting, in short sides of an element: a block shows whole elements, and a photo has many blocks.
constexpr double kElementsToBlock = 2;

struct Options {
  std::string photo, texture, quilted;
  double element_px = 0;  // of the photo as its file has it; 0: found
  int photo_scale = 1;
  int block_px = 0;  // 0: from the size of elements
  std::uint64_t seed = 1;
};

Options parsed(int argc, char** argv) {
  Options options;
  CLI::App app("How far the elements of a texture are from those of its photo, beside image quilting.",
               "texture_bench");
  app.add_option("PHOTO", options.photo, "The photo")->required()->type_name("FILE");
  app.add_option("TEXTURE", options.texture, "Its texture")->required()->type_name("FILE");
  app.add_option("--element-px", options.element_px, "Short side of an element, px of the photo; default: found")
      ->check(CLI::PositiveNumber);
  app.add_option("--photo-scale", options.photo_scale,
                 "Enlarges the photo by this factor first, for a texture that was enlarged")
      ->check(CLI::Range(1, kMostEnlarged))
      ->capture_default_str();
  app.add_option("--block-px", options.block_px,
                 "Side of a block for quilting, px of the enlarged photo; default: two elements")
      ->check(CLI::Range(kLeastBlock_px, 10'000));
  app.add_option("--seed", options.seed, "Seed of quilting: the random choice of blocks")->capture_default_str();
  app.add_option("--quilted", options.quilted, "Writes the quilted picture")->type_name("FILE.png");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  return options;
}

cv::Mat read_bgr(const std::string& path) {
  return bgr_of(photo_picture(read_regular_file(path, kMaxPhotoBytes), path));
}

cv::Mat read_enlarged(const std::string& path, int times) {
  const cv::Mat photo = read_bgr(path);
  if (times == 1) return photo;
  cv::Mat enlarged;
  cv::resize(photo, enlarged, photo.size() * times, 0, 0, cv::INTER_CUBIC);
  return enlarged;
}

/// The short side of an element, px of the enlarged photo.
double element_px_of(const Options& options, const cv::Mat& photo) {
  const double size_px = options.element_px > 0 ? options.element_px * options.photo_scale : found_element_px(photo);
  if (size_px == 0) throw InputError(options.photo + ": found no elements at any size; allowed: --element-px");
  return size_px;
}

/// At most half of the photo, so that a block has places to choose from.
int usual_block_px(cv::Size photo, double element_px) {
  const int half_px = std::min(photo.width, photo.height) / 2;
  return std::max(kLeastBlock_px, std::min(half_px, int(std::lround(kElementsToBlock * element_px))));
}

/// Where the parts of one side begin: as many parts of `part_px` as nearly fill it, evenly spread.
std::vector<int> part_starts_px(int side_px, int part_px) {
  const int count = std::max(1, int(std::lround(double(side_px) / part_px)));
  std::vector<int> starts_px;
  for (int i = 0; i < count; ++i)
    starts_px.push_back(count == 1 ? 0 : int(std::lround(double(i) * (side_px - part_px) / (count - 1))));
  return starts_px;
}

/// The statistics of a picture in parts of the photo's size. The search treats each part like the photo, and the edges of
/// the parts cut as many elements as the photo's edges do.
TextureStatistics statistics_of(const cv::Mat& picture, cv::Size photo, double element_px) {
  const cv::Size part(std::min(photo.width, picture.cols), std::min(photo.height, picture.rows));
  TextureStatistics statistics;
  for (const int y : part_starts_px(picture.rows, part.height)) {
    for (const int x : part_starts_px(picture.cols, part.width)) {
      const cv::Mat pixels = picture({cv::Point(x, y), part}).clone();
      add_picture(pixels, element_labels(pixels, element_px), statistics);
    }
  }
  return statistics;
}

std::string text_of(const std::optional<double>& value, int decimals) { return value ? fixed(*value, decimals) : "-"; }

std::string per_picture(const TextureStatistics& statistics) {
  return fixed(double(statistics.sizes_px.size()) / double(statistics.pictures()), 1);
}

/// The middle one of the values; for an even number, the upper of two.
std::string median_of(std::vector<double> values) {
  if (values.empty()) return "-";
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return fixed(*middle, 1);
}

std::string median_size(const TextureStatistics& statistics) { return median_of(statistics.sizes_px); }

std::string median_joint(const TextureStatistics& statistics) { return median_of(statistics.joints_px); }

std::string with_rows(const TextureStatistics& statistics) {
  return std::to_string(statistics.pitches_px.size()) + " of " + std::to_string(statistics.pictures());
}

/// A table in Markdown with a column each for the photo or for what chance brings, our texture and quilting.
class DistanceTable {
 public:
  DistanceTable(const TextureStatistics& photo, const TextureStatistics& ours, const TextureStatistics& quilting)
      : photo_(photo),
        ours_(ours),
        quilting_(quilting),
        from_ours_(texture_distances(photo, ours)),
        from_quilting_(texture_distances(photo, quilting)) {}

  void print() const {
    print_row("", "photo, or by chance", "ours", "quilting");
    std::printf("|---|---|---|---|\n");
    print_values("whole elements in an area as large as the photo", per_picture);
    print_values("median size, px", median_size);
    print_values("median width of joints, px", median_joint);
    const auto long_ones = [](const TextureStatistics& s) { return s.angles_rad.size(); };
    const auto all = [](const TextureStatistics& s) { return s.sizes_px.size(); };
    const auto smirnov = kolmogorov_smirnov_by_chance(all(photo_), all(ours_));
    const auto kuiper = kuiper_by_chance(long_ones(photo_), long_ones(ours_));
    print_distances("sizes (Kolmogorov-Smirnov)", smirnov, &TextureDistances::sizes, 3);
    print_distances("elongations (Kolmogorov-Smirnov)", smirnov, &TextureDistances::elongations, 3);
    print_distances("angles of long elements (Kuiper)", kuiper, &TextureDistances::angles, 3);
    print_distances("widths of joints (Kolmogorov-Smirnov)", smirnov, &TextureDistances::joints, 3);
    print_values("areas with rows", with_rows);
    print_distances("pitch of rows, times the photo's", {}, &TextureDistances::pitch_ratio, 3);
    print_distances("part covered by elements, more than in the photo", {}, &TextureDistances::covered, 3);
    print_distances("spectrum of luminance, dB", {}, &TextureDistances::spectrum_db, 2);
  }

 private:
  static void print_row(const char* measure, const std::string& photo, const std::string& ours,
                        const std::string& quilting) {
    std::printf("| %s | %s | %s | %s |\n", measure, photo.c_str(), ours.c_str(), quilting.c_str());
  }
  void print_values(const char* measure, std::string (*text)(const TextureStatistics&)) const {
    print_row(measure, text(photo_), text(ours_), text(quilting_));
  }
  void print_distances(const char* measure, std::optional<double> by_chance,
                       std::optional<double> TextureDistances::*distance, int decimals) const {
    print_row(measure, by_chance ? fixed(*by_chance, decimals) : "", text_of(from_ours_.*distance, decimals),
              text_of(from_quilting_.*distance, decimals));
  }

  const TextureStatistics &photo_, &ours_, &quilting_;
  const TextureDistances from_ours_, from_quilting_;
};

void run(const Options& options) {
  const cv::Mat photo = read_enlarged(options.photo, options.photo_scale), texture = read_bgr(options.texture);
  const double element_px = element_px_of(options, photo);
  const int block_px = options.block_px > 0 ? options.block_px : usual_block_px(photo.size(), element_px);
  const cv::Mat quilt = quilted(photo, texture.size(), {block_px, options.seed});
  if (!options.quilted.empty()) write_file_atomically(options.quilted, png_of(quilt));
  std::printf("Elements of %s px, blocks of %d px, textures of %d x %d px.\n\n", fixed(element_px, 0).c_str(), block_px,
              texture.cols, texture.rows);
  const TextureStatistics of_photo = statistics_of(photo, photo.size(), element_px);
  const TextureStatistics of_ours = statistics_of(texture, photo.size(), element_px);
  const TextureStatistics of_quilt = statistics_of(quilt, photo.size(), element_px);
  DistanceTable(of_photo, of_ours, of_quilt).print();
  const auto copied = [&](const cv::Mat& picture) {
    return fixed(copied_part(picture, int(kElementsToBlock * element_px)), 2);
  };
  std::printf("| part that comes again, in squares of two elements | %s | %s | %s |\n", copied(photo).c_str(),
              copied(texture).c_str(), copied(quilt).c_str());
}

}  // namespace
}  // namespace tessera::bench

int main(int argc, char** argv) {
  using namespace tessera::bench;
  return exit_code_of("texture_bench", [&] { run(parsed(argc, argv)); });
}
