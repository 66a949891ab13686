#include "products/texture/texture_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "artwork/images/image_decoding.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "files/atomic_file.h"
#include "job/job_keys.h"
#include "job/path_in_job.h"
#include "library/library_builder.h"
#include "library/library_view.h"
#include "products/texture/element_pitch.h"
#include "products/texture/layout_relaxation.h"
#include "products/texture/texture_layout.h"
#include "products/texture/texture_pieces.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

/// The least side of elements for good outlines, canvas px. Photos with smaller ones are enlarged.
constexpr double kLeastElement_px = 40;
/// The longest side of a canvas.
constexpr int kMostCanvasSide_px = 20'000;
/// Sides of the texture for one of the photo, where nobody gave a size.
constexpr double kSides = 2;
constexpr int kGroundSide_px = 512;
/// How much more often than the mean an element may come.
constexpr double kMostByMean = 2;
constexpr std::uint64_t kSeed = 1;

std::string name_of(const std::string& path) { return fs::path(path).filename().string(); }

Extraction extracted(const TextureRequest& request, Drawers& drawers) {
  Extraction extraction = extract_elements(request.photo, texture_extraction(request), drawers);
  if (!extraction.cut_outs.empty()) return extraction;
  throw InputError(request.photo +
                   ": found no whole element; allowed: a photo of many elements, or --element-px, the short side of a "
                   "typical one in px");
}

void build(const Extraction& extraction, const std::string& output, Drawers& drawers) {
  LibraryBuildSettings settings;
  settings.files_at_a_time = rank_cores();
  settings.keep_twins = true;  // each stands where it stands in the photo
  settings.tracing.rules = {.keep_rectangles = true, .fill_holes = true};
  ArtworkFiles files;
  for (const CutOut& cut_out : extraction.cut_outs) files.paths.push_back(cut_out.path);
  const LibraryBuildReport report =
      build_library(files, output, settings, cut_out_loader(drawers, extraction.cut_outs, settings.tracing),
                    [](std::size_t, std::size_t) {});
  if (!report.written) throw InputError(output + " was not written: no element has a usable silhouette");
}

/// The shapes of the library with their elements.
std::vector<ElementShape> element_shapes(const Extraction& extraction, const std::string& library) {
  std::map<std::string, std::size_t> element_of;
  for (std::size_t i = 0; i < extraction.cut_outs.size(); ++i)
    element_of[fs::path(extraction.cut_outs[i].path).stem().string()] = i;
  const LibraryView view({.files = {library}, .names = {}});
  const LibraryParts parts{.outline = true, .field = false, .levels = 0, .artwork = true, .original = false};
  std::vector<ElementShape> shapes;
  for (Shape& shape : view.read(0, view.size(), parts)) {
    const auto element = element_of.find(shape.name);
    if (element != element_of.end()) shapes.push_back({std::move(shape), extraction.found.elements[element->second]});
  }
  return shapes;
}

cv::Size texture_size(const TextureRequest& request, cv::Size enlarged_photo, int enlarged, cv::Size2d pitch_px) {
  if (!request.size_px.empty()) return request.size_px;
  const cv::Size photo(enlarged_photo.width / enlarged, enlarged_photo.height / enlarged);
  const double scale = std::min(kSides, double(kMostTextureSide_px) / std::max(photo.width, photo.height));
  const auto side = [&](int side_px, double pitch_px) {
    // A whole number of rows fits together at the seam.
    const double wanted = side_px * scale, pitch = pitch_px / enlarged;
    return std::max(kLeastTextureSide_px,
                    int(std::lround(pitch > 0 ? pitch * std::max(1., std::round(wanted / pitch)) : wanted)));
  };
  return {side(photo.width, pitch_px.width), side(photo.height, pitch_px.height)};
}

std::vector<LaidElement> layout_of(const Extraction& extraction, const std::vector<ElementShape>& shapes,
                                   cv::Size canvas_px) {
  std::vector<PhotoElement> elements;
  for (const ElementShape& shape : shapes) elements.push_back(shape.element);
  // An element without a shape cannot be laid.
  std::vector<LabelRole> roles = extraction.roles;
  for (LabelRole& role : roles) {
    if (role == LabelRole::element) role = LabelRole::cut;
  }
  for (const PhotoElement& element : elements) roles[std::size_t(element.label)] = LabelRole::element;
  // Shifts by whole px of the photo leave its pixels what they are.
  const PhotoLayout photo{*extraction.labels, elements, roles, extraction.enlarged};
  return relaxed_layout(photo, texture_layout(photo, canvas_px, kSeed), canvas_px);
}

/// The names of the files in the job.
TextureFiles files_of(const TextureRequest& request, const Extraction& extraction) {
  return {name_of(request.photo), name_of(texture_library_path(request.job)), name_of(texture_layout_path(request.job)),
          extraction.ground_png.empty() ? "" : name_of(texture_ground_path(request.job))};
}

TexturePlan plan_of(const TextureRequest& request, const Extraction& extraction) {
  const cv::Size photo = extraction.labels->size();
  TexturePlan plan;
  plan.enlarged = extraction.enlarged;
  plan.element_px = mean_side_px(extraction.found.elements);
  plan.texture_px = texture_size(request, photo, plan.enlarged, element_pitch_px(*extraction.labels, plan.element_px));
  // Some elements come more often than others, and some more for the gaps.
  const double copies = double(plan.texture_px.area()) * plan.enlarged * plan.enlarged / photo.area();
  plan.uses = int(std::ceil(kMostByMean * copies)) + 1;
  return plan;
}

}  // namespace

std::string texture_library_path(const std::string& job) { return path_beside_job(job, ".h5"); }
std::string texture_layout_path(const std::string& job) { return path_beside_job(job, "_layout.geojson"); }
std::string texture_ground_path(const std::string& job) { return path_beside_job(job, "_ground.png"); }

ExtractionSettings texture_extraction(const TextureRequest& request) {
  ExtractionSettings settings;
  settings.element_px = request.element_px;
  settings.labels = request.labels;
  settings.enlarged_element_px = kLeastElement_px;
  // The canvas, which is enlarged, too, must not become too large for a job.
  settings.most_enlarged_px2 = kMaxCanvas_px2 / ((kSides + 0.1) * (kSides + 0.1));
  if (const cv::Size size = request.size_px; !size.empty()) {
    const double by_area = std::sqrt(kMaxCanvas_px2 / (double(size.width) * size.height));
    settings.most_enlarged = std::min(int(by_area), kMostCanvasSide_px / std::max(size.width, size.height));
    settings.most_enlarged_px2 = kMaxImagePixels;
  }
  settings.ground_px = kGroundSide_px;
  return settings;
}

TextureDraft draft_texture(const TextureRequest& request, Drawers& drawers) {
  TextureDraft draft{extracted(request, drawers), {}, {}};
  draft.plan = plan_of(request, draft.extraction);
  draft.job = texture_job(files_of(request, draft.extraction), draft.plan);
  return draft;
}

std::size_t write_texture_files(const TextureRequest& request, const TextureDraft& draft, cv::Size canvas_px,
                                Drawers& drawers) {
  const Extraction& extraction = draft.extraction;
  const std::string library = texture_library_path(request.job);
  build(extraction, library, drawers);
  if (!extraction.ground_png.empty()) write_file_atomically(texture_ground_path(request.job), extraction.ground_png);
  const std::vector<ElementShape> shapes = element_shapes(extraction, library);
  const std::vector<LaidElement> layout = layout_of(extraction, shapes, canvas_px);
  write_file_atomically(texture_layout_path(request.job), texture_pieces(layout, shapes, canvas_px));
  return layout.size();
}

}  // namespace tessera
