#include "cli/card_run.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/collage/quality.h"
#include "io/job/canvas_file.h"
#include "io/job/canvas_page.h"
#include "io/job/job_keys.h"
#include "io/job/wished_sizes.h"
#include "io/number_text.h"
#include "io/result/card_output.h"
#include "io/result/polygon_pieces.h"

namespace tessera::cli {
namespace {

constexpr double kSmallest_px = 0.01;  // a piece that may be read (io/result/polygon_pieces.h) is as large

/// What pieces are held against.
struct Frame {
  Canvas canvas;
  std::optional<SizeRange> sizes;
};

std::string size_text(double width_px, double height_px) {
  return io::fixed(width_px, 0) + " x " + io::fixed(height_px, 0) + " px";
}

/// As canvas.size_px allows. `key` begins the message.
void check_size(const std::string& key, double width_px, double height_px) {
  const io::JobKey& size = *io::find_job_key("canvas", "size_px");
  const auto allowed = [&](double side_px) { return side_px >= size.min && side_px <= size.max; };
  if (allowed(width_px) && allowed(height_px) && width_px * height_px <= io::kMaxCanvas_px2) return;
  throw InputError(key + ": found " + size_text(width_px, height_px) + ", allowed: " + io::fixed(size.min, 0) + " to " +
                   io::fixed(size.max, 0) + " each, " + io::fixed(io::kMaxCanvas_px2 / 1e6, 0) + " million px in all");
}

/// As large as --size says, or as it was drawn.
Canvas canvas_in_file(const CardArguments& arguments) {
  io::CanvasSpec spec{.file = arguments.canvas};
  if (arguments.size_px.empty()) {
    const std::vector<std::uint8_t> bytes = io::read_canvas_file(arguments.canvas, "--canvas");
    io::Drawers drawers(io::canvas_drawer_settings(spec));
    const cv::Size2d drawn = drawers.natural_size(bytes, arguments.canvas);
    check_size("--canvas " + arguments.canvas, std::round(drawn.width), std::round(drawn.height));
    spec.width_px = int(std::lround(drawn.width));
    spec.height_px = int(std::lround(drawn.height));
  } else {
    spec.width_px = arguments.size_px[0];
    spec.height_px = arguments.size_px[1];
  }
  return io::load_canvas(spec);
}

Frame frame_of_job(const CardArguments& arguments) {
  if (!arguments.size_px.empty()) {
    throw InputError("--size: found beside the job " + arguments.canvas + ", allowed: nothing, as the job says it");
  }
  const io::Job job = io::load_job(arguments.canvas, {});
  return {io::canvas_of(job), io::wished_sizes(job)};
}

Frame frame_of(const CardArguments& arguments) {
  if (!arguments.size_px.empty()) check_size("--size", arguments.size_px[0], arguments.size_px[1]);
  if (arguments.canvas.ends_with(".toml")) return frame_of_job(arguments);
  if (!arguments.canvas.empty()) return {canvas_in_file(arguments), {}};
  if (!arguments.size_px.empty()) return {make_rectangle_canvas(arguments.size_px[0], arguments.size_px[1]), {}};
  throw InputError("--canvas: found nothing, allowed: an SVG, an image or a job.toml; or --size W,H, a rectangle");
}

/// As few digits as give the same number back: "20", "1e-310".
std::string short_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

SizeRange checked_sizes(const std::vector<double>& sizes_px) {
  const io::JobKey& scale = *io::find_job_key("pieces", "scale_px");
  if (sizes_px[0] >= kSmallest_px && sizes_px[0] <= sizes_px[1] && sizes_px[1] <= scale.max) {
    return {sizes_px[0], sizes_px[1]};
  }
  throw InputError("--sizes: found " + short_text(sizes_px[0]) + "," + short_text(sizes_px[1]) +
                   ", allowed: MIN,MAX from " + io::fixed(kSmallest_px, 2) + " to " + io::fixed(scale.max, 0) + " px");
}

/// The folder of a result says what was to be filled, too.
CardArguments of_folder(CardArguments arguments) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = arguments.pieces;
  if (!fs::is_directory(folder, error)) return arguments;
  arguments.pieces = (folder / "pieces.geojson").string();
  if (arguments.canvas.empty() && arguments.size_px.empty()) arguments.canvas = (folder / "job.toml").string();
  return arguments;
}

}  // namespace

int run_card(const CardArguments& given) {
  const CardArguments arguments = of_folder(given);
  Frame frame = frame_of(arguments);
  if (!arguments.sizes_px.empty()) frame.sizes = checked_sizes(arguments.sizes_px);
  const std::vector<JudgedPiece> pieces = io::read_polygon_pieces(arguments.pieces, frame.canvas);
  const Quality quality = measure_quality(frame.canvas, pieces, frame.sizes);
  print_lines(arguments.json ? io::score_json(quality) : io::score_text(quality));
  return 0;
}

}  // namespace tessera::cli
