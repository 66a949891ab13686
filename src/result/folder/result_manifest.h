// manifest.json, which makes a folder a result (docs/result-format.md). It is written last and says what the files beside
// it must be. Without a manifest, or with other files, there is no result.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/colour/harmony.h"
#include "core/shape/shape_id.h"
#include "job/job_file.h"

namespace tessera {

inline constexpr const char* kManifestName = "manifest.json";
inline constexpr const char* kPictureNames[] = {"collage.png", "collage.svg", "collage.pdf", "collage.tiff",
                                                "labels.png"};

struct DrawnPicture {
  std::string file;  // its name in the folder
  OutputSpec output = {};
  std::optional<std::vector<std::string>> colours = {};  // of a palette; empty: drawn in ResultManifest::colours
  double shift = 0;                                      // largest shift of tones, CIEDE2000
  std::optional<Harmony> harmony = {};
  double overlay = 0;  // opacity of the picture over the pieces

  friend bool operator==(const DrawnPicture&, const DrawnPicture&) = default;
};

struct ResultManifest {
  bool finished = false;  // nothing is left to compute
  std::string pieces_digest;
  std::string job_digest;
  std::string library;  // its path when the result was made
  std::uint64_t library_digest = 0;
  std::uint64_t canvas_digest = 0;
  std::uint64_t overlay_digest = 0;  // of the pictures over the canvas; 0: none
  std::string start;                 // the file that it began with (start.pieces); empty: none
  std::uint64_t start_digest = 0;    // digest of that file's bytes, like pieces_digest
  std::vector<ShapeId> shapes;       // of the pieces, in order of placement
  std::uint64_t missing = 0;         // number of wanted pieces that found no place
  bool deformed = false;             // pieces.geojson has deformed polygons (piece_deformation.h)
  std::vector<std::string> colours;  // of the pieces, "#rrggbb"; empty: drawn as their artwork
  std::vector<std::string> covered;  // what each piece covers of colour.image, "#rrggbb" or ""; empty: no picture
  std::vector<DrawnPicture> pictures;

  /// Whether the result is finished, has at least one piece, and lacks none of the counted pieces.
  bool complete() const { return finished && missing == 0 && !shapes.empty(); }

  friend bool operator==(const ResultManifest&, const ResultManifest&) = default;
};

/// The digest of a file's bytes in the form of the manifest.
std::string text_digest(const std::string& bytes);

/// Writes dir/manifest.json; it is on the disk when this returns. Throws EnvironmentError.
void write_manifest(const std::string& dir, const ResultManifest& manifest);

/// Reads the manifest. Throws InputError where there is none, where it is damaged, or where pieces.geojson or job.toml have
/// changed since. Throws EnvironmentError where one of them is there and cannot be read. read_result() (finished_result.h)
/// says whether the result is whole.
ResultManifest read_manifest(const std::string& dir);

}  // namespace tessera
