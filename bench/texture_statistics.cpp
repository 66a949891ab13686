#include "texture_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "products/texture/element_pitch.h"

namespace tessera::bench {
namespace {

// Spectrum: bands in an octave, the highest frequency in cycles a px, and the least cycles along the picture's shorter side.
// A Hann window blurs by two cycles.
constexpr int kBandsPerOctave = 3;
constexpr double kHighestFrequency = 0.5;
constexpr double kLeastCycles = 4;
/// Power of a plain area: far below one grey level's, so that logarithms are finite.
constexpr double kNoPower = 1e-6;

/// The 95 % points of the limit distributions, for one sample of one value.
constexpr double kKolmogorovSmirnov95 = 1.358;
constexpr double kKuiper95 = 1.747;

/// How far the distribution function of `a` is above and below that of `b` at most.
struct Deviations {
  double above = 0, below = 0;
};

std::optional<Deviations> deviations(std::vector<double> a, std::vector<double> b) {
  if (a.empty() || b.empty()) return {};
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  Deviations most;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double value = std::min(a[i], b[j]);
    while (i < a.size() && a[i] == value) ++i;
    while (j < b.size() && b[j] == value) ++j;
    const double difference = double(i) / double(a.size()) - double(j) / double(b.size());
    most.above = std::max(most.above, difference);
    most.below = std::max(most.below, -difference);
  }
  return most;
}

/// `of_one`: the distance for one sample of one value. Distances shrink with the square root of a sample's size.
std::optional<double> by_chance(double of_one, std::size_t a, std::size_t b) {
  if (a == 0 || b == 0) return {};
  return of_one * std::sqrt(1 / double(a) + 1 / double(b));
}

std::optional<double> mean_of(const std::vector<double>& values) {
  if (values.empty()) return {};
  return std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
}

/// The axes of an element's pixels, each of them a square.
struct Axes {
  double elongation = 1;
  double angle_rad = 0;  // of the major axis, 0 to pi
};

Axes axes_of(const cv::Mat& mask) {
  const cv::Moments m = cv::moments(mask, true);
  const double of_pixel = m.m00 / 12;
  const double xx = m.mu20 + of_pixel, yy = m.mu02 + of_pixel;
  const double middle = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, m.mu11);
  const double angle_rad = std::atan2(2 * m.mu11, xx - yy) / 2;
  return {std::sqrt((middle - half) / (middle + half)), angle_rad < 0 ? angle_rad + CV_PI : angle_rad};
}

/// The median distance from the element's outline to other elements: pixels between them, at most the longer side of the
/// element. `labels`: CV_32S.
double joint_px(const cv::Mat& labels, int label, const cv::Rect& box) {
  const int most_px = std::max(box.width, box.height);
  const cv::Mat window = labels(grown_within(box, most_px + 1, labels.size()));
  const cv::Mat element = window == label;
  cv::Mat inside, distances;
  cv::erode(element, inside, cv::getStructuringElement(cv::MORPH_CROSS, {3, 3}));
  const cv::Mat outline = element & ~inside, no_other = element | (window == 0);
  cv::distanceTransform(no_other, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  std::vector<double> widths_px;
  for (int y = 0; y < outline.rows; ++y) {
    for (int x = 0; x < outline.cols; ++x) {
      // Neighbours without a joint are one px apart.
      if (outline.at<std::uint8_t>(y, x))
        widths_px.push_back(std::min(distances.at<float>(y, x) - 1., double(most_px)));
    }
  }
  const auto middle = widths_px.begin() + std::ptrdiff_t(widths_px.size() / 2);
  std::nth_element(widths_px.begin(), middle, widths_px.end());
  return *middle;
}

double row_pitch_px(const LabelRuns& labels) {
  double area_px2 = 0, count = 0;
  for (const RegionBox& region : labels.regions()) {
    area_px2 += region.area_px2;
    count += region.area_px2 > 0;
  }
  return count > 0 ? element_pitch_px(labels, std::sqrt(area_px2 / count)).height : 0;
}

/// The power at each frequency of a picture under a Hann window, relative to the window's own: CV_32F. Its mean is taken
/// away first.
cv::Mat power_of(const cv::Mat& bgr) {
  cv::Mat grey, window, spectrum;
  cv::cvtColor(bgr, grey, cv::COLOR_BGR2GRAY);
  grey.convertTo(grey, CV_32F);
  grey -= cv::mean(grey);
  cv::createHanningWindow(window, grey.size(), CV_32F);
  // OpenCV's window is the square root of Hann's in two dimensions.
  window = window.mul(window);
  cv::dft(grey.mul(window), spectrum, cv::DFT_COMPLEX_OUTPUT);
  cv::Mat parts[2];
  cv::split(spectrum, parts);
  return (parts[0].mul(parts[0]) + parts[1].mul(parts[1])) / window.dot(window);
}

/// The band of a frequency in cycles a px; 0 is the highest one, negative where the frequency is higher.
int band_of(double frequency) { return int(std::floor(kBandsPerOctave * std::log2(kHighestFrequency / frequency))); }

/// The cycles a px of a row or column of a discrete Fourier transform.
double frequency_of(int index, int count) { return double(std::min(index, count - index)) / count; }

std::vector<double> mean_spectrum_db(const std::vector<std::vector<double>>& spectra_db) {
  std::vector<double> mean;
  for (const std::vector<double>& spectrum : spectra_db) {
    mean.resize(std::max(mean.size(), spectrum.size()), 0);
    for (std::size_t i = 0; i < spectrum.size(); ++i) mean[i] += spectrum[i] / double(spectra_db.size());
  }
  return mean;
}

std::optional<double> spectrum_distance_db(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) differences.push_back(std::abs(a[i] - b[i]));
  return mean_of(differences);
}

}  // namespace

std::optional<double> kolmogorov_smirnov_distance(const std::vector<double>& a, const std::vector<double>& b) {
  const std::optional<Deviations> most = deviations(a, b);
  if (!most) return {};
  return std::max(most->above, most->below);
}

std::optional<double> kuiper_distance(const std::vector<double>& a, const std::vector<double>& b) {
  const std::optional<Deviations> most = deviations(a, b);
  if (!most) return {};
  return most->above + most->below;
}

std::optional<double> kolmogorov_smirnov_by_chance(std::size_t a, std::size_t b) {
  return by_chance(kKolmogorovSmirnov95, a, b);
}

std::optional<double> kuiper_by_chance(std::size_t a, std::size_t b) { return by_chance(kKuiper95, a, b); }

std::vector<double> luminance_spectrum_db(const cv::Mat& bgr) {
  const cv::Mat power = power_of(bgr);
  const int bands = band_of(kLeastCycles / std::min(bgr.cols, bgr.rows));
  std::vector<double> sums(std::size_t(std::max(0, bands)), 0), counts(sums.size(), 0);
  for (int y = 0; y < power.rows; ++y) {
    for (int x = 0; x < power.cols; ++x) {
      const double frequency = std::hypot(frequency_of(x, power.cols), frequency_of(y, power.rows));
      const int band = frequency > 0 ? band_of(frequency) : -1;
      if (band < 0 || band >= bands) continue;
      sums[std::size_t(band)] += power.at<float>(y, x);
      counts[std::size_t(band)] += 1;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = 10 * std::log10(kNoPower + sums[i] / std::max(1., counts[i]));
  return sums;
}

void add_picture(const cv::Mat& bgr, const LabelRuns& labels, TextureStatistics& statistics) {
  const cv::Mat map = labels.labels();
  for (std::size_t i = 1; i < labels.regions().size(); ++i) {
    const RegionBox& region = labels.regions()[i];
    if (region.area_px2 == 0 || reaches_edge(region.box, labels.size())) continue;
    const Axes axes = axes_of(labels.mask_of(i));
    statistics.sizes_px.push_back(std::sqrt(region.area_px2));
    statistics.elongations.push_back(axes.elongation);
    if (axes.elongation < kRoundElongation) statistics.angles_rad.push_back(axes.angle_rad);
    statistics.joints_px.push_back(joint_px(map, int(i), region.box));
  }
  if (const double pitch_px = row_pitch_px(labels); pitch_px > 0) statistics.pitches_px.push_back(pitch_px);
  statistics.covered.push_back(cv::countNonZero(labels.mask()) / double(labels.size().area()));
  statistics.spectra_db.push_back(luminance_spectrum_db(bgr));
}

TextureDistances texture_distances(const TextureStatistics& photo, const TextureStatistics& texture) {
  TextureDistances distances;
  distances.sizes = kolmogorov_smirnov_distance(photo.sizes_px, texture.sizes_px);
  distances.elongations = kolmogorov_smirnov_distance(photo.elongations, texture.elongations);
  distances.joints = kolmogorov_smirnov_distance(photo.joints_px, texture.joints_px);
  distances.angles = kuiper_distance(photo.angles_rad, texture.angles_rad);
  if (!photo.pitches_px.empty() && !texture.pitches_px.empty())
    distances.pitch_ratio = *mean_of(texture.pitches_px) / *mean_of(photo.pitches_px);
  if (!photo.covered.empty() && !texture.covered.empty())
    distances.covered = *mean_of(texture.covered) - *mean_of(photo.covered);
  distances.spectrum_db =
      spectrum_distance_db(mean_spectrum_db(photo.spectra_db), mean_spectrum_db(texture.spectra_db));
  return distances;
}

}  // namespace tessera::bench
