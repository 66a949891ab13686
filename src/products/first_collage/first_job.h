// Writes the job of a first collage, which suits the drawings and the canvas without any wish of the user.
#pragma once

#include <cstddef>
#include <string>

namespace tessera {

struct FirstCanvas {
  std::string file;  // as the job names it; empty: a rectangle
  int width_px = 1200;
  int height_px = 900;
  double area_px2 = 0;  // the area to be filled
};

/// Sizes of the pieces, px of the canvas.
struct FirstSizes {
  double smallest_px = 0;
  double largest_px = 0;  // five times the smallest; with more, pieces would not be relaxed
};

/// Sizes for about as many pieces as there are shapes, between 150 (fewer look empty) and 300 (more take minutes). Both
/// sizes are whole and even.
FirstSizes first_sizes(double area_px2, std::size_t shapes);

/// The text of the job. `library`: as the job names it. `source`: the name of the drawings, for people.
std::string first_job(const std::string& source, const std::string& library, std::size_t shapes,
                      const FirstCanvas& canvas);

/// Whether the text comes from first_job(), as it was written or changed since.
bool is_first_job(const std::string& text);

/// Whether the text comes from first_job() and nobody has changed it.
bool is_unedited_first_job(const std::string& text);

}  // namespace tessera
