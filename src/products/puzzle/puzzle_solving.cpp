#include "products/puzzle/puzzle_solving.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <opencv2/imgproc.hpp>
#include <string_view>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/geometry/closed_curve.h"
#include "core/geometry/polygon.h"
#include "files/atomic_file.h"
#include "files/regular_file.h"
#include "job/canvas/canvas_edge.h"
#include "job/canvas/canvas_file.h"
#include "job/canvas/canvas_page.h"
#include "job/path_in_job.h"
#include "job/toml_string.h"
#include "library/library_view.h"
#include "products/puzzle/frame_outline.h"
#include "products/puzzle/laying/puzzle_solver.h"
#include "products/puzzle/pieces/piece_erosion.h"
#include "products/puzzle/pieces/puzzle_contact.h"
#include "products/puzzle/puzzle_geojson.h"
#include "result/placed_pieces.h"
#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJobMark = "# A puzzle solved by tessera puzzle solve";
constexpr int kLargestThumbnail_px = 1024;  // larger ones, which no library has, are shrunk
constexpr std::size_t kMostOwnBytes = std::size_t(64) << 20;

std::vector<Shape> shapes_of(const SolvingRequest& request) {
  const LibraryView library({.files = {request.library}, .names = {}});
  if (library.size() > kMostSolvedPieces) {
    throw InputError(request.library + ": found " + std::to_string(library.size()) +
                     " pieces, allowed: " + std::to_string(kMostSolvedPieces) + " or fewer");
  }
  std::vector<Shape> shapes = library.read(
      0, library.size(), {.outline = true, .field = false, .levels = 0, .artwork = !request.outlines_only});
  for (const Shape& shape : shapes) {
    if (shape.drawn_scale_px > 0) continue;
    throw InputError(request.library + ": does not say how large \"" + shape.name +
                     "\" was drawn, because an earlier version built it; tessera library build makes one that does");
  }
  return shapes;
}

/// The polygons of the pieces, px as drawn. Refuses pieces without area or as large as a whole puzzle.
std::vector<std::vector<Vec2>> polygons_of(const std::string& library, const std::vector<Shape>& shapes) {
  constexpr double kMostTimes = 32;
  std::vector<std::vector<Vec2>> polygons;
  std::vector<double> sizes;
  for (const Shape& shape : shapes) {
    const auto refuse = [&](const std::string& what) {
      throw InputError(library + ": \"" + printable_utf8(shape.name) + "\": found " + what);
    };
    if (shape.outline.curves.size() != 1) refuse("holes, allowed: pieces without");
    polygons.push_back(shape.outline.curves.front());
    for (Vec2& p : polygons.back()) p = p * shape.drawn_scale_px;
    const double area = signed_area(polygons.back());
    if (!(std::isfinite(area) && area > 0)) refuse("an outline that encloses nothing");
    sizes.push_back(std::sqrt(area));
  }
  std::vector<double> sorted = sizes;
  std::sort(sorted.begin(), sorted.end());
  const double usual = sorted.empty() ? 0 : sorted[sorted.size() / 2];
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i] <= usual * kMostTimes && sizes[i] >= usual / kMostTimes) continue;
    throw InputError(library + ": \"" + printable_utf8(shapes[i].name) + "\": found a piece of " + fixed(sizes[i], 1) +
                     " px where half are of " + fixed(usual, 1) + " px or more, allowed: 32 times larger or smaller");
  }
  return polygons;
}

/// The pictures on the pieces, from their thumbnails.
std::vector<PiecePicture> pictures_of(const std::vector<Shape>& shapes,
                                      const std::function<void(const PuzzleProgress&)>& watch) {
  Drawers drawers({.processes = 1});
  std::vector<PiecePicture> pictures;
  for (const Shape& shape : shapes) {
    watch({.laying = false, .done = 0, .of = shapes.size()});
    const Artwork& artwork = shape.artwork;
    const cv::Mat page = drawers.decode_png(artwork.thumbnail_png, artwork.path, kLargestThumbnail_px);
    const std::size_t bytes = page.total() * page.elemSize();
    const float px = float(page.cols) / float(artwork.width_px);  // px of the thumbnail for one px of the artwork
    const Similarity px_from_piece{px * artwork.unit_px / shape.drawn_scale_px, 0, px * artwork.centroid_px.x,
                                   px * artwork.centroid_px.y};
    pictures.emplace_back(page.cols, page.rows, std::vector<std::uint8_t>(page.data, page.data + bytes), px_from_piece);
  }
  return pictures;
}

double area_of(const std::vector<std::vector<Vec2>>& polygons) {
  double area = 0;
  for (const auto& polygon : polygons) area += signed_area(polygon);
  return area;
}

/// The shape that the pieces shall fill, px of the canvas.
struct Frame {
  std::vector<Vec2> outline;  // empty: none
  int width_px = 0;           // of the canvas around it
  int height_px = 0;
};

Frame rectangle(int width_px, int height_px) {
  const float width = float(width_px), height = float(height_px);
  return {{{0, 0}, {width, 0}, {width, height}, {0, height}}, width_px, height_px};
}

/// The silhouette, like a canvas of that size has it.
Frame frame_in_box(const std::string& file, int width_px, int height_px) {
  CanvasSpec spec;
  spec.width_px = width_px;
  spec.height_px = height_px;
  spec.file = file;
  Drawers drawers(canvas_drawer_settings(spec));
  const CanvasPage page = canvas_page(spec, drawers);
  return {frame_outline(canvas_edge(spec, drawers).curves, file), page.width_px, page.height_px};
}

/// The frame; without a size it gets the area `wished_px2`.
Frame frame_of(const SolvingRequest& request, double wished_px2) {
  if (request.frame_file.empty())
    return request.frame_px ? rectangle(request.frame_px->at(0), request.frame_px->at(1)) : Frame{};
  if (request.frame_px) return frame_in_box(request.frame_file, request.frame_px->at(0), request.frame_px->at(1));
  constexpr int kFirst_px = 1000;
  constexpr double kLeast_px = 64, kMost_px = 20'000;
  const Frame first = frame_in_box(request.frame_file, kFirst_px, kFirst_px);
  const double side_px = std::round(kFirst_px * std::sqrt(wished_px2 / signed_area(first.outline)));
  const int side = int(std::clamp(side_px, kLeast_px, kMost_px));
  return frame_in_box(request.frame_file, side, side);
}

/// Turns and moves the pieces so that the smallest rectangle round them is upright, at the origin. `size`: of the
/// rectangle.
Similarity upright(const std::vector<cv::Point2f>& points, cv::Size2f& size) {
  const cv::RotatedRect box = cv::minAreaRect(points);
  const double angle = -double(box.angle) * CV_PI / 180;
  size = box.size;
  const Similarity turn{float(std::cos(angle)), float(std::sin(angle)), 0, 0};
  const Vec2 centre = turn.apply({box.center.x, box.center.y});
  return {turn.a, turn.b, size.width / 2 - centre.x, size.height / 2 - centre.y};
}

void add_points(const std::vector<Vec2>& polygon, const Similarity& pose, std::vector<cv::Point2f>& points) {
  for (const Vec2 p : polygon) {
    const Vec2 q = pose.apply(p);
    points.emplace_back(q.x, q.y);
  }
}

/// Turns the solution upright, for a canvas as large as it.
void stand_upright(PuzzleSolution& solution, const std::vector<std::vector<Vec2>>& polygons, SolvedPuzzle& solved) {
  std::vector<cv::Point2f> points;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (solution.poses[i]) add_points(polygons[i], *solution.poses[i], points);
  }
  cv::Size2f size;
  const Similarity turned = upright(points, size);
  for (auto& pose : solution.poses) {
    if (pose) pose = followed_by(*pose, turned);
  }
  constexpr double kMost = 1e9;  // larger ones are refused, too
  solved.width_px = int(std::min(kMost, std::ceil(size.width * solved.scale)));
  solved.height_px = int(std::min(kMost, std::ceil(size.height * solved.scale)));
}

/// Measures all pieces together, at `scale` px of the canvas for one px of the pieces, where they fit each other, in the
/// frame or without it.
void measure_together(const PuzzleSolution& solution, const std::vector<std::vector<Vec2>>& polygons, double scale,
                      SolvedPuzzle& solved) {
  const bool in_frame = solution.without_frame.empty();
  std::vector<cv::Point2f> points;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (in_frame && !solution.poses[i]) return;
    add_points(polygons[i], in_frame ? *solution.poses[i] : solution.without_frame[i], points);
  }
  cv::Size2f size;
  upright(points, size);
  solved.loose_width_px = int(std::lround((size.width + 2 * solution.erosion) * scale));
  solved.loose_height_px = int(std::lround((size.height + 2 * solution.erosion) * scale));
}

std::vector<LaidPuzzlePiece> laid_pieces(const std::vector<Shape>& shapes,
                                         const std::vector<std::vector<Vec2>>& polygons, const PuzzleSolution& solution,
                                         double scale) {
  std::vector<LaidPuzzlePiece> laid;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (!solution.poses[i]) continue;
    const Similarity canvas_from_piece = scaled(*solution.poses[i], float(scale));
    std::vector<Vec2> outline;
    for (const Vec2 p : polygons[i]) outline.push_back(canvas_from_piece.apply(p));
    const float size = shapes[i].drawn_scale_px;
    laid.push_back(
        {shapes[i].name,
         {canvas_from_piece.a * size, canvas_from_piece.b * size, canvas_from_piece.tx, canvas_from_piece.ty},
         std::move(outline)});
  }
  return laid;
}

/// The pose of the piece's shape as it was cut, before it lost `erosion_px` all around. That shape is larger and may have
/// another centre.
Similarity canvas_from_whole_shape(const LaidPuzzlePiece& piece, double erosion_px) {
  const AreaMoment now = area_moment(piece.outline_px);
  const AreaMoment cut = area_moment(grown_polygon(piece.outline_px, float(erosion_px)));
  const float times = float(std::sqrt(cut.area / now.area));
  const Vec2 moved{float(cut.x / cut.area - now.x / now.area), float(cut.y / cut.area - now.y / now.area)};
  const Similarity& at = piece.canvas_from_shape;
  return {at.a * times, at.b * times, at.tx + moved.x, at.ty + moved.y};
}

PuzzleAgreement agreement_with(const std::string& truth, const std::vector<Shape>& shapes,
                               const std::vector<LaidPuzzlePiece>& laid, double erosion_px) {
  std::map<std::string, Similarity> found, right;
  for (const LaidPuzzlePiece& piece : laid) found[piece.shape] = canvas_from_whole_shape(piece, erosion_px);
  for (const PlacedPiece& piece : read_placed_pieces(truth)) right[piece.shape] = piece.canvas_from_shape;
  const auto of = [](const std::map<std::string, Similarity>& poses, const std::string& name) {
    const auto at = poses.find(name);
    return at == poses.end() ? std::nullopt : std::optional<Similarity>(at->second);
  };
  std::vector<std::optional<Similarity>> found_of, right_of;
  for (const Shape& shape : shapes) {
    found_of.push_back(of(found, shape.name));
    right_of.push_back(of(right, shape.name));
  }
  return agreement(found_of, right_of);
}

std::string job_text(const SolvingRequest& request, const SolvedPuzzle& solved) {
  const auto beside = [&](const std::string& path) { return toml_string(path_in_job(path, request.job)); };
  const std::string canvas_file = request.frame_file.empty() ? "" : "file = " + beside(request.frame_file) + "\n";
  return std::string(kJobMark) + ": " + std::to_string(solved.placed) + " of " + count_text(solved.pieces, "piece") +
         ".\n"
         "# Every key of a job: docs/job-format.md\n"
         "\n"
         "[library]\n"
         "file = " +
         beside(request.library) +
         "\n"
         "\n"
         "[canvas]\n" +
         canvas_file + "size_px = [" + std::to_string(solved.width_px) + ", " + std::to_string(solved.height_px) +
         "]\n"
         "\n"
         "[start]\n"
         "# The poses of the pieces.\n"
         "pieces = " +
         toml_string(fs::path(solution_path(request.job)).filename().string()) +
         "\n"
         "\n"
         "[stop]\n"
         "# No other pieces.\n"
         "pieces = " +
         std::to_string(solved.placed) +
         "\n"
         "\n"
         "[improve]\n"
         "trials = 0\n";
}

struct Output {
  std::string path;
  std::string text;
};

bool holds(const std::string& path, const std::string& text) {
  const std::vector<std::uint8_t> there = read_regular_file(path, kMostOwnBytes);
  return std::equal(there.begin(), there.end(), text.begin(), text.end());
}

bool is_puzzle_job(const std::string& path) {
  const std::string_view mark(kJobMark);
  const std::vector<std::uint8_t> there = read_regular_file(path, kMostOwnBytes);
  return there.size() >= mark.size() && std::equal(mark.begin(), mark.end(), there.begin());
}

/// Checks, before time is spent, that the files may be written. An existing solution belongs to the job beside it.
void check_may_be_written(const SolvingRequest& request) {
  for (const std::string& path : {request.job, solution_path(request.job)}) {
    if (!fs::exists(path)) continue;
    std::error_code ignored;
    const bool ours =
        !fs::equivalent(path, request.library, ignored) && fs::exists(request.job) && is_puzzle_job(request.job);
    if (!ours)
      throw InputError(path + ": exists and was not made by tessera puzzle solve; give another name with --job");
  }
}

/// Writes all files or none.
void write(const SolvingRequest& request, const std::vector<Output>& outputs) {
  for (const Output& output : outputs) {
    if (request.replace || !fs::exists(output.path) || holds(output.path, output.text)) continue;
    throw InputError(output.path + ": exists with other content; --replace overwrites it, --job gives " +
                     "it another name");
  }
  for (const Output& output : outputs) write_file_atomically(output.path, output.text);
}

/// Refuses a canvas that a job may not have.
void check_canvas(const SolvingRequest& request, const SolvedPuzzle& solved) {
  constexpr int kLeast_px = 16, kMost_px = 20'000;
  if (std::min(solved.width_px, solved.height_px) >= kLeast_px &&
      std::max(solved.width_px, solved.height_px) <= kMost_px)
    return;
  throw InputError(request.library + ": the solved puzzle needs a canvas of " + std::to_string(solved.width_px) +
                   " x " + std::to_string(solved.height_px) + " px, allowed: from 16 to 20000 px (--scale K)");
}

/// Refuses frames that are far too large for the pieces, because the solver walks along them in steps of a piece's size.
void check_frame(const Frame& frame, double scale, const std::vector<std::vector<Vec2>>& polygons) {
  constexpr double kMostTimes = 100;
  const double times = signed_area(frame.outline) / (scale * scale * area_of(polygons));
  if (times > kMostTimes) {
    throw InputError("--size, --scale: found a frame of " + fixed(times, 0) +
                     " times the area of all pieces, allowed: 100 times or less");
  }
  double length = 0;
  for (const auto& polygon : polygons) length += closed_length(polygon) * scale;
  if (closed_length(frame.outline) <= kMostTimes * length) return;
  throw InputError("--frame: found an edge of more than 100 times the length of all pieces' edges");
}

[[noreturn]] void throw_nothing_fits(const SolvingRequest& request, const Frame& frame) {
  std::string text = request.library + ": found no two pieces that fit beside each other";
  if (!frame.outline.empty()) text += " in the frame";
  if (!frame.outline.empty() && !request.scale) text += "; --scale says how large they are";
  throw InputError(text);
}

/// Canvas px for one px of the pieces: the given scale, or the one at which all pieces fill the frame.
double scale_in(const Frame& frame, const SolvingRequest& request, double pieces_area) {
  if (request.scale) return *request.scale;
  return frame.outline.empty() ? 1 : std::sqrt(signed_area(frame.outline) / pieces_area);
}

PuzzleInput puzzle_input(const SolvingRequest& request, const std::vector<Shape>& shapes,
                         const std::vector<std::vector<Vec2>>& polygons, const Frame& frame, double scale) {
  PuzzleInput input{.pieces = polygons, .frame = {}, .frame_fits = request.scale.has_value()};
  for (const Vec2 p : frame.outline) input.frame.push_back(p * float(1 / scale));
  if (!request.outlines_only) input.pictures = pictures_of(shapes, request.watch);
  input.watch = request.watch;
  return input;
}

/// Describes how well the pieces lie, and which are missing. `solved` has its scale and size.
void describe(const PuzzleSolution& solution, const std::vector<Shape>& shapes,
              const std::vector<LaidPuzzlePiece>& laid, const Frame& frame, SolvedPuzzle& solved) {
  solved.placed = laid.size();
  solved.undecided = solution.undecided;
  solved.gaps = solution.gaps;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (!solution.poses[i]) solved.left_over.push_back(shapes[i].name);
  }
  solved.erosion_px = solution.erosion * solved.scale;
  const double whole_px2 =
      frame.outline.empty() ? double(solved.width_px) * solved.height_px : signed_area(frame.outline);
  for (const LaidPuzzlePiece& piece : laid) {
    solved.covered += signed_area(piece.outline_px) / whole_px2;
    solved.filled += signed_area(grown_polygon(piece.outline_px, float(solved.erosion_px))) / whole_px2;
  }
}

}  // namespace

std::string solution_path(const std::string& job) {
  const fs::path path(job);
  return (path.parent_path() / (path.stem().string() + "_pieces.geojson")).string();
}

SolvedPuzzle write_solved_puzzle(const SolvingRequest& request) {
  check_may_be_written(request);
  // checked early, so that a typing error costs no time
  if (!request.truth.empty()) read_placed_pieces(request.truth);
  const std::vector<Shape> shapes = shapes_of(request);
  const std::vector<std::vector<Vec2>> polygons = polygons_of(request.library, shapes);
  SolvedPuzzle solved;
  solved.pieces = shapes.size();
  const double pieces_area = area_of(polygons), wished_scale = request.scale.value_or(1);
  const Frame frame = frame_of(request, pieces_area * wished_scale * wished_scale);
  solved.width_px = frame.width_px;
  solved.height_px = frame.height_px;
  solved.scale = scale_in(frame, request, pieces_area);
  if (!frame.outline.empty()) check_frame(frame, solved.scale, polygons);
  PuzzleSolution solution = solve_puzzle(puzzle_input(request, shapes, polygons, frame, solved.scale));
  if (solution.placed < 2) throw_nothing_fits(request, frame);
  solved.scale *= solution.scale;
  if (frame.outline.empty())
    stand_upright(solution, polygons, solved);
  else
    measure_together(solution, polygons, wished_scale, solved);
  check_canvas(request, solved);
  const std::vector<LaidPuzzlePiece> laid = laid_pieces(shapes, polygons, solution, solved.scale);
  describe(solution, shapes, laid, frame, solved);
  if (!request.truth.empty()) solved.agreement = agreement_with(request.truth, shapes, laid, solved.erosion_px);
  write(request, {{solution_path(request.job), puzzle_geojson(laid)}, {request.job, job_text(request, solved)}});
  return solved;
}

}  // namespace tessera
