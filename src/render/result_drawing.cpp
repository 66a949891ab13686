#include "render/result_drawing.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "artwork/drawers/drawers.h"
#include "checkpoint/checkpoint_origin.h"
#include "core/base/error.h"
#include "core/base/rank_pool.h"
#include "core/base/stopwatch.h"
#include "files/atomic_file.h"
#include "job/canvas/canvas_file.h"
#include "job/canvas/canvas_page.h"
#include "job/palette.h"
#include "job/picture_size.h"
#include "job/pieces/job_library.h"
#include "job/pieces/shape_group.h"
#include "job/pieces/size_factor.h"
#include "render/afar_measure.h"
#include "render/canvas_drawing.h"
#include "render/card_drawing.h"
#include "render/hue_turns.h"
#include "render/label_map.h"
#include "render/photo_ground.h"
#include "render/picture_drawing.h"
#include "render/piece_colours.h"
#include "render/piece_deformation.h"
#include "render/pieces/tones.h"
#include "render/png_stream.h"
#include "render/shown_picture.h"
#include "render/svg_output.h"
#include "render/tiff_pyramid.h"
#include "result/card_input.h"
#include "result/folder/finished_result.h"
#include "result/folder/result_file.h"
#include "result/folder/result_manifest.h"
#include "result/placed_pieces.h"
#include "text/digest_text.h"
#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

/// A result's job with the changes that the request asks for.
struct DrawnJob {
  Job job;
  bool other_colours = false;  // otherwise those of the result
};

DrawnJob job_of(const WholeResult& result, const PictureRequest& request) {
  DrawnJob drawn{result.job};
  Job& job = drawn.job;
  drawn.other_colours = set_drawing_keys(job, request.keys);
  if (request.library.size() == 1) {
    job.library = request.library.front();
    job.library_files.clear();
  } else if (!request.library.empty()) {
    job.library.clear();
    job.library_files = request.library;
  }
  return drawn;
}

LibraryView opened_library(const Job& job) {
  try {
    return open_library_of(job);
  } catch (const InputError& error) {
    throw InputError(std::string(error.what()) + "; --library FILE of tessera draw says where it is now");
  }
}

/// Says how the digests differ, and how to find the right library.
std::string another_library(const std::string& dir, const ResultManifest& manifest, const LibraryView& library) {
  const bool same_place = manifest.library == library.path();
  const std::string maker = made_by(dir);
  return library.path() + ": not the library that the collage was made from: its content has the digest " +
         digest_text(library.content_digest()) + ", that of the collage's library was " +
         digest_text(manifest.library_digest) +
         (same_place ? ", built or changed since" : ", then in " + printable_utf8(manifest.library)) +
         (maker.empty() ? "" : "; the collage was made by " + maker) +
         "; --library FILE says where that library is; if it is lost, build it again from the "
         "same drawings (tessera library build), or make a new collage with this library";
}

LibraryView library_of(const std::string& dir, const Job& job, const ResultManifest& manifest) {
  LibraryView library = opened_library(job);
  if (library.content_digest() == manifest.library_digest) return library;
  throw InputError(another_library(dir, manifest, library));
}

/// The output of the job on paper, with the changes of the request.
OutputSpec output_of(const WholeResult& result, const PictureRequest& request, const CanvasSpec& page,
                     const Canvas& canvas) {
  Job job = result.job;
  job.output = on_paper(job.output, page, canvas);
  set_drawing_keys(job, request.keys);
  return job.output;
}

struct DrawnCanvas {
  Canvas canvas;
  CanvasSpec box;     // on paper: the page
  OutputSpec output;  // depends on the canvas
  CanvasDrawing drawing;
};

DrawnCanvas canvas_of(const WholeResult& result, const PictureRequest& request, const Job& job,
                      DrawingObserver& observer) {
  Drawers drawers(canvas_picture_settings(job.canvas, job.output));
  const StopWatcher stop(observer, drawers);
  Canvas canvas = load_canvas(job.canvas, drawers);
  if (canvas_digest(canvas) != result.manifest.canvas_digest) {
    const CanvasSpec& spec = job.canvas;
    const std::string both = spec.file + (spec.file.empty() || spec.keep_out.empty() ? "" : " or ") + spec.keep_out;
    throw InputError(both + ": its content has changed since the collage was made; put the old file back to draw it");
  }
  CanvasSpec box = job.canvas;
  shrink_box_to_page(box, canvas, drawers);
  OutputSpec output = output_of(result, request, box, canvas);
  check_picture_size(output, canvas);
  CanvasDrawing drawing = draw_canvas(box, output, canvas, drawers);
  return {std::move(canvas), std::move(box), std::move(output), std::move(drawing)};
}

std::vector<Placement> placements_of(const std::string& dir, const ResultManifest& manifest, std::size_t shapes) {
  const std::vector<PlacedPiece> pieces = read_placed_pieces(dir);
  if (pieces.size() != manifest.shapes.size()) {
    throw InputError(path_in_result(dir, kManifestName) + ": not as many shapes as pieces.geojson has pieces");
  }
  std::vector<Placement> placements(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (index_of(manifest.shapes[i]) >= shapes) {
      throw InputError(path_in_result(dir, kManifestName) + ": a shape that the library lacks");
    }
    placements[i].shape = manifest.shapes[i];
    placements[i].canvas_from_shape = pieces[i].canvas_from_shape;
  }
  return placements;
}

std::vector<std::string> distinct(std::vector<std::string> colours) {
  std::sort(colours.begin(), colours.end());
  colours.erase(std::unique(colours.begin(), colours.end()), colours.end());
  return colours;
}

InputError no_photo_of_deformed(const std::string& dir) {
  return InputError(dir + ": output.background: found \"" + kPhotoBackground +
                    "\" with deformed pieces, which have left their photo; allowed: a colour, or another background");
}

InputError no_pdf(const std::string& dir, const std::string& harmony) {
  return InputError(dir + ": colour.harmony: found \"" + harmony + "\" with a PDF, which cannot turn hues; allowed: " +
                    "--set colour.harmony=" + kNoHarmony + ", or the PNG, TIFF and SVG");
}

/// Finds out, before anything is drawn, whether all files can be written.
void check_can_be_drawn(const std::string& folder, const PictureRequest& request, const OutputSpec& output) {
  const auto check = [&](bool wanted, const char* name) {
    if (wanted) check_can_be_written(path_in_result(folder, name));
  };
  check(request.svg, "collage.svg");
  check(request.png, "collage.png");
  check(request.tiff, "collage.tiff");
  check(request.pdf, "collage.pdf");
  check(request.png && output.labels, "labels.png");
}

/// Limits for a document of all drawings together, each of which has been drawn before.
const DrawerSettings kWholeCollage{
    .processes = 1, .seconds_per_drawing = 600, .bytes_per_process = std::size_t(4) << 30};

/// The folder of the pictures, and whether the manifest of the result describes them.
struct PictureFolder {
  std::string path;
  bool is_result = true;  // otherwise it has no manifest
};

/// Draws one picture after the other. The manifest always says which of them are there.
class ResultPictures {
 public:
  ResultPictures(const PictureFolder& folder, const CollageReport& report, const ResultManifest& manifest,
                 Drawers& drawers, const StopWatcher& stop, DrawingObserver& observer)
      : dir_(folder.path),
        is_result_(folder.is_result),
        report_(report),
        manifest_(manifest),
        stop_(stop),
        observer_(observer),
        artworks_(report, drawers, stop) {}

  void svg() {
    begin("collage.svg");
    write_file_atomically(path_in_result(dir_, "collage.svg"), drawn_svg("collage.svg"));
    end("collage.svg");
  }

  /// Draws the pixels once for both files, and for `measure` if it is given.
  void pixels(bool png, bool tiff, AfarMeasure* measure) {
    std::vector<const char*> names;
    if (png) names.push_back("collage.png");
    if (tiff) names.push_back("collage.tiff");
    for (const char* name : names) begin(name);
    const std::size_t rows = std::size_t(picture_size_px(report_.output, *report_.canvas).height);
    const PictureFormat format = picture_format(report_);
    std::vector<std::unique_ptr<PictureFile>> owned;
    if (png) owned.push_back(std::make_unique<PngStream>(path_in_result(dir_, "collage.png"), format));
    if (tiff) owned.push_back(std::make_unique<TiffPyramid>(path_in_result(dir_, "collage.tiff"), format));
    std::vector<PictureFile*> files;
    for (const auto& file : owned) files.push_back(file.get());
    if (measure) files.push_back(&measure->rows());
    write_picture(report_, artworks_, files, stop_,
                  [&](std::size_t done) { observer_.progressed(names.front(), done, rows); });
    for (const char* name : names) end(name);
  }

  void labels() {
    const PictureFormat format = label_format(report_);
    begin("labels.png");
    PngStream file(path_in_result(dir_, "labels.png"), format);
    write_labels(report_, artworks_, file, stop_,
                 [&](std::size_t done) { observer_.progressed("labels.png", done, std::size_t(format.size.height)); });
    end("labels.png");
  }

  void pdf() {
    begin("collage.pdf");
    const std::string svg = drawn_svg("collage.pdf");
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(svg.data()), svg.size());
    Drawers drawer(kWholeCollage);
    const StopWatcher stop(observer_, drawer);
    const std::vector<std::uint8_t> pdf = drawer.pdf_of_svg(bytes, width_pt());
    stop_.check();
    write_file_atomically(path_in_result(dir_, "collage.pdf"), pdf);
    end("collage.pdf");
  }

  DrawingNotes notes() const { return artworks_.notes(); }

 private:
  /// Begins a picture. The manifest says nothing about the old picture until the new one is there.
  void begin(const char* name) {
    stop_.check();
    if (std::erase_if(manifest_.pictures, [&](const DrawnPicture& p) { return p.file == name; }) > 0) tell();
  }

  void end(const char* name) {
    manifest_.pictures.push_back({name, report_.output});
    if (!manifest_.covered.empty()) manifest_.pictures.back().shift = report_.shift;
    manifest_.pictures.back().overlay = report_.overlay_opacity;
    manifest_.pictures.back().harmony = report_.harmony;
    if (report_.colours != manifest_.colours) manifest_.pictures.back().colours = distinct(report_.colours);
    tell();
  }

  void tell() const {
    if (is_result_) write_manifest(dir_, manifest_);
  }

  double width_pt() const {
    constexpr double kPointsPerInch = 72, kPxPerInch = 96;  // CSS
    const OutputSpec& output = report_.output;
    return kPointsPerInch * (output.width_mm == 0 ? output.width_px / kPxPerInch : output.width_mm / kMmPerInch);
  }

  std::string drawn_svg(const char* picture) {
    std::mutex mutex;  // several threads finish shapes
    std::size_t done = 0;
    std::string svg = collage_svg(report_, artworks_, [&] {
      const std::lock_guard lock(mutex);
      observer_.progressed(picture, ++done, report_.shapes.size());
    });
    stop_.check();
    return svg;
  }

  const std::string dir_;
  const bool is_result_;
  const CollageReport& report_;
  ResultManifest manifest_;
  const StopWatcher& stop_;
  DrawingObserver& observer_;
  ShapeArtworks artworks_;
};

/// A result that is drawn.
struct DrawnResult {
  const std::string& folder;
  const WholeResult& result;
  const DrawnJob& drawn;
  const LibraryView& library;
};

/// The placed pieces on their canvas, with the result's own colours. `canvas` outlives the report.
CollageReport report_of(const DrawnResult& result, DrawnCanvas& canvas, const StopWatcher& stop) {
  const Job& job = result.drawn.job;
  const ResultManifest& manifest = result.result.manifest;
  CollageReport report;
  report.output = canvas.output;
  report.box = canvas.box;
  report.canvas = &canvas.canvas;
  report.canvas_edge = std::move(canvas.drawing.edge);
  report.keep_out = std::move(canvas.drawing.keep_out);
  report.ground = canvas.output.background == kImageBackground
                      ? image_background(result.folder, canvas.output, canvas.canvas)
                      : std::move(canvas.drawing.ground);
  report.overlay = image_overlay(result.folder, job.colour.overlay, canvas.canvas);
  report.overlay_opacity = job.colour.overlay;
  report.placements = placements_of(result.folder, manifest, result.library.size());
  const LibraryParts parts{.outline = true,
                           .field = true,
                           .levels = 0,
                           .artwork = true,
                           .original = true,
                           .surroundings = report.output.background == kPhotoBackground};
  report.shapes = read_placed_shapes(result.library, report.placements, parts, [&] { stop.check(); });
  const std::vector<std::string> groups =
      shape_groups(job, report.shapes.names(), names_like_patterns(result.library, job));
  report.groups = of_placements(groups, report.shapes, report.placements);
  report.covered = manifest.covered;
  if (!result.drawn.other_colours) report.colours = manifest.colours;
  return report;
}

/// Adds colours. `palette`: the job's, where other colours than the result's are asked for; else empty.
void add_colours(const DrawnResult& result, const std::vector<std::string>& palette, Drawers& drawers,
                 CollageReport& report) {
  const Job& job = result.drawn.job;
  if (result.drawn.other_colours && draws_palette(job.colour, result.library))
    report.colours = piece_colours(report, report.placements, palette, job.settings.pieces.padding_px);
  report.shift = job.colour.shift;
  if (report.shift > 0 && !report.covered.empty()) {
    const std::vector<DrawnColours> drawn = drawn_colours(report.shapes, drawers);
    report.tones = tones_towards_picture(report, drawn, shown_picture(result.folder), report.shift);
  }
  harmonise(report, job.colour.harmony);
}

/// The size of the smallest piece; empty where the result that the collage began with can no longer be read.
std::optional<float> smallest_size_of(const DrawnResult& result, const Canvas& canvas) {
  try {
    return smallest_size_px(canvas, result.library, result.result.job);
  } catch (const InputError&) {
    return {};
  }
}

AfarMeasure afar_measure(const DrawnResult& result, const CollageReport& report, DrawingObserver& observer) {
  Drawers photo_drawer(photo_drawer_settings(1));
  const StopWatcher stop(observer, photo_drawer);
  AfarMeasure measure(report, result.drawn.job.colour.image, smallest_size_of(result, *report.canvas), photo_drawer);
  stop.check();
  return measure;
}

void check_can_be_pdf(const std::string& dir, const CollageReport& report, const std::string& harmony) {
  const auto is_turned = [](const Tone& tone) { return tone.turn_deg != 0; };
  if (std::any_of(report.tones.begin(), report.tones.end(), is_turned)) throw no_pdf(dir, harmony);
}

}  // namespace

DrawingNotes draw_result(const std::string& dir, const PictureRequest& request, DrawingObserver& observer) {
  const Stopwatch watch;
  const WholeResult whole = read_result(dir);
  const DrawnJob drawn = job_of(whole, request);
  const Job& job = drawn.job;
  const std::string folder = request.to.empty() ? dir : request.to;
  check_can_be_drawn(folder, request, job.output);
  const std::vector<std::string> palette =
      drawn.other_colours ? load_palette(job) : std::vector<std::string>();  // the job's palette may be gone
  Drawers drawers({.processes = rank_cores()});
  const StopWatcher stop(observer, drawers);
  stop.check();
  const LibraryView library = library_of(dir, job, whole.manifest);
  stop.check();
  DrawnCanvas canvas = canvas_of(whole, request, job, observer);
  const DrawnResult result{dir, whole, drawn, library};
  CollageReport report = report_of(result, canvas, stop);
  if (report.output.background == kPhotoBackground) {
    if (whole.manifest.deformed) throw no_photo_of_deformed(dir);
    report.ground = photo_ground(report, report.ground, drawers, stop);
  }
  add_colours(result, palette, drawers, report);
  if (request.pdf) check_can_be_pdf(dir, report, job.colour.harmony);
  const bool is_result = request.to.empty();
  const bool pixels = request.png || request.tiff;
  std::optional<AfarMeasure> measure;
  if (is_result && pixels && !job.colour.image.empty()) measure.emplace(afar_measure(result, report, observer));
  if (whole.manifest.deformed) restore_deformed_pieces(dir, report, [&] { stop.check(); });
  ResultPictures pictures({folder, is_result}, report, whole.manifest, drawers, stop, observer);
  if (request.svg) pictures.svg();
  if (pixels) pictures.pixels(request.png, request.tiff, measure ? &*measure : nullptr);
  if (request.pdf) pictures.pdf();
  if (request.png && report.output.labels) pictures.labels();
  DrawingNotes notes = pictures.notes();
  notes.layers = drawers.layers();
  if (measure) notes.afar = measure->note();
  notes.seconds = watch.seconds();
  if (is_result) notes.cards = add_drawing_to_cards(dir, notes);
  return notes;
}

}  // namespace tessera
