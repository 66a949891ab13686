// Shapes of random numbers within the limits of the library format, without geometric sense.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>

#include "core/shape/shape.h"
#include "library/storage/library_layout.h"

namespace tessera::test {

class RandomShape {
 public:
  RandomShape(std::uint64_t seed, int pad_levels) : random_(seed), pad_levels_(pad_levels) {}

  Shape make() {
    Shape shape;
    shape.name = "shape " + std::to_string(random_() % 1'000'000) + " ä";
    shape.perimeter = number(3, 30);
    shape.radius = number(0.5f, 3);
    for (float& v : shape.mean_lab) v = number(-100, 100);
    for (std::uint8_t& v : shape.colour_grid.bytes) v = std::uint8_t(number(0, 255));
    shape.drawn_scale_px = number(0, 1000);
    const int curves = whole(1, 4);
    for (int c = 0; c < curves; ++c) shape.outline.curves.push_back(points(whole(3, 40)));
    shape.field.extent = number(0.6f, 4);
    shape.field.distance = Grid<float>(layout::kFieldNodes, layout::kFieldNodes);
    for (float& d : shape.field.distance.data()) d = number(-0.5f, 3);
    for (std::size_t k = 0; k < kSmoothingLevels.size(); ++k) fill_level(shape.levels[k], kSmoothingLevels[k]);
    fill_artwork(shape.artwork);
    return shape;
  }

 private:
  float number(float least, float most) { return std::uniform_real_distribution<float>(least, most)(random_); }
  int whole(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }

  std::vector<Vec2> points(int count) {
    std::vector<Vec2> result;
    for (int i = 0; i < count; ++i) result.push_back({number(-2, 2), number(-2, 2)});
    return result;
  }

  std::vector<std::uint8_t> bytes(int most) {
    std::vector<std::uint8_t> result(std::size_t(whole(0, most)));
    for (auto& b : result) b = std::uint8_t(random_());
    return result;
  }

  /// The chunks of a small RGBA PNG around bytes that no decoder accepts.
  static std::vector<std::uint8_t> png(const std::vector<std::uint8_t>& pixels) {
    std::vector<std::uint8_t> file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13, 'I', 'H', 'D', 'R', 0,
                                   0,    0,   9,   0,   0,    0,    7,    8,    6, 0, 0, 0,  0,   0,   0,   0,   0};
    file.resize(8 + 12 + 13);
    const auto count = std::uint32_t(pixels.size());
    file.insert(file.end(), {0, 0, std::uint8_t(count >> 8), std::uint8_t(count), 'I', 'D', 'A', 'T'});
    file.insert(file.end(), pixels.begin(), pixels.end());
    file.insert(file.end(), {0, 0, 0, 0, 0, 0, 0, 0, 'I', 'E', 'N', 'D', 0, 0, 0, 0});
    return file;
  }

  void fill_level(LevelCurve& level, const SmoothingLevel& size) {
    level.points = points(size.curve_points);
    level.perimeter = number(3, 8);
    for (int j = 0; j < size.samples; ++j) {
      ArclengthPyramid& sample = level.samples.emplace_back();
      for (int i = 0; i < pad_levels_; ++i) sample.left[i] = number(0, 5);
      for (int i = 0; i < pad_levels_; ++i) sample.right[i] = number(0, 5);
      for (int i = 0; i < 2 * pad_levels_ + 1; ++i) sample.keypoint[i] = {number(-2, 2), number(-2, 2)};
      sample.convexity = float(whole(-1, 1));
    }
  }

  void fill_artwork(Artwork& artwork) {
    artwork.path = "/drawings/" + std::to_string(random_()) + ".svg";
    artwork.width_px = whole(1, 4000);
    artwork.height_px = whole(1, 4000);
    artwork.centroid_px = {number(0, 4000), number(0, 4000)};
    artwork.unit_px = number(1, 2000);
    artwork.thumbnail_png = png(bytes(3000));
    artwork.original = bytes(5000);
    artwork.surroundings_png = bytes(3000);
    artwork.surroundings_margin_px = int(artwork.surroundings_png.size()) % 100;
  }

  std::mt19937_64 random_;
  int pad_levels_;
};

}  // namespace tessera::test
