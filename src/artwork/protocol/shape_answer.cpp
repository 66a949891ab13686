#include "artwork/protocol/shape_answer.h"

#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>

#include "artwork/protocol/shape_codec.h"

namespace tessera {
namespace {

/// Sent before the shape.
struct ShapeHeader {
  std::int32_t skip_reason = kNone;
  std::int32_t other_components = 0;
  float other_area_fraction = 0;
  std::int32_t loses_parts = 0;     // 1: true
  std::int32_t loses_text = 0;      // 1: true
  std::int32_t loses_pictures = 0;  // 1: true
  float hollowness = 1;
  StyleFeatures style;

  static constexpr std::int32_t kNone = -1;
};

}  // namespace

std::vector<std::uint8_t> encode_shape_answer(const ShapeOrReason& answer) {
  ShapeHeader header;
  std::string shape;
  if (const auto* reason = std::get_if<SkipReason>(&answer)) {
    header.skip_reason = std::int32_t(*reason);
  } else {
    const auto& artwork = std::get<ArtworkShape>(answer);
    header.other_components = artwork.other_components;
    header.other_area_fraction = artwork.other_area_fraction;
    header.loses_parts = artwork.loses_parts;
    header.loses_text = artwork.loses_text;
    header.loses_pictures = artwork.loses_pictures;
    header.hollowness = artwork.hollowness;
    header.style = artwork.style;
    shape = encode_shape(artwork.shape);
  }
  std::vector<std::uint8_t> bytes(sizeof header + shape.size());
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, shape.data(), shape.size());
  return bytes;
}

ShapeOrReason decode_shape_answer(std::span<const std::uint8_t> bytes) {
  ShapeHeader header;
  if (bytes.size() < sizeof header) throw std::runtime_error("a shape's header is cut off");
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.skip_reason != ShapeHeader::kNone) {
    if (header.skip_reason < 0 || header.skip_reason > std::int32_t(SkipReason::faint)) {
      throw std::runtime_error("no reason that is known");
    }
    return SkipReason(header.skip_reason);
  }
  const std::string_view shape(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return ArtworkShape{.shape = decode_shape(shape.substr(sizeof header)),
                      .other_components = header.other_components,
                      .other_area_fraction = header.other_area_fraction,
                      .loses_parts = header.loses_parts != 0,
                      .loses_text = header.loses_text != 0,
                      .loses_pictures = header.loses_pictures != 0,
                      .hollowness = header.hollowness,
                      .style = header.style};
}

}  // namespace tessera
