#include "bench/blocking/silhouettes.h"

#include <algorithm>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <set>

#include "artwork/images/image_decoding.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "files/regular_file.h"

namespace tessera::bench {
namespace {

constexpr int kMargin_px = 4;
constexpr double kHalf = 127;
constexpr std::size_t kMostSilhouetteBytes = std::size_t(64) << 20;

std::vector<std::filesystem::path> pngs_of(const std::string& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".png") paths.push_back(entry.path());
  }
  if (error) throw InputError("--shapes: cannot read the folder " + folder + ": " + error.message());
  if (paths.empty()) throw InputError("--shapes: found no PNG in " + folder + "; needed: silhouettes, white on black");
  std::sort(paths.begin(), paths.end());
  return paths;
}

Silhouette read_silhouette(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> bytes = read_regular_file(path.string(), kMostSilhouetteBytes);
  cv::Mat grey = decode_image(bytes, path.string(), PixelBits::eight).pixels;
  if (grey.channels() == 3) cv::cvtColor(grey, grey, cv::COLOR_BGR2GRAY);
  if (grey.channels() == 4) cv::cvtColor(grey, grey, cv::COLOR_BGRA2GRAY);
  Silhouette silhouette{path.stem().string(), largest_part(grey)};
  if (silhouette.mask.empty()) throw InputError(path.string() + ": all is black; needed: a silhouette, white on black");
  return silhouette;
}

}  // namespace

cv::Mat largest_part(const cv::Mat& grey) {
  cv::Mat mask, labels, statistics, centroids;
  cv::copyMakeBorder(grey > kHalf, mask, kMargin_px, kMargin_px, kMargin_px, kMargin_px, cv::BORDER_CONSTANT, 0);
  const int count = cv::connectedComponentsWithStats(mask, labels, statistics, centroids, 8);
  int largest = 0;
  int most = 0;
  for (int label = 1; label < count; ++label) {
    const int area = statistics.at<int>(label, cv::CC_STAT_AREA);
    if (area <= most) continue;
    most = area;
    largest = label;
  }
  if (largest == 0) return {};
  return labels == largest;
}

std::vector<Silhouette> read_silhouettes(const std::string& folder) {
  const std::vector<std::filesystem::path> paths = pngs_of(folder);
  std::vector<Silhouette> silhouettes(paths.size());
  parallel_for(paths.size(), [&](std::size_t i) { silhouettes[i] = read_silhouette(paths[i]); });
  return silhouettes;
}

std::string class_of(const Silhouette& silhouette) { return silhouette.name.substr(0, silhouette.name.rfind('-')); }

std::vector<Silhouette> first_of_each_class(std::vector<Silhouette> silhouettes) {
  std::set<std::string> classes;
  std::erase_if(silhouettes,
                [&](const Silhouette& silhouette) { return !classes.insert(class_of(silhouette)).second; });
  return silhouettes;
}

}  // namespace tessera::bench
