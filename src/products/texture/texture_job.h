// Writes the job of a texture, which suits the photo without any wish of the user.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace tessera {

struct TextureFiles {
  std::string photo;    // for people
  std::string library;  // this and the following: as the job names them
  std::string layout;
  std::string ground;  // empty: the photo shows too little of it
};

struct TexturePlan {
  cv::Size texture_px;    // the picture
  int enlarged = 1;       // canvas px for one px of the picture
  double element_px = 0;  // side of a mean element, canvas px
  int uses = 1;           // the most that an element may come
};

/// The text of the job.
std::string texture_job(const TextureFiles& files, const TexturePlan& plan);

/// Whether the text comes from texture_job(), as it was written or changed since.
bool is_texture_job(const std::string& text);

/// Whether the text comes from texture_job() and nobody has changed it.
bool is_unedited_texture_job(const std::string& text);

}  // namespace tessera
