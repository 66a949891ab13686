// The job description (docs/job-format.md): it is read from TOML into a checked struct, and written back. The keys with
// their units, defaults and ranges stand in one table, job_keys.h; reading, checking, writing and the documentation's
// test all go by it.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/field/keep_out.h"
#include "core/settings/settings.h"
#include "library/mirroring.h"

namespace tessera {

/// How a canvas repeats: its left edge goes on at its right one (x), its upper at its lower one (y).
enum class Seamless { none, x, y, both };

/// How much a job is improved, in a word (quality_word.h).
enum class QualityWord { none, draft, good, best };

/// A rectangle of the size given, or the mask in `file` scaled into a box of that size with its aspect kept.
struct CanvasSpec {
  int width_px = 1000;
  int height_px = 1000;
  std::string file;                                  // SVG or image mask, absolute path; empty = the rectangle
  Seamless seamless = Seamless::none;                // of a rectangle
  std::vector<std::string> region_colours = {};      // of `file`: each place belongs to the nearest; empty: one region
  std::vector<std::string> region_backgrounds = {};  // as many, what pictures show there; empty: OutputSpec::background
  double width_mm = 0;                               // of the rectangle or the box on paper; 0 = it has no size there
  double height_mm = 0;
  std::string keep_out = {};  // SVG or image, absolute path: what it shows is kept out of; empty = nothing
  std::vector<KeepOutRectangle> keep_out_rectangles = {};
};

/// What becomes of the pieces of an earlier result: they stand to the end and are locked in the result, too; improving
/// may take them out; or they stand to the end, and are as free or locked as they were.
enum class StartKeep { locked, free, standing };

/// What stands before the first piece is placed (start_pieces.h); CollageSettings::start has the rest.
struct StartSpec {
  std::string pieces;  // pieces.geojson of an earlier result, or its folder, absolute path; empty = none
  StartKeep keep = StartKeep::locked;
  std::vector<int> remove;  // of them, from 0: they do not stand, and only the room where they lay is filled
  std::vector<int> lock;    // of them, from 0: locked whatever `keep` says
  std::vector<std::string> not_anew = {};  // names of shapes that are not placed any more

  // Once the file is read; no keys.
  std::vector<GivenPiece> removed = {};  // as they lay
  std::uint64_t digest = 0;              // of its bytes
};

/// What "none" says of a colour.
inline constexpr const char* kNoColour = "none";
/// OutputSpec::background: the picture that the pieces show (colour.image).
inline constexpr const char* kImageBackground = "image";

/// OutputSpec::clip of artwork that is drawn whole.
inline constexpr const char* kNoClip = "none";

/// OutputSpec::keep_out of pictures that leave those zones empty.
inline constexpr const char* kNoKeepOut = "none";

/// ColourSpec::harmony of pictures whose hues stay as they are.
inline constexpr const char* kNoHarmony = "none";

/// How the pictures look. Nothing of it changes where pieces lie.
struct OutputSpec {
  int width_px = 2000;                 // of collage.png, where no width_mm is given; its height follows from the canvas
  double width_mm = 0;                 // of the canvas on paper; 0 = the pictures have no physical size
  double dpi = 300;                    // px of collage.png per inch of width_mm
  std::string background = "#f3f0ec";  // of the canvas region, outside it is white; kNoColour: both are transparent
  double background_light = 0.8;       // what the colours of kImageBackground are multiplied by
  double outline_px = 0;               // width of a line round every piece, px of the canvas; 0 = none
  std::string outline_colour = "#000000";
  double shadow_strength = 0;               // 0 = none, 1 = black
  double shadow_offset_px[2] = {1.5, 2.5};  // to the right and down, px of the canvas
  double shadow_blur_px = 2.5;              // standard deviation, px of the canvas
  std::string clip = "outline";             // artwork is cut off beside its outline; kNoClip: it is drawn whole
  std::string keep_out = kNoKeepOut;        // "artwork": the drawing in canvas.keep_out is part of the pictures
  std::string ground = {};                  // SVG or image, absolute path, on the background in tiles; empty = none
  double ground_px = 0;                     // width of a tile, px of the canvas; 0 = that of the drawing
  bool labels = false;                      // labels.png is made beside collage.png

  friend bool operator==(const OutputSpec&, const OutputSpec&) = default;
};

struct ColourSpec {
  std::string pieces = "auto";                  // "artwork", "palette", or "auto": as the library is
  std::vector<std::string> palette = {"dusk"};  // colours "#rrggbb"; or alone: a built-in name, a file's absolute path
  std::string image = {};                       // that pieces are to show together, absolute path; empty = none
  double shift = 0;                             // so far a piece's tone may go to what it covers, CIEDE2000
  double overlay = 0;                           // opacity of `image` over all that pictures show; 0 = it is not there
  std::string harmony = kNoHarmony;             // "auto", or the letter of a template (harmony.h)
};

/// A wish for drawings of one style (core/style/style_weight.h).
struct StyleSpec {
  std::vector<std::string> like;  // style_reference.h; empty: all styles
  double weight = 1;              // 0: as if there were no wish
};

struct CheckpointSpec {
  double every_s = 60;  // 0 = only at the end, and where the run is interrupted
};

struct CommSpec {
  double silence_s = 60;  // of a worker, then it is lost
};

/// A value as the job file has it: numbers (intervals as pairs), a text, or texts.
struct JobValue {
  std::vector<double> numbers;
  std::string text;
  std::vector<std::string> texts = {};

  friend bool operator==(const JobValue&, const JobValue&) = default;
};

/// One of the tables that may come any number of times: its values by the names of their columns (job_tables.h).
using JobRow = std::map<std::string, JobValue>;

struct Job {
  std::string path;                                    // the file it came from
  std::string library;                                 // absolute path; empty: library_files
  std::vector<std::string> library_files;              // absolute paths
  std::vector<std::string> library_colours = {"all"};  // as ColourSpec::palette, or "all" alone
  double library_colours_within = 15;                  // CIEDE2000
  std::vector<std::string> library_include;            // patterns of names (library/name_globs.h); empty: all shapes
  std::vector<std::string> library_exclude;
  std::string size_map;      // a grey picture, absolute path; empty: all sizes everywhere
  bool drawn_sizes = false;  // each shape as large as it was drawn, instead of settings.pieces' sizes
  std::string wishes;  // absolute path of a table whose rows come before those of [[shapes]]; empty once they are there
  std::vector<std::string> wishes_places;   // "FILE:LINE" of each row that came from it
  Mirroring mirrored = Mirroring::never;    // of shapes that no table says otherwise of
  QualityWord quality = QualityWord::good;  // none once settings.improve has what it says (quality_word.h)
  CanvasSpec canvas;
  StartSpec start;
  std::string devices = "all";  // "all", "cpu", "gpu" or a list of distinct indices "0,2"
  int devices_per_worker = 0;   // 0 = each worker of a node uses all of them
  ColourSpec colour;
  StyleSpec style;
  OutputSpec output;
  CheckpointSpec checkpoint;
  CommSpec comm;
  CollageSettings settings;
  std::uint64_t overlay_digest = 0;  // of what lies over the canvas (overlays.h); 0: nothing
  std::shared_ptr<const std::vector<std::uint8_t>> shown_png = {};  // colour.image as the result keeps it; the master's
  std::map<std::string, std::vector<JobRow>> tables;                // by name
};

/// `overrides` are "section.key=value" with the value in TOML; what is not TOML is taken as a string. Relative paths in
/// the file are relative to its folder, those in `overrides` to the working directory.
/// Throws InputError that names file and line (or the override), key, what was found and what is allowed.
Job load_job(const std::string& path, const std::vector<std::string>& overrides);

/// The same job, once it is checked as one that is read: its lists may have been made elsewhere. Throws InputError.
Job checked_job(const Job& job);

/// Sets keys of the sections [output] and [colour] alone, which may be others than when the collage was made. Returns
/// whether one of them says in which colours silhouettes are drawn. Throws InputError as load_job does, and where the
/// key is of another section.
bool set_drawing_keys(Job& job, const std::vector<std::string>& overrides);

/// The effective job with every key, readable by load_job, which then gives the same values bit by bit.
std::string to_toml(const Job& job);

/// Reads what to_toml wrote, for the other ranks of a run. `path` becomes Job::path and stands in messages.
Job job_from_toml(const std::string& text, const std::string& path);

}  // namespace tessera
