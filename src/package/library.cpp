#include "tessera/matching/library.h"

#include "core/shape/shape.h"
#include "package/hdf5_turn.h"
#include "package/library_state.h"
#include "package/own_pad.h"
#include "package/translated_errors.h"

namespace tessera::matching {
namespace {

static_assert(kLibraryLevels == int(kSmoothingLevels.size()));

/// Reads parts of one shape.
Shape read_shape(const LibraryFile& file, std::size_t shape, const LibraryParts& parts) {
  if (shape >= file.size()) {
    throw Error(file.path() + ": found the shape number " + std::to_string(shape) + ", allowed: 0 to " +
                std::to_string(file.size() - 1));
  }
  return file.read(shape, shape + 1, parts).front();
}

void check_level(int level) {
  if (level >= 0 && level < kLibraryLevels) return;
  throw Error("level: found " + std::to_string(level) + ", allowed: 0 to " + std::to_string(kLibraryLevels - 1));
}

}  // namespace

Library::Library(const std::string& path) {
  with_errors_translated([&] {
    const Hdf5Turn turn;
    state_ = std::make_unique<State>(State{LibraryFile(path), {}});
    for (ShapeHead& head : state_->file.heads(0, state_->file.size())) state_->names.push_back(std::move(head.name));
  });
}

Library::~Library() {
  if (!state_) return;  // moved from
  const Hdf5Turn turn;
  state_.reset();
}

Library::Library(Library&&) noexcept = default;

Library& Library::operator=(Library&& other) noexcept {
  std::swap(state_, other.state_);
  return *this;
}

std::size_t Library::size() const { return state_->names.size(); }

const std::vector<std::string>& Library::names() const { return state_->names; }

Outline Library::outline(std::size_t shape) const {
  return with_errors_translated([&] {
    const Hdf5Turn turn;
    Outline outline;
    for (const std::vector<Vec2>& points :
         read_shape(state_->file, shape, {.outline = true, .field = false, .levels = 0, .artwork = false})
             .outline.curves) {
      Curve& curve = outline.curves.emplace_back();
      for (const Vec2 p : points) curve.points.push_back({p.x, p.y});
    }
    return outline;
  });
}

std::vector<Pad> Library::pads(std::size_t shape, int level) const {
  return with_errors_translated([&] {
    check_level(level);
    const Hdf5Turn turn;
    const Shape read = read_shape(
        state_->file, shape, {.outline = false, .field = false, .levels = std::uint32_t(1) << level, .artwork = false});
    const LevelCurve& curve = read.levels[std::size_t(level)];
    const int levels = state_->file.pad_parameters().levels;
    std::vector<Pad> pads;
    for (const ArclengthPyramid& pyramid : curve.samples) {
      Pad pad = own_pad({pyramid, levels, levels}, levels, {});
      pad.along = double(curve.perimeter) * double(pads.size()) / double(curve.samples.size());
      pads.push_back(std::move(pad));
    }
    return pads;
  });
}

double Library::smoothing(int level) {
  check_level(level);
  return kSmoothingLevels[std::size_t(level)].sigma;
}

int Library::pad_levels() const { return state_->file.pad_parameters().levels; }

double Library::pad_delta_tau_rad() const { return state_->file.pad_parameters().delta_tau; }

}  // namespace tessera::matching
