#include "artwork/protocol/drawer_protocol.h"

#include <algorithm>

#include "artwork/images/image_decoding.h"
#include "core/base/version.h"

namespace tessera {
namespace {

constexpr std::size_t kMebibyte = std::size_t(1) << 20;

std::size_t most_result_bytes(const DrawingRequest& request) {
  const std::size_t side_px = std::size_t(std::max(0, request.longest_side_px));
  switch (request.kind) {
    case DrawingKind::page:
    case DrawingKind::uncut_page:
    case DrawingKind::png:
    case DrawingKind::whole: return 4 * side_px * side_px;
    case DrawingKind::natural_size: return 2 * sizeof(double);
    case DrawingKind::svg_import:
    case DrawingKind::warped_svg:
    case DrawingKind::outlines: return 64 * kMebibyte;
    case DrawingKind::shape: return 16 * kMebibyte;
    case DrawingKind::pdf:
    case DrawingKind::plain_pdf: return 512 * kMebibyte;
    case DrawingKind::photo:
    case DrawingKind::labels: return 4 * std::size_t(kMaxImagePixels);
  }
  return 0;
}

}  // namespace

DrawerBuild this_build() {
  DrawerBuild build{.header_bytes = {sizeof(RequestHeader), sizeof(AnswerHeader)}};
  const std::string name = std::string(program_version()) + ", commit " + program_commit();
  std::copy_n(name.begin(), std::min(name.size(), build.name.size() - 1), build.name.begin());
  return build;
}

std::size_t most_answer_bytes(const DrawingRequest& request) {
  return std::max(kMostReasonBytes, most_result_bytes(request));
}

RequestHeader header_of(const DrawingRequest& request) {
  return {.kind = request.kind,
          .longest_side_px = request.longest_side_px,
          .width_pt = request.width_pt,
          .px_per_inch = request.px_per_inch,
          .pad_levels = request.tracing.pad.levels,
          .pad_delta_tau = request.tracing.pad.delta_tau,
          .edge_opacity = request.tracing.rules.edge_opacity,
          .keep_rectangles = request.tracing.rules.keep_rectangles,
          .fill_holes = request.tracing.rules.fill_holes,
          .opaque = request.tracing.rules.opaque,
          .path_bytes = request.path.size(),
          .scope_id_bytes = request.scope_id.size(),
          .warp_bytes = request.warp.size(),
          .bytes = request.bytes.size()};
}

}  // namespace tessera
