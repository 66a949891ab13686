// The job description (docs/job-format.md): it is read from TOML into a checked struct, and written back. The keys with
// their units, defaults and ranges stand in one table, job_keys.h; reading, checking, writing and the documentation's
// test all go by it.
#pragma once

#include <string>
#include <vector>

#include "core/settings.h"

namespace tessera::io {

/// A rectangle of the size given, or the mask in `file` scaled into a box of that size with its aspect kept.
struct CanvasSpec {
  int width_px = 1000;
  int height_px = 1000;
  std::string file;   // SVG or image mask, absolute path; empty = the rectangle
};

/// What "none" says of a colour.
inline constexpr const char* kNoColour = "none";

/// OutputSpec::clip of artwork that is drawn whole.
inline constexpr const char* kNoClip = "none";

/// How the pictures look. Nothing of it changes where pieces lie.
struct OutputSpec {
  int width_px = 2000;  // of collage.png, where no width_mm is given; its height follows from the canvas
  double width_mm = 0;  // of the canvas on paper; 0 = the pictures have no physical size
  double dpi = 300;     // px of collage.png per inch of width_mm
  std::string background = "#f3f0ec";  // of the canvas region, outside it is white; kNoColour: both are transparent
  double outline_px = 0;  // width of a line round every piece, px of the canvas; 0 = none
  std::string outline_colour = "#000000";
  double shadow_strength = 0;    // 0 = none, 1 = black
  double shadow_offset_px[2] = {1.5, 2.5};  // to the right and down, px of the canvas
  double shadow_blur_px = 2.5;   // standard deviation, px of the canvas
  std::string clip = "outline";  // artwork is cut off beside its outline; kNoClip: it is drawn whole

  friend bool operator==(const OutputSpec&, const OutputSpec&) = default;
};

struct CheckpointSpec {
  double every_s = 60;  // 0 = only at the end, and where the run is interrupted
};

struct CommSpec {
  double silence_s = 60;  // of a worker, then it is lost
};

struct Job {
  std::string path;      // the file it came from
  std::string library;   // absolute path
  CanvasSpec canvas;
  std::string devices = "all";  // "all", "cpu", "gpu" or a list of distinct indices "0,2"
  int devices_per_worker = 0;   // 0 = each worker of a node uses all of them
  OutputSpec output;
  CheckpointSpec checkpoint;
  CommSpec comm;
  CollageSettings settings;
};

/// `overrides` are "section.key=value" with the value in TOML; what is not TOML is taken as a string. Relative paths in
/// the file are relative to its folder, those in `overrides` to the working directory.
/// Throws InputError that names file and line (or the override), key, what was found and what is allowed.
Job load_job(const std::string& path, const std::vector<std::string>& overrides);

/// Sets keys of the section [output] alone, which may be others than when the collage was made. Throws InputError as
/// load_job does, and where the key is of another section.
void set_output_keys(Job& job, const std::vector<std::string>& overrides);

/// The effective job with every key, readable by load_job, which then gives the same values bit by bit.
std::string to_toml(const Job& job);

/// Reads what to_toml wrote, for the other ranks of a run. `path` becomes Job::path and stands in messages.
Job job_from_toml(const std::string& text, const std::string& path);

}  // namespace tessera::io
