#include "run/card_run.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>

#include "core/base/error.h"
#include "core/quality/quality.h"
#include "job/canvas/canvas_file.h"
#include "job/canvas/canvas_page.h"
#include "job/job_keys.h"
#include "job/pieces/wished_sizes.h"
#include "result/card_output.h"
#include "result/mosaic_file.h"
#include "result/polygon_pieces.h"
#include "terminal/terminal.h"
#include "text/number_text.h"

namespace tessera {
namespace {

constexpr double kSmallest_px = 0.01;  // the least size that result/polygon_pieces.h reads

/// The canvas, and the sizes, that pieces are compared with.
struct Frame {
  Canvas canvas;
  std::optional<SizeRange> sizes;
};

std::string size_text(double width_px, double height_px) {
  return fixed(width_px, 0) + " x " + fixed(height_px, 0) + " px";
}

/// Refuses a size that canvas.size_px does not allow. `key` begins the message.
void check_size(const std::string& key, double width_px, double height_px) {
  const JobKey& size = *find_job_key("canvas", "size_px");
  const auto allowed = [&](double side_px) { return side_px >= size.min && side_px <= size.max; };
  if (allowed(width_px) && allowed(height_px) && width_px * height_px <= kMaxCanvas_px2) return;
  throw InputError(key + ": found " + size_text(width_px, height_px) + ", allowed: " + fixed(size.min, 0) + " to " +
                   fixed(size.max, 0) + " each, " + fixed(kMaxCanvas_px2 / 1e6, 0) + " million px in all");
}

/// Reads the canvas in the size of --size, or in the size in which it was drawn.
Canvas canvas_in_file(const CardArguments& arguments) {
  CanvasSpec spec{.file = arguments.canvas};
  if (arguments.size_px.empty()) {
    const std::vector<std::uint8_t> bytes = read_canvas_file(arguments.canvas, "--canvas");
    Drawers drawers(canvas_drawer_settings(spec));
    const cv::Size2d drawn = drawers.natural_size(bytes, arguments.canvas);
    check_size("--canvas " + arguments.canvas, std::round(drawn.width), std::round(drawn.height));
    spec.width_px = int(std::lround(drawn.width));
    spec.height_px = int(std::lround(drawn.height));
  } else {
    spec.width_px = arguments.size_px[0];
    spec.height_px = arguments.size_px[1];
  }
  return load_canvas(spec);
}

Frame frame_of_job(const CardArguments& arguments) {
  if (!arguments.size_px.empty()) {
    throw InputError("--size: found beside the job " + arguments.canvas + ", allowed: nothing, as the job says it");
  }
  const Job job = load_job(arguments.canvas, {});
  return {canvas_of(job), wished_sizes(job)};
}

Frame frame_of(const CardArguments& arguments) {
  if (!arguments.size_px.empty()) check_size("--size", arguments.size_px[0], arguments.size_px[1]);
  if (arguments.canvas.ends_with(".toml")) return frame_of_job(arguments);
  if (!arguments.canvas.empty()) return {canvas_in_file(arguments), {}};
  if (!arguments.size_px.empty()) return {make_rectangle_canvas(arguments.size_px[0], arguments.size_px[1]), {}};
  throw InputError("--canvas: found nothing, allowed: an SVG, an image or a job.toml; or --size W,H, a rectangle");
}

/// The number with as few digits as give the same number back: "20", "1e-310".
std::string short_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

SizeRange checked_sizes(const std::vector<double>& sizes_px) {
  const JobKey& scale = *find_job_key("pieces", "scale_px");
  if (sizes_px[0] >= kSmallest_px && sizes_px[0] <= sizes_px[1] && sizes_px[1] <= scale.max) {
    return {sizes_px[0], sizes_px[1]};
  }
  throw InputError("--sizes: found " + short_text(sizes_px[0]) + "," + short_text(sizes_px[1]) +
                   ", allowed: MIN,MAX from " + fixed(kSmallest_px, 2) + " to " + fixed(scale.max, 0) + " px");
}

bool is_folder(const CardArguments& arguments) {
  std::error_code error;
  return std::filesystem::is_directory(arguments.pieces, error);
}

bool has_canvas(const CardArguments& arguments) { return !arguments.canvas.empty() || !arguments.size_px.empty(); }

std::string in_folder(const CardArguments& folder, const char* name) {
  return (std::filesystem::path(folder.pieces) / name).string();
}

/// Takes canvas and pieces from the folder of a result.
CardArguments of_folder(CardArguments arguments) {
  if (!has_canvas(arguments)) arguments.canvas = in_folder(arguments, "job.toml");
  arguments.pieces = in_folder(arguments, "pieces.geojson");
  return arguments;
}

/// How well collage.png in a result's folder shows the picture of its job, or of --image. Empty where the job has none, or
/// where the result is compared with another canvas.
std::optional<AfarNote> seen_in_folder(const CardArguments& folder, const Canvas& canvas, std::size_t pieces) {
  const std::string of_job = load_job(in_folder(folder, "job.toml"), {}).colour.image;
  if (!folder.image.empty())
    return AfarNote{mosaic_from_afar(in_folder(folder, "collage.png"), {folder.image}, canvas, pieces), {}};
  if (of_job.empty()) return {};
  try {
    return AfarNote{mosaic_from_afar(in_folder(folder, "collage.png"), {of_job, "colour.image"}, canvas, pieces), {}};
  } catch (const InputError& error) {  // pieces are measured all the same
    return AfarNote{{}, error.what()};
  }
}

struct Card {
  std::optional<Quality> quality;
  std::optional<AfarNote> afar;
};

Card card_of_pieces(const CardArguments& given) {
  const bool folder = is_folder(given);
  const CardArguments arguments = folder ? of_folder(given) : given;
  Frame frame = frame_of(arguments);
  if (!arguments.sizes_px.empty()) frame.sizes = checked_sizes(arguments.sizes_px);
  const std::vector<JudgedPiece> pieces = read_polygon_pieces(arguments.pieces, frame.canvas);
  Card card;
  card.quality = measure_quality(frame.canvas, pieces, frame.sizes);
  if (folder && !has_canvas(given)) card.afar = seen_in_folder(given, frame.canvas, pieces.size());
  return card;
}

/// Makes the card of a mosaic that is only a picture, beside the picture that it shows.
Card card_of_picture(const CardArguments& arguments) {
  if (!arguments.sizes_px.empty()) throw InputError("--sizes: found beside --image, allowed: with pieces as polygons");
  if (!arguments.size_px.empty() && arguments.canvas.empty()) {
    throw InputError("--size: found beside --image, allowed: with --canvas FILE; else the picture has its size");
  }
  const ShownImage image{arguments.image};
  const auto pieces = std::size_t(arguments.shown_pieces);
  Card card;
  card.afar.emplace();
  card.afar->seen = arguments.canvas.empty()
                        ? mosaic_from_afar(arguments.pieces, image, pieces)
                        : mosaic_from_afar(arguments.pieces, image, frame_of(arguments).canvas, pieces);
  return card;
}

/// Refuses options that do not fit the kind of RESULT: a folder, polygons or a picture.
void check_kind(const CardArguments& arguments) {
  const bool picture = !is_folder(arguments) && !arguments.image.empty();
  if (arguments.shown_pieces > 0 && !picture) {
    throw InputError("--pieces: found without --image, allowed: with a picture; polygons are counted");
  }
  if (is_folder(arguments) && !arguments.image.empty() && has_canvas(arguments)) {
    throw InputError("--image: found beside --canvas or --size and a folder, allowed: in the canvas of its job");
  }
  if (arguments.image.empty() && looks_like_picture(arguments.pieces)) {
    throw InputError(arguments.pieces +
                     ": found a picture, allowed: polygons; with --image FILE, the picture that it " +
                     "shows, it is measured from afar");
  }
}

}  // namespace

int run_card(const CardArguments& arguments) {
  check_kind(arguments);
  const bool pieces = arguments.image.empty() || is_folder(arguments);
  const Card card = pieces ? card_of_pieces(arguments) : card_of_picture(arguments);
  print_lines(arguments.json ? score_json(card.quality, card.afar) : score_text(card.quality, card.afar));
  return 0;
}

}  // namespace tessera
