#include "artwork/images/formats/image_readers.h"

namespace tessera {
namespace {

constexpr double kLongestSide_px = 1 << 20;

}  // namespace

void throw_damaged() { throw UnreadableImage("a damaged image"); }
void throw_ends_early() { throw UnreadableImage("a damaged image: its file ends early"); }

void check_size(double width_px, double height_px, const ReadingRules& rules) {
  if (width_px < 1 || height_px < 1) throw_damaged();
  if (width_px * height_px > rules.most_pixels) {
    throw UnreadableImage(cv::format("%.0f x %.0f pixels, more than the %.0f million allowed", width_px, height_px,
                                     rules.most_pixels * 1e-6));
  }
  if (width_px > kLongestSide_px || height_px > kLongestSide_px) {
    throw UnreadableImage(
        cv::format("%.0f x %.0f pixels, allowed: sides of %.0f at most", width_px, height_px, kLongestSide_px));
  }
}

cv::Mat room_for_pixels(double width_px, double height_px, int type, const ReadingRules& rules) {
  check_size(width_px, height_px, rules);
  return cv::Mat(int(height_px), int(width_px), type);
}

}  // namespace tessera
