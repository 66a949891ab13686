#include "products/mosaic/mosaic_job.h"

#include <algorithm>
#include <charconv>

#include "job/toml_string.h"

namespace tessera {
namespace {

/// Picture px for one canvas px, so that drawings can be recognised.
constexpr int kPictureScale = 2;
constexpr int kWidestPicture_px = 12'000;

/// The number with the fewest digits that give the same number back.
std::string number_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string pair_text(double first, double second) {
  return "[" + number_text(first) + ", " + number_text(second) + "]";
}

std::string library_lines(const std::vector<std::string>& libraries) {
  if (libraries.size() == 1) return "file = " + toml_string(libraries.front()) + "\n";
  std::string text;
  for (const std::string& library : libraries) text += (text.empty() ? "" : ", ") + toml_string(library);
  return "files = [" + text + "]\n";
}

std::string canvas_file_lines(const std::string& regions) {
  if (regions.empty()) return "";
  return "# A picture of the regions in flat colours, without mixed ones between them; paint in it to move borders.\n"
         "file = " +
         toml_string(regions) + "\n";
}

std::string region_lines(const std::vector<std::string>& regions) {
  std::string text;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    text += "\n[[regions]]\nname = \"" + std::to_string(i + 1) + "\"\ncolour = " + toml_string(regions[i]) +
            "  # in the picture of the regions\n";
  }
  return text;
}

}  // namespace

std::string mosaic_job(const MosaicFiles& files, const MosaicPlan& plan, const MosaicVariety& variety, double shift,
                       const std::vector<std::string>& regions) {
  const int width_px = std::min(kPictureScale * plan.canvas_px.width, kWidestPicture_px);
  return std::string(kMosaicJobMark) + ": about " + std::to_string(plan.pieces) +
         " pieces. Change what you like, then: tessera collage THIS_FILE\n"
         "# Every key of a job: docs/job-format.md\n"
         "\n"
         "seed = 1  # another seed, another mosaic\n"
         "# \"good\" covers 1 to 2 % more, shows the image a little better and takes three times as long.\n"
         "quality = \"draft\"\n"
         "\n"
         "[library]\n" +
         library_lines(files.libraries) +
         "\n"
         "[canvas]\n"
         "# The image's aspect. Twice the width and height with the same sizes of pieces: four times as many of them.\n"
         "size_px = " +
         pair_text(plan.canvas_px.width, plan.canvas_px.height) + "\n" + canvas_file_lines(files.regions) +
         "\n"
         "[colour]\n"
         "# Pieces are chosen by the colours of what they cover.\n"
         "# weight: how much that counts beside outlines that fit; 0 = not. 8 shows the image better, with more gaps.\n"
         "# shift: each part of a piece is moved towards the image by so much CIEDE2000 at most; 0 = as drawn.\n"
         "# overlay: the image itself is laid over the pieces in this opacity, 0.25 = a quarter; 0 = not.\n"
         "image = " +
         toml_string(files.image) +
         "\n"
         "weight = 5\n"
         "shift = " +
         number_text(shift) +
         "\n"
         "\n"
         "[pieces]\n"
         "# The smallest and the largest size, px of the canvas. The map, a grey picture, says where: black = the\n"
         "# smallest alone, white = up to the largest. Paint darker what is to be finer.\n"
         "scale_px = " +
         pair_text(plan.min_scale_px, plan.max_scale_px) +
         "\n"
         "size_map = " +
         toml_string(files.size_map) +
         "\n"
         "# Least distance between two pieces of the same drawing: px between their outlines.\n"
         "apart_px = " +
         number_text(variety.apart_px) +
         "\n"
         "\n"
         "[objective]\n"
         "# length_exponent: how much long contact counts; scale_exponent: how much size counts. Less of both shows "
         "more of\n"
         "# the image, with more gaps and more small pieces.\n"
         "# repetition_exponent: what the same drawing again costs; 0 = nothing, as for small libraries.\n"
         "length_exponent = 4\n"
         "scale_exponent = 1\n"
         "repetition_exponent = " +
         number_text(variety.repetition_exponent) +
         "\n"
         "\n"
         "[output]\n"
         "# Between the pieces: the image itself, a little darker, so that they stand out. 1 = as bright as it is; "
         "tessera\n"
         "# draw changes it.\n"
         "background = \"image\"\n"
         "background_light = 0.8\n"
         "width_px = " +
         std::to_string(width_px) + "\n" + region_lines(regions);
}

}  // namespace tessera
