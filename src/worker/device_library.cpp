#include "worker/device_library.h"

#include <array>

#include "worker/kernel_options.h"

namespace tessera::worker {

DeviceLibrary::DeviceLibrary(const cl::Device& device, int pad_levels, const Shard& shard)
    : pad_levels_(pad_levels),
      session_(device, kernel_source, kernel_options(device, pad_levels)),
      match_(shard.match),
      match_buffer_(session_, {shard.match}),
      pad_bytes_(session_, shard.pad_bytes),
      pads_(session_, shard.pads),
      pad_records_(session_, shard.pad_records),
      keypoints_(session_, shard.keypoints),
      contours_(session_, shard.contours),
      shapes_(session_, shard.shapes),
      field_(session_) {}

void DeviceLibrary::start_field(int width, int height, Vec2 origin) {
  match_.field_width = width;
  match_.field_height = height;
  match_.field_origin_x = origin.x;
  match_.field_origin_y = origin.y;
  match_buffer_.write({match_});
  field_.reserve(std::size_t(width) * height);
}

void DeviceLibrary::update_field(const FieldPatch& patch) {
  if (patch.window.empty()) return;
  using Place = std::array<cl::size_type, 3>;
  const Place at = {patch.window.x0 * sizeof(float), cl::size_type(patch.window.y0), 0};
  const Place size = {patch.window.width() * sizeof(float), cl::size_type(patch.window.height()), 1};
  // Waits, as the patch is the caller's; whatever was posted before still reads the field as it was.
  checked(session_.name(), [&] {
    session_.queue().enqueueWriteBufferRect(field_.get(), CL_TRUE, at, Place{0, 0, 0}, size,
                                            match_.field_width * sizeof(float), 0, size[0], 0, patch.value.data());
  });
}

}  // namespace tessera::worker
