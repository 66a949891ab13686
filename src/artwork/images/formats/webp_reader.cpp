#include <webp/decode.h>
#include <webp/demux.h>

#include <memory>
#include <opencv2/imgproc.hpp>

#include "artwork/images/formats/image_readers.h"

namespace tessera {
namespace {

cv::Mat still_picture(std::span<const std::uint8_t> bytes, const WebPBitstreamFeatures& features,
                      const ReadingRules& rules) {
  const int type = features.has_alpha ? CV_8UC4 : CV_8UC3;
  const cv::Mat pixels = room_for_pixels(features.width, features.height, type, rules);
  const auto decode = features.has_alpha ? WebPDecodeBGRAInto : WebPDecodeBGRInto;
  const std::size_t room_bytes = pixels.step[0] * std::size_t(pixels.rows);
  if (!decode(bytes.data(), bytes.size(), pixels.data, room_bytes, int(pixels.step[0]))) throw_damaged();
  return pixels;
}

/// The first picture of an animation, on a transparent ground.
cv::Mat first_of_animation(const WebPData& data, const WebPBitstreamFeatures& features, const ReadingRules& rules) {
  check_size(features.width, features.height, rules);
  WebPAnimDecoderOptions options;
  if (!WebPAnimDecoderOptionsInit(&options)) throw_damaged();
  options.color_mode = MODE_BGRA;
  const std::unique_ptr<WebPAnimDecoder, decltype(&WebPAnimDecoderDelete)> decoder(WebPAnimDecoderNew(&data, &options),
                                                                                   WebPAnimDecoderDelete);
  std::uint8_t* shown = nullptr;  // owned by the decoder
  int time_ms = 0;
  if (!decoder || !WebPAnimDecoderGetNext(decoder.get(), &shown, &time_ms)) throw_damaged();
  return cv::Mat(features.height, features.width, CV_8UC4, shown).clone();
}

std::vector<std::uint8_t> profile_of(const WebPData& data) {
  const std::unique_ptr<WebPDemuxer, decltype(&WebPDemuxDelete)> demuxer(WebPDemux(&data), WebPDemuxDelete);
  WebPChunkIterator chunk{};
  if (!demuxer || !WebPDemuxGetChunk(demuxer.get(), "ICCP", 1, &chunk)) return {};
  std::vector<std::uint8_t> profile(chunk.chunk.bytes, chunk.chunk.bytes + chunk.chunk.size);
  WebPDemuxReleaseChunkIterator(&chunk);
  return profile;
}

}  // namespace

DecodedImage read_webp(std::span<const std::uint8_t> bytes, const ReadingRules& rules) {
  WebPBitstreamFeatures features;
  const VP8StatusCode header = WebPGetFeatures(bytes.data(), bytes.size(), &features);
  if (header == VP8_STATUS_NOT_ENOUGH_DATA) throw_ends_early();
  if (header != VP8_STATUS_OK) throw_damaged();
  const WebPData data{bytes.data(), bytes.size()};
  return {.pixels = features.has_animation ? first_of_animation(data, features, rules)
                                           : still_picture(bytes, features, rules),
          .profile = profile_of(data)};
}

}  // namespace tessera
