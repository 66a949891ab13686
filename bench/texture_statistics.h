// Statistics of the elements (stones, bricks, pebbles) of pictures, and how far those of a texture are from its photo's. The
// benchmark texture_bench compares textures with them. Sources: the two-sample distances of Kolmogorov and Smirnov, and of
// N. H. Kuiper ("Tests concerning random points on a circle", 1960); the periodogram with a Hann window.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "products/elements/segmentation/label_runs.h"

namespace tessera::bench {

/// Statistics of one or more pictures. An element that a picture's edge cuts counts only as covered.
struct TextureStatistics {
  std::vector<double> sizes_px;     // of each element: the square root of its area
  std::vector<double> elongations;  // of each element: minor by major axis of its second moments, 0 to 1
  std::vector<double> angles_rad;  // of each long element (kRoundElongation): its major axis, 0 to pi, clockwise from x
  std::vector<double> joints_px;   // of each element: the median distance from its outline to the nearest other element
  std::vector<double> pitches_px;  // of each picture whose elements lie in rows: from row to row
  std::vector<double> covered;     // of each picture: the part that elements cover
  std::vector<std::vector<double>> spectra_db;  // of each picture: luminance_spectrum_db()

  std::size_t pictures() const { return covered.size(); }
};

/// The axis of an element whose elongation is not below this has no clear angle.
inline constexpr double kRoundElongation = 0.8;

/// Adds one picture (CV_8UC3, BGR) and its elements; `labels` has its size. The row pitch is element_pitch_px(), the first
/// high peak of the autocorrelation of the mask's row sums. The strongest peak would often be a multiple of the pitch.
void add_picture(const cv::Mat& bgr, const LabelRuns& labels, TextureStatistics& statistics);

/// The power of the picture's luminance, averaged over all directions, in dB: in bands of a third of an octave, from the
/// band that ends at half a cycle a px down to a band of four cycles along the picture's shorter side.
std::vector<double> luminance_spectrum_db(const cv::Mat& bgr);

/// Distances between two sets of statistics; none where one of the sets has no such value.
struct TextureDistances {
  std::optional<double> sizes, elongations, joints;  // Kolmogorov-Smirnov, 0 to 1
  std::optional<double> angles;                      // Kuiper, 0 to 1
  std::optional<double> pitch_ratio;                 // mean row pitch of the texture by that of the photo
  std::optional<double> covered;                     // of the texture less that of the photo
  std::optional<double> spectrum_db;                 // mean absolute difference of bands that both have
};

TextureDistances texture_distances(const TextureStatistics& photo, const TextureStatistics& texture);

/// The largest difference of two samples' distribution functions. None where a sample is empty.
std::optional<double> kolmogorov_smirnov_distance(const std::vector<double>& a, const std::vector<double>& b);

/// The sum of the largest differences above and below. It serves values on a circle, as it does not depend on where the
/// circle begins. None where a sample is empty.
std::optional<double> kuiper_distance(const std::vector<double>& a, const std::vector<double>& b);

/// The distances which one in twenty pairs of independent samples exceeds, if both are of one distribution. `a`, `b`: sizes
/// of the samples. None where a sample is empty. Source: the limits for large samples, which are a little too large for
/// small ones. Copies of a photo's elements are no independent sample, so these distances give only a scale.
std::optional<double> kolmogorov_smirnov_by_chance(std::size_t a, std::size_t b);
std::optional<double> kuiper_by_chance(std::size_t a, std::size_t b);

}  // namespace tessera::bench
