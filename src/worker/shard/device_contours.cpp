#include "worker/shard/device_contours.h"

#include <algorithm>
#include <numeric>

#include "worker/shard/shard.h"

namespace tessera::worker {
namespace {

/// Contours read at a time: 2.4 MB on their way to the device.
constexpr std::size_t kReadAtATime = 512;

}  // namespace

DeviceContours::DeviceContours(const DeviceSession& session, const ShapeRange& shard, const ModelSource& models,
                               std::optional<std::uint32_t> places)
    : shard_(shard),
      models_(&models),
      reads_(places.has_value()),
      contours_(session),
      places_(session),
      place_of_shape_(shard.size(), kNowhere) {
  if (reads_) {
    held_.resize(std::min(shard.size(), *places));
  } else {
    std::iota(place_of_shape_.begin(), place_of_shape_.end(), 0u);
  }
  contours_.reserve(std::size_t(reads_ ? std::uint32_t(held_.size()) : shard.size()) * kContourFloats);
  places_.write(place_of_shape_);
}

void DeviceContours::add(const std::vector<ShapeModel>& models) {
  if (reads_) return;
  std::vector<float> contours;
  contours.reserve(models.size() * kContourFloats);
  for (const ShapeModel& model : models) append_contour(contours, model);
  contours_.write_at(std::size_t(added_) * kContourFloats, contours);
  added_ += std::uint32_t(models.size());
}

void DeviceContours::need(std::span<const ShapeId> shapes) {
  if (!reads_) return;
  std::vector<std::uint32_t> wanted;
  for (const ShapeId shape : shapes) {
    if (shard_.contains(shape)) wanted.push_back(shard_.position_of(shape));
  }
  std::sort(wanted.begin(), wanted.end());
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  if (wanted.size() > held_.size()) make_places(wanted.size());
  ++question_;
  std::vector<std::uint32_t> missing;
  for (const std::uint32_t shape : wanted) {
    const std::uint32_t place = place_of_shape_[shape];
    if (place == kNowhere) {
      missing.push_back(shape);
    } else {
      held_[place].needed = question_;
    }
  }
  if (missing.empty()) return;
  for (std::size_t first = 0; first < missing.size(); first += kReadAtATime) {
    read(std::span(missing).subspan(first, std::min(kReadAtATime, missing.size() - first)));
  }
  places_.write(place_of_shape_);
}

/// Makes more places and gives up all contours that are there: a question that needs more than all places is rare.
void DeviceContours::make_places(std::size_t count) {
  held_.assign(std::max(count, held_.size() + held_.size() / 2), {});
  std::fill(place_of_shape_.begin(), place_of_shape_.end(), kNowhere);
  contours_.reserve(held_.size() * kContourFloats);
  next_place_ = 0;
}

/// The next place, in circular order, that the present question does not need.
std::uint32_t DeviceContours::next_place() {
  std::uint32_t place = next_place_;
  while (held_[place].needed == question_) place = (place + 1) % std::uint32_t(held_.size());
  next_place_ = (place + 1) % std::uint32_t(held_.size());
  return place;
}

void DeviceContours::read(std::span<const std::uint32_t> shapes) {
  std::vector<ShapeId> ids;
  for (const std::uint32_t shape : shapes) ids.push_back(shard_.at(shape));
  const std::vector<ShapeModel> models = models_->contours(ids);
  std::vector<float> run;  // of places that follow one another: they are written together
  std::uint32_t run_begin = 0;
  const auto write_run = [&] {
    contours_.write_at(std::size_t(run_begin) * kContourFloats, run);
    run.clear();
  };
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::uint32_t place = next_place();
    if (!run.empty() && place != run_begin + run.size() / kContourFloats) write_run();
    if (run.empty()) run_begin = place;
    append_contour(run, models[i]);
    if (held_[place].shape != kNowhere) place_of_shape_[held_[place].shape] = kNowhere;
    held_[place] = {shapes[i], question_};
    place_of_shape_[shapes[i]] = place;
  }
  write_run();
}

}  // namespace tessera::worker
