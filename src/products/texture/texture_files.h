// Makes the files of a texture from a photo: a library of its elements, their layout on the canvas, the ground, and the job.
#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <string>

#include "artwork/drawers/drawers.h"
#include "products/elements/photo_extraction.h"
#include "products/texture/texture_job.h"

namespace tessera {

struct TextureRequest {
  std::string photo;      // JPEG, PNG, TIFF, WebP or BMP
  std::string job;        // the file to write
  cv::Size size_px;       // of the texture; empty: twice the photo's sides, at most kMostTextureSide_px
  double element_px = 0;  // short side of a typical element, px of the photo; 0: found
  std::string labels;     // a label map of the photo, instead of a search; empty: none
};

/// Longest side of a texture whose size nobody gave, and the shortest side of any.
inline constexpr int kMostTextureSide_px = 4096;
inline constexpr int kLeastTextureSide_px = 64;

/// A texture before any of its files is written.
struct TextureDraft {
  Extraction extraction;
  TexturePlan plan;
  std::string job;  // the text of the file
};

// The files beside the job: wall_texture.h5, wall_texture_layout.geojson, wall_texture_ground.png.
std::string texture_library_path(const std::string& job);
std::string texture_layout_path(const std::string& job);
std::string texture_ground_path(const std::string& job);

/// How the elements of a texture are searched for: with the photo enlarged where they are small, and with the ground.
ExtractionSettings texture_extraction(const TextureRequest& request);

/// Finds the elements and plans the texture. Throws InputError where the photo cannot be used or shows no whole element.
TextureDraft draft_texture(const TextureRequest& request, Drawers& drawers);

/// Writes the files beside the job, each whole or not at all. `canvas_px`: that of the job. Returns the number of pieces
/// that the texture begins with. Throws InputError where no element has a usable silhouette, EnvironmentError.
std::size_t write_texture_files(const TextureRequest& request, const TextureDraft& draft, cv::Size canvas_px,
                                Drawers& drawers);

}  // namespace tessera
