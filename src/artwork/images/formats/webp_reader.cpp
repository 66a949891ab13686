#include <webp/decode.h>

#include "artwork/images/formats/image_readers.h"

namespace tessera {

DecodedImage read_webp(std::span<const std::uint8_t> bytes, const ReadingRules& rules) {
  WebPBitstreamFeatures features;
  const VP8StatusCode header = WebPGetFeatures(bytes.data(), bytes.size(), &features);
  if (header == VP8_STATUS_NOT_ENOUGH_DATA) throw_ends_early();
  if (header != VP8_STATUS_OK) throw_damaged();
  if (features.has_animation) throw UnreadableImage("an animated WebP, which is not read; needed: a still picture");
  const int type = features.has_alpha ? CV_8UC4 : CV_8UC3;
  DecodedImage image{.pixels = room_for_pixels(features.width, features.height, type, rules)};
  const cv::Mat& pixels = image.pixels;
  const auto decode = features.has_alpha ? WebPDecodeBGRAInto : WebPDecodeBGRInto;
  const std::size_t room_bytes = pixels.step[0] * std::size_t(pixels.rows);
  if (!decode(bytes.data(), bytes.size(), pixels.data, room_bytes, int(pixels.step[0]))) throw_damaged();
  return image;
}

}  // namespace tessera
