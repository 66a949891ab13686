// The job description (docs/job-format.md), read from TOML into a checked struct and written back. One table,
// job_keys.h, holds the keys with their units, defaults and ranges; reading, checking, writing and the test of the
// documentation all use it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/field/keep_out.h"
#include "core/settings/settings.h"
#include "library/mirroring.h"

namespace tessera {

/// The most bytes of a job file: one with every key and comments has 4 kB, one of a thousand wishes some 100 kB.
inline constexpr std::size_t kMaxJobBytes = std::size_t(1) << 20;

/// The directions in which a canvas repeats: its left edge continues at the right one (x), its upper edge at the lower
/// one (y).
enum class Seamless { none, x, y, both };

/// The amount of improving, as a word (quality_word.h).
enum class QualityWord { none, draft, good, best };

/// The canvas of a job: a rectangle of the given size, or the mask in `file` scaled into a box of that size with its
/// aspect ratio kept.
struct CanvasSpec {
  int width_px = 1000;
  int height_px = 1000;
  std::string file;                                  // SVG or image mask, absolute path; empty: the rectangle
  Seamless seamless = Seamless::none;                // only for a rectangle
  std::vector<std::string> region_colours = {};      // of `file`: a place is of the nearest; empty: one region
  std::vector<std::string> region_backgrounds = {};  // for each, in pictures; empty: OutputSpec::background
  double width_mm = 0;                               // on paper, of the rectangle or the box; 0: no size on paper
  double height_mm = 0;
  std::string keep_out = {};  // SVG or image, absolute path, whose shapes stay free of pieces; empty: none
  std::vector<KeepOutRectangle> keep_out_rectangles = {};
};

/// The treatment of the pieces of an earlier result. They stay and are locked in the result, too (locked); improving
/// may remove them (free); or they stay and keep their own lock (standing).
enum class StartKeep { locked, free, standing };

/// The pieces that stand before the first one is placed (start_pieces.h); CollageSettings::start has the rest.
struct StartSpec {
  std::string pieces;  // pieces.geojson of an earlier result, or its folder, absolute path; empty: none
  StartKeep keep = StartKeep::locked;
  std::vector<int> remove;                 // indices from 0 of pieces to remove; only the room where they lay is filled
  std::vector<int> lock;                   // indices from 0 of pieces to lock, whatever `keep` says
  std::vector<std::string> not_anew = {};  // names of shapes that shall not be placed again

  // The members below are no keys; they are set when the file has been read.
  std::vector<GivenPiece> removed = {};  // with their poses
  std::uint64_t digest = 0;              // of the file's bytes
};

/// Value of a colour key for "no colour".
inline constexpr const char* kNoColour = "none";
/// Value of OutputSpec::background: the picture that the pieces show (colour.image).
inline constexpr const char* kImageBackground = "image";
/// Another: what lies round each piece in the photo that it was cut out of (render/photo_ground.h).
inline constexpr const char* kPhotoBackground = "photo";

/// Value of OutputSpec::clip: artwork is drawn whole.
inline constexpr const char* kNoClip = "none";

/// Value of OutputSpec::keep_out: pictures leave the zones empty.
inline constexpr const char* kNoKeepOut = "none";

/// Value of ColourSpec::harmony: hues stay as they are.
inline constexpr const char* kNoHarmony = "none";

/// The look of the pictures. It never changes the places of pieces.
struct OutputSpec {
  int width_px = 2000;                 // of collage.png, unless width_mm is given; the height follows from the canvas
  double width_mm = 0;                 // of the canvas on paper; 0: the pictures have no physical size
  double dpi = 300;                    // px of collage.png per inch of width_mm
  std::string background = "#f3f0ec";  // of the canvas region (outside is white); kNoColour: both are transparent
  double background_light = 0.8;       // factor on the colours of kImageBackground
  double outline_px = 0;               // width of a line round every piece, canvas px; 0: none
  std::string outline_colour = "#000000";
  double shadow_strength = 0;               // 0: none, 1: black
  double shadow_offset_px[2] = {1.5, 2.5};  // to the right and down, px of the canvas
  double shadow_blur_px = 2.5;              // standard deviation, px of the canvas
  std::string clip = "outline";             // artwork is cut off outside its outline; kNoClip: it is drawn whole
  std::string keep_out = kNoKeepOut;        // "artwork": the pictures show the drawing in canvas.keep_out
  std::string ground = {};                  // SVG or image, absolute path, tiled over the background; empty: none
  double ground_px = 0;                     // width of a tile, canvas px; 0: that of the drawing
  bool labels = false;                      // also write labels.png
  bool report = false;                      // also write report.html

  friend bool operator==(const OutputSpec&, const OutputSpec&) = default;
};

struct ColourSpec {
  std::string pieces = "auto";                  // "artwork", "palette", or "auto": by the kind of library
  std::vector<std::string> palette = {"dusk"};  // colours "#rrggbb", or one name of a palette or absolute path
  std::string image = {};                       // the picture that the pieces show together, absolute path; empty: none
  double shift = 0;                             // largest change of a piece's tone towards the picture, CIEDE2000
  double overlay = 0;                           // opacity of `image` over the whole picture; 0: none
  std::string harmony = kNoHarmony;             // "auto", or the letter of a template (harmony.h)
};

/// A wish for drawings of one style (core/style/style_weight.h).
struct StyleSpec {
  std::vector<std::string> like;  // drawings or groups (style_reference.h); empty: all styles
  double weight = 1;              // 0: no preference
};

struct CheckpointSpec {
  double every_s = 60;  // 0: only at the end, and when the run is interrupted
};

struct CommSpec {
  double silence_s = 60;  // after this time without a heartbeat a worker is lost
};

/// A value as in the job file: numbers (intervals as pairs), a text, or several texts.
struct JobValue {
  std::vector<double> numbers;
  std::string text;
  std::vector<std::string> texts = {};

  friend bool operator==(const JobValue&, const JobValue&) = default;
};

/// A row of a table that may occur several times: its values by column name (job_tables.h).
using JobRow = std::map<std::string, JobValue>;

struct Job {
  std::string path;                                    // of the file
  std::string library;                                 // absolute path; empty: use library_files
  std::vector<std::string> library_files;              // absolute paths
  std::vector<std::string> library_colours = {"all"};  // as ColourSpec::palette, or only "all"
  double library_colours_within = 15;                  // CIEDE2000
  std::vector<std::string> library_include;            // patterns of names (library/name_globs.h); empty: all shapes
  std::vector<std::string> library_exclude;
  std::string size_map;      // a grey picture, absolute path; empty: all sizes everywhere
  bool drawn_sizes = false;  // each shape as large as it was drawn; settings.pieces has no say
  std::string wishes;        // absolute path of a table with rows for [[shapes]]; empty once these were added
  std::vector<std::string> wishes_places;   // "FILE:LINE" of each row from that table
  Mirroring mirrored = Mirroring::never;    // for shapes without a value of their own in a table
  QualityWord quality = QualityWord::good;  // none once it has set settings.improve (quality_word.h)
  CanvasSpec canvas;
  StartSpec start;
  std::string devices = "all";  // "all", "cpu", "gpu" or a list of distinct indices "0,2"
  int devices_per_worker = 0;   // 0: each worker of a node uses all of them
  ColourSpec colour;
  StyleSpec style;
  OutputSpec output;
  CheckpointSpec checkpoint;
  CommSpec comm;
  CollageSettings settings;
  std::uint64_t overlay_digest = 0;  // of the overlays on the canvas (overlays.h); 0: none
  std::shared_ptr<const std::vector<std::uint8_t>> shown_png = {};  // colour.image for the result; only on the master
  std::map<std::string, std::vector<JobRow>> tables;                // by name
};

/// Reads a job file. `overrides` are "section.key=value" with the value in TOML; a value that is not TOML is taken as a
/// string. Relative paths in the file are relative to its folder, those in `overrides` to the working directory. Throws
/// InputError that names file and line (or the override), key, what was found and what is allowed.
Job load_job(const std::string& path, const std::vector<std::string>& overrides);

/// Checks a job as load_job does, for jobs whose lists were made elsewhere, and returns it. Throws InputError.
Job checked_job(const Job& job);

/// Sets keys of the sections [output] and [colour], the only ones that may change after the collage was made. Returns
/// whether one of them sets the colours of silhouettes. Throws InputError as load_job does, and where the key is of
/// another section.
bool set_drawing_keys(Job& job, const std::vector<std::string>& overrides);

/// The effective job with every key as TOML; load_job reads it back with the same values bit by bit.
std::string to_toml(const Job& job);

/// Reads what to_toml wrote, for the other ranks of a run. `path` becomes Job::path, which messages name.
Job job_from_toml(const std::string& text, const std::string& path);

}  // namespace tessera
