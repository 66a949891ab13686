#include "worker/device_library.h"

#include <algorithm>
#include <array>

#include "worker/opencl_devices.h"

namespace tessera::worker {

namespace {

/// On their way to the device: 40 MB, and up to a segment's PADs for the index.
constexpr std::uint32_t kShapesAtATime = 512;

}  // namespace

DeviceLibrary::DeviceLibrary(const cl::Device& device, const MatchingContext& context, const ShapeRange& shapes,
                             const ModelSource& models, const BetweenLaunches& between_launches,
                             std::optional<DockingLanes> lanes)
    : pad_levels_(context.pad.levels),
      lanes_(lanes ? *lanes : lanes_for(device)),
      session_(device, kernel_source, kernel_options(context.pad.levels, lanes_), between_launches),
      match_(make_match_record(context, shapes)),
      match_buffer_(session_, {match_}),
      index_(session_, match_, pad_levels_),
      keypoints_(session_),
      contours_(session_),
      shapes_(session_),
      field_(session_),
      size_map_(session_, context.size_map ? context.size_map->part.data() : std::vector<float>()),
      all_stances_(context.stances),
      stances_(session_),
      colours_(session_, context) {
  stances_.write(all_stances_, shapes);
  if (match_.shapes == 0) reserve_nothing();
  for (std::uint32_t first = shapes.begin; first < shapes.end; first += kShapesAtATime) {
    const ShapeRange part{first, std::min(shapes.end, first + kShapesAtATime)};
    upload(make_shard(match_, pad_levels_, models(part)), first - shapes.begin);
    if (between_launches) between_launches();
  }
}

/// Kernels want buffers for arguments even where there is nothing for them to do.
void DeviceLibrary::reserve_nothing() {
  keypoints_.reserve(0);
  contours_.reserve(0);
  shapes_.reserve(0);
}

void DeviceLibrary::upload(const Shard& part, std::uint32_t first) {
  const auto all_of = [&](auto& buffer, const auto& content) {
    buffer.write_part(content, first, part.shapes.size(), match_.shapes);
  };
  index_.add(part.pads);
  all_of(keypoints_, part.keypoints);
  all_of(contours_, part.contours);
  all_of(shapes_, part.shapes);
}

void DeviceLibrary::limit(const StandingLimits& limits) {
  const StanceTable stances = all_stances_.limited(limits);
  stances_.write(stances, {match_.first_shape, match_.first_shape + match_.shapes});
  colours_.start(stances);
}

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
