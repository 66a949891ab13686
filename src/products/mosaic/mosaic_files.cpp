#include "products/mosaic/mosaic_files.h"

#include <algorithm>
#include <filesystem>
#include <opencv2/imgproc.hpp>
#include <span>
#include <string_view>

#include "artwork/artwork_render.h"
#include "artwork/images/colour_conversion.h"
#include "artwork/images/png_encoder.h"
#include "core/base/error.h"
#include "files/atomic_file.h"
#include "files/regular_file.h"
#include "job/path_in_job.h"
#include "products/elements/photo_extraction.h"
#include "products/mosaic/face_search.h"
#include "products/mosaic/haar_cascade_file.h"
#include "products/mosaic/mosaic_job.h"
#include "products/mosaic/saliency.h"
#include "products/mosaic/segmentation.h"
#include "products/mosaic/size_map.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

using Bytes = std::vector<std::uint8_t>;

/// Width in smallest pieces: a narrower face cannot be shown.
constexpr double kNarrowestFace = 4;

/// Limit of an existing file that is compared with the new one.
constexpr std::size_t kMostOwnBytes = std::size_t(64) << 20;

cv::Mat read_image(const std::string& path, Drawers& drawers) {
  cv::Mat bgr;
  cv::cvtColor(drawers.photo(read_regular_file(path, kMaxPhotoBytes), path), bgr, cv::COLOR_BGRA2BGR);
  return bgr;
}

MosaicPlan plan_for(const MosaicRequest& request, const cv::Mat& image) {
  try {
    return mosaic_plan(image.size(), request.pieces);
  } catch (const InputError& error) {
    throw InputError(request.image + ": " + error.what());
  }
}

bool same_file(const std::string& one, const std::string& other) {
  std::error_code error;
  return fs::equivalent(one, other, error);
}

/// Refuses to write over a file that is read.
void check_is_not_read(const std::string& output, const MosaicRequest& request) {
  std::vector<std::string> read = request.libraries;
  read.push_back(request.image);
  if (!request.salient.empty()) read.push_back(request.salient);
  for (const std::string& input : read) {
    if (same_file(output, input))
      throw InputError("--job " + request.job + ": would write " + output + ", which is read; allowed: another name");
  }
}

bool is_mosaic_job(const Bytes& bytes) {
  const std::string_view mark(kMosaicJobMark);
  return bytes.size() >= mark.size() && std::equal(mark.begin(), mark.end(), bytes.begin());
}

bool holds(const std::string& path, std::span<const std::uint8_t> bytes) {
  return fs::exists(path) && std::ranges::equal(read_regular_file(path, kMostOwnBytes), bytes);
}

/// Refuses to replace an existing file, which may have been edited. It goes only with --replace, and only if it belongs to
/// a mosaic. A map belongs to the job beside it.
void check_replaceable(const std::string& output, std::span<const std::uint8_t> bytes, const MosaicRequest& request) {
  if (!fs::exists(output) || holds(output, bytes)) return;
  if (!fs::exists(request.job) || !is_mosaic_job(read_regular_file(request.job, kMostOwnBytes)))
    throw InputError(output + ": exists and was not made by tessera mosaic; give another name with --job");
  if (!request.replace) {
    throw InputError(output + ": exists with other content; tessera collage " + request.job +
                     " runs the job as it is, --replace overwrites it, --job gives it another name");
  }
}

void check_regions(int regions) {
  if (regions >= 1 && regions <= kMostMosaicRegions) return;
  throw InputError("--regions: found " + std::to_string(regions) + ", allowed: from 1 to " +
                   std::to_string(kMostMosaicRegions));
}

/// Refuses another aspect: a stretched picture would mark other places than it was painted for.
void check_aspect(cv::Size found, cv::Size image) {
  constexpr double kMostStretched = 0.02;
  const double stretched = double(found.width) * image.height / (double(found.height) * image.width);
  if (std::abs(stretched - 1) <= kMostStretched) return;
  const auto text = [](cv::Size size) { return std::to_string(size.width) + " x " + std::to_string(size.height); };
  throw InputError("found " + text(found) + " px, allowed: the aspect of the image, " + text(image) + " px");
}

/// Reads the saliency. `path`: a grey picture with the image's aspect.
cv::Mat painted_saliency(const std::string& path, cv::Size image, cv::Size size, Drawers& drawers) {
  const cv::Mat picture = drawers.whole_picture(read_regular_file(path, kMaxPhotoBytes), path, kMaxArtworkSide_px);
  try {
    check_aspect(picture.size(), image);
    return saliency_of_picture(picture, size);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

/// Reads the cascade. The file belongs to the machine and not to the request, so a damaged one is an EnvironmentError.
HaarCascade read_cascade(const std::string& path) {
  try {
    return read_haar_cascade(path);
  } catch (const InputError& error) {
    throw EnvironmentError(error.what());
  }
}

/// Finds faces; empty where they are not searched.
std::optional<std::vector<Face>> faces_for(const MosaicRequest& request, const cv::Mat& image, const MosaicPlan& plan) {
  std::error_code none;
  if (!request.salient.empty() || !fs::exists(request.face_cascade, none)) return std::nullopt;
  return find_faces(image, read_cascade(request.face_cascade),
                    kNarrowestFace * plan.min_scale_px / plan.canvas_px.width);
}

cv::Mat saliency_of(const std::vector<Face>& faces, const MosaicPlan& plan) {
  return saliency_of_faces(faces, size_map_size(plan), plan.min_scale_px / kSizeMapPixel_px);
}

}  // namespace

std::string size_map_path(const std::string& job) { return path_beside_job(job, "_sizes.png"); }

std::string region_picture_path(const std::string& job) { return path_beside_job(job, "_regions.png"); }

Mosaic make_mosaic(const MosaicRequest& request, Drawers& drawers) {
  check_regions(request.regions);
  const std::string map_path = size_map_path(request.job), picture_path = region_picture_path(request.job);
  check_is_not_read(request.job, request);
  check_is_not_read(map_path, request);
  check_is_not_read(picture_path, request);
  MosaicFiles files{.image = path_in_job(request.image, request.job),
                    .libraries = {},
                    .size_map = fs::path(map_path).filename().string(),
                    .regions = {}};
  for (const std::string& library : request.libraries) files.libraries.push_back(path_in_job(library, request.job));

  const cv::Mat image = read_image(request.image, drawers);
  const MosaicPlan plan = plan_for(request, image);
  const std::optional<std::vector<Face>> faces = faces_for(request, image, plan);
  const cv::Mat saliency = request.salient.empty()
                               ? saliency_of(faces.value_or(std::vector<Face>()), plan)
                               : painted_saliency(request.salient, image.size(), size_map_size(plan), drawers);
  Mosaic mosaic{
      .plan = plan, .faces = {}, .regions = 0, .files = {{map_path, png_of(size_map(image, plan, saliency))}}};
  if (faces) mosaic.faces = int(faces->size());
  std::vector<std::string> regions;
  if (const Segmentation found = segmentation(image, plan, request.regions); found.colours.size() > 1) {
    for (const cv::Vec3b& colour : found.colours) regions.push_back(hex_of(colour));
    files.regions = fs::path(picture_path).filename().string();
    mosaic.files.push_back({picture_path, png_of(region_picture(found, plan))});
  }
  const std::string text = mosaic_job(files, plan, mosaic_variety(plan, request.shapes), request.shift, regions);
  mosaic.files.push_back({request.job, Bytes(text.begin(), text.end())});
  for (const MosaicFile& file : mosaic.files) check_replaceable(file.path, file.bytes, request);
  mosaic.regions = int(regions.size());
  return mosaic;
}

std::vector<std::string> write_mosaic(const Mosaic& mosaic) {
  std::vector<std::string> new_files;
  for (const MosaicFile& file : mosaic.files) {
    if (!fs::exists(file.path)) new_files.push_back(file.path);
    if (!holds(file.path, file.bytes)) write_file_atomically(file.path, file.bytes);
  }
  return new_files;
}

}  // namespace tessera
