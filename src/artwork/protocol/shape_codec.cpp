#include "artwork/protocol/shape_codec.h"

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace tessera {
namespace {

template <class T>
concept Plain = std::is_trivially_copyable_v<T>;

class Encoder {
 public:
  template <Plain T>
  void operator()(const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void operator()(const std::string& text) { block(text.data(), text.size()); }
  template <Plain T>
  void operator()(const std::vector<T>& values) {
    block(values.data(), values.size());
  }
  void operator()(const std::vector<std::vector<Vec2>>& curves) {
    (*this)(curves.size());
    for (const auto& curve : curves) (*this)(curve);
  }
  void operator()(const Grid<float>& grid) {
    (*this)(grid.width());
    (*this)(grid.data());
  }

  std::string bytes;

 private:
  template <class T>
  void block(const T* values, std::size_t count) {
    (*this)(count);
    bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
  }
};

class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : bytes_(bytes) {}

  template <Plain T>
  void operator()(T& value) {
    std::memcpy(static_cast<void*>(&value), take(1, sizeof value), sizeof value);
  }
  void operator()(std::string& text) {
    const std::size_t count = next_count();
    text.assign(take(count, 1), count);
  }
  template <Plain T>
  void operator()(std::vector<T>& values) {
    const std::size_t count = next_count();
    const char* from = take(count, sizeof(T));
    values.resize(count);
    if (count > 0) std::memcpy(static_cast<void*>(values.data()), from, count * sizeof(T));
  }
  void operator()(std::vector<std::vector<Vec2>>& curves) {
    const std::size_t count = next_count();
    for (std::size_t i = 0; i < count; ++i) (*this)(curves.emplace_back());
  }
  void operator()(Grid<float>& grid) {
    int width = 0;
    std::vector<float> values;
    (*this)(width);
    (*this)(values);
    grid = width > 0 ? Grid<float>(width, int(values.size()) / width) : Grid<float>();
    if (grid.data().size() != values.size()) fail();
    grid.data() = std::move(values);
  }
  void check_end() const {
    if (!bytes_.empty()) fail();
  }

 private:
  [[noreturn]] static void fail() { throw std::runtime_error("a shape was garbled on its way from another process"); }

  std::size_t next_count() {
    std::size_t count = 0;
    (*this)(count);
    return count;
  }

  const char* take(std::size_t count, std::size_t size) {
    if (count > bytes_.size() / size) fail();
    const char* from = bytes_.data();
    bytes_.remove_prefix(count * size);
    return from;
  }

  std::string_view bytes_;
};

/// The one list of members that are sent, for both directions.
template <class Codec, class AShape>
void pass(Codec& codec, AShape& shape) {
  codec(shape.name);
  codec(shape.outline.curves);
  codec(shape.perimeter);
  codec(shape.radius);
  codec(shape.field.distance);
  codec(shape.field.extent);
  for (auto& level : shape.levels) {
    codec(level.points);
    codec(level.perimeter);
    codec(level.samples);
  }
  codec(shape.mean_lab);
  codec(shape.colour_spread);
  codec(shape.drawn_scale_px);
  codec(shape.colour_grid.bytes);
  codec(shape.artwork.path);
  codec(shape.artwork.sha256);
  codec(shape.artwork.width_px);
  codec(shape.artwork.height_px);
  codec(shape.artwork.centroid_px);
  codec(shape.artwork.unit_px);
  codec(shape.artwork.thumbnail_png);
  codec(shape.artwork.original);
}

}  // namespace

std::string encode_shape(const Shape& shape) {
  Encoder encoder;
  pass(encoder, shape);
  return std::move(encoder.bytes);
}

Shape decode_shape(std::string_view bytes) {
  Decoder decoder(bytes);
  Shape shape;
  pass(decoder, shape);
  decoder.check_end();
  return shape;
}

}  // namespace tessera
