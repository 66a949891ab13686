#include "job/millimetres.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "text/number_text.h"

namespace tessera {
namespace {

constexpr double kDecimals = 1000;  // of the ranges in mm
constexpr std::string_view kInPx = "_px";
constexpr std::string_view kInMm = "_mm";

bool is_wide(const CanvasSpec& canvas) { return canvas.width_mm >= canvas.height_mm; }

std::string size_text(int width_px, int height_px) {
  return "[" + std::to_string(width_px) + ", " + std::to_string(height_px) + "]";
}

std::string size_mm_text(const CanvasSpec& canvas) {
  return "[" + fixed(canvas.width_mm, 3) + ", " + fixed(canvas.height_mm, 3) + "]";
}

int rounded_px(double length_mm, double px_per_mm) { return int(std::lround(length_mm * px_per_mm)); }

}  // namespace

double px_per_mm(const CanvasSpec& canvas) {
  if (canvas.width_mm == 0) return 0;
  return is_wide(canvas) ? canvas.width_px / canvas.width_mm : canvas.height_px / canvas.height_mm;
}

void set_default_px(CanvasSpec& canvas) {
  const double px = kPaperCanvasSide_px / std::max(canvas.width_mm, canvas.height_mm);
  canvas.width_px = rounded_px(canvas.width_mm, px);
  canvas.height_px = rounded_px(canvas.height_mm, px);
  const int least_px = int(find_job_key("canvas", "size_px")->min);
  if (std::min(canvas.width_px, canvas.height_px) >= least_px) return;
  throw InputError("canvas.size_mm: found " + size_mm_text(canvas) + ", which makes " +
                   size_text(canvas.width_px, canvas.height_px) + " px; allowed: " + std::to_string(least_px) +
                   " px or more each, with a canvas.size_px");
}

void check_aspect(const CanvasSpec& canvas) {
  const double px = px_per_mm(canvas);
  const int width_px = rounded_px(canvas.width_mm, px);
  const int height_px = rounded_px(canvas.height_mm, px);
  if (std::abs(width_px - canvas.width_px) <= 1 && std::abs(height_px - canvas.height_px) <= 1) return;
  throw InputError("canvas.size_px: found " + size_text(canvas.width_px, canvas.height_px) +
                   ", allowed with a canvas.size_mm of " + size_mm_text(canvas) + ": the same aspect ratio, such as " +
                   size_text(width_px, height_px));
}

bool is_canvas_length(const JobKey& key) {
  using enum JobKind;
  return key.name.ends_with(kInPx) && (key.kind == number || key.kind == intervals || key.kind == point);
}

std::string name_in_px(const std::string& name_in_mm) {
  if (!name_in_mm.ends_with(kInMm)) return {};
  return name_in_mm.substr(0, name_in_mm.size() - kInMm.size()).append(kInPx);
}

JobKey key_in_mm(const JobKey& key_in_px, double px_per_mm) {
  JobKey key = key_in_px;
  key.name.replace(key.name.size() - kInPx.size(), kInPx.size(), kInMm);
  key.unit = "mm";
  key.min = std::ceil(key.min / px_per_mm * kDecimals) / kDecimals;
  key.max = std::floor(key.max / px_per_mm * kDecimals) / kDecimals;
  return key;
}

JobValue value_in_px(const JobKey& key_in_px, JobValue value_in_mm, double px_per_mm) {
  for (double& number : value_in_mm.numbers) {
    number = std::clamp(number * px_per_mm, key_in_px.min, key_in_px.max);
  }
  return value_in_mm;
}

}  // namespace tessera
