#include "worker/shard/device_library.h"

#include <algorithm>
#include <array>
#include <future>
#include <optional>

#include "worker/devices/arithmetic_probe.h"
#include "worker/devices/opencl_devices.h"

namespace tessera::worker {

namespace {

/// The end of the shapes that go to the device together with shape `first`. `whole`: with contours and key points, so that a
/// few hundred take 40 MB; otherwise a segment takes 20 MB. A whole segment is read while the one before it gets its index.
std::uint32_t end_of_portion(std::uint32_t first, bool whole) {
  constexpr std::uint32_t kWholeShapes = 512;
  return whole ? first + kWholeShapes : (first / kSegmentShapes + 1) * kSegmentShapes;
}

}  // namespace

DeviceLibrary::DeviceLibrary(const cl::Device& device, const MatchingContext& context, const ShapeRange& shapes,
                             std::shared_ptr<const ModelSource> models, const BetweenLaunches& between_launches,
                             const HeldShapes& held, std::optional<DockingLanes> lanes)
    : models_(std::move(models)),
      pad_levels_(context.pad.levels),
      reads_(models_->supports_random_access() && !held.holds_all(shapes.size())),
      lanes_(lanes ? *lanes : lanes_for(device)),
      session_(device, kernel_source, kernel_options(context.pad.levels, lanes_), between_launches),
      match_(make_match_record(context, shapes)),
      match_buffer_(session_, {match_}),
      index_(session_, match_, index_kind(context), *models_),
      keypoints_(match_, pad_levels_, *models_, reads_),
      sketches_(session_, {}),
      contours_(session_, shapes, *models_, reads_ ? std::optional(held.contours) : std::nullopt),
      shapes_(session_, {}),
      field_(session_),
      size_map_(session_, context.size_map ? context.size_map->part.data() : std::vector<float>()),
      all_stances_(context.stances),
      context_(context),
      stances_(session_),
      colours_(session_, context) {
  check_arithmetic(session_);
  stances_.write(all_stances_, shapes);
  load(between_launches);
}

void DeviceLibrary::load(const BetweenLaunches& between_launches) {
  // Without key points there are no chords.
  const bool keypoints = !reads_ || index_.kind().with_chords;
  const ModelParts parts{.contours = !reads_, .pads = keypoints, .keypoints = keypoints};
  const std::uint32_t end = match_.first_shape + match_.shapes;
  const auto end_from = [&](std::uint32_t first) { return std::min(end, end_of_portion(first, keypoints)); };
  const auto read_from = [&](std::uint32_t first) {
    const ShapeRange range{first, end_from(first)};
    Loaded loaded;
    if (range.size() > 0) loaded.models = models_->models(range, parts);
    if (range.size() > 0 && !parts.pads) loaded.pads = models_->pads(range);
    return loaded;
  };
  // A second thread reads the next shapes while these are put on the device. It mostly waits for the disk, so it is of use
  // on one core, too. Where no thread can be started, the shapes are read later.
  Loaded next = read_from(match_.first_shape);
  for (std::uint32_t first = match_.first_shape; first < end; first = end_from(first)) {
    Loaded loaded = std::move(next);
    std::future<Loaded> following = std::async(std::launch::async | std::launch::deferred, read_from, end_from(first));
    add(std::move(loaded), first - match_.first_shape);
    next = following.get();
    if (between_launches) between_launches();
  }
}

void DeviceLibrary::add(Loaded loaded, std::uint32_t first) {
  const std::vector<ShapeModel>& models = loaded.models;
  Shard part = make_shard(match_, index_.kind(), models, std::move(loaded.pads));
  index_.add(std::move(part.pads));
  keypoints_.add(models);
  sketches_.post_part(std::move(part.sketches), first, models.size(), match_.shapes);
  contours_.add(models);
  shapes_.post_part(std::move(part.shapes), first, models.size(), match_.shapes);
}

void DeviceLibrary::limit(const StanceLimits& limits) {
  tessera::limit(context_, all_stances_, limits);
  stances_.write(context_.stances, {match_.first_shape, match_.first_shape + match_.shapes});
  colours_.start(context_);
  if (limits.size_factor == size_factor_) return;
  size_factor_ = limits.size_factor;
  set_sizes(match_, context_);
  match_buffer_.write({match_});
}

void DeviceLibrary::start_field(int width, int height, Vec2 origin) {
  match_.field_width = width;
  match_.field_height = height;
  match_.field_origin_x = origin.x;
  match_.field_origin_y = origin.y;
  match_buffer_.write({match_});
  field_.reserve(std::size_t(width) * height);
}

void DeviceLibrary::update_field(const std::vector<FieldPatch>& patches) {
  using Place = std::array<cl::size_type, 3>;
  checked(session_.name(), [&] {
    for (const FieldPatch& patch : patches) {
      if (patch.window.empty()) continue;
      const Place at = {patch.window.x0 * sizeof(float), cl::size_type(patch.window.y0), 0};
      const Place size = {patch.window.width() * sizeof(float), cl::size_type(patch.window.height()), 1};
      // Waits, because the patch belongs to the caller. Work that was posted before still reads the old field.
      session_.queue().enqueueWriteBufferRect(field_.get(), CL_TRUE, at, Place{0, 0, 0}, size,
                                              match_.field_width * sizeof(float), 0, size[0], 0, patch.value.data());
    }
  });
}

}  // namespace tessera::worker
