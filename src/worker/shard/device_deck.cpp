#include "worker/shard/device_deck.h"

namespace tessera::worker {
namespace {

/// The shapes at these places of each list of `length` shapes.
std::vector<std::uint32_t> picked(const std::vector<std::uint32_t>& lists, std::uint32_t length,
                                  const std::vector<std::uint32_t>& places) {
  std::vector<std::uint32_t> result;
  for (std::size_t first = 0; first < lists.size(); first += length) {
    for (const std::uint32_t place : places) result.push_back(lists[first + place]);
  }
  return result;
}

}  // namespace

DeviceDeck::DeviceDeck(DeviceLibrary& library)
    : library_(&library),
      open_shapes_(library.session()),
      near_shapes_(library.session()) {}

void DeviceDeck::draw(const std::vector<TargetSample>& samples) {
  const StanceTable& standing = library_->standing();
  const NearColours& colours = library_->colours().near_colours();
  deck_ =
      draw_deck(library_->match().seed, samples, standing.library_shapes(), standing.open_shapes(), colours.length());
  if (!deck_.open.empty()) open_shapes_.write(open_of_deck());
  if (!deck_.near.empty()) near_shapes_.write(near_of_deck());
  if (library_->contours().reads()) library_->contours().need(all_drawn());
}

std::vector<std::uint32_t> DeviceDeck::open_of_deck() const {
  std::vector<std::uint32_t> open;
  for (const std::uint32_t place : deck_.open) open.push_back(index_of(library_->standing().open_shape(place)));
  return open;
}

std::vector<std::uint32_t> DeviceDeck::near_of_deck() const {
  const NearColours& colours = library_->colours().near_colours();
  return picked(colours.all_shapes(), colours.length(), deck_.near);
}

std::vector<ShapeId> DeviceDeck::all_drawn() const {
  const StanceTable& standing = library_->standing();
  std::vector<ShapeId> drawn;
  if (deck_.open.empty()) {
    for (std::uint32_t place = 0; place < standing.open_shapes(); ++place) drawn.push_back(standing.open_shape(place));
  }
  for (const std::uint32_t shape : open_of_deck()) drawn.push_back(ShapeId(shape));
  const NearColours& colours = library_->colours().near_colours();
  for (const std::uint32_t shape : deck_.near.empty() ? colours.all_shapes() : near_of_deck()) {
    drawn.push_back(ShapeId(shape));
  }
  return drawn;
}

const DeviceBuffer<std::uint32_t>& DeviceDeck::open_shapes() const {
  return deck_.open.empty() ? library_->stances().open_shapes() : open_shapes_;
}

std::uint32_t DeviceDeck::open_count() const {
  return deck_.open.empty() ? library_->stances().open_count() : std::uint32_t(deck_.open.size());
}

const DeviceBuffer<std::uint32_t>& DeviceDeck::near_shapes() const {
  return deck_.near.empty() ? library_->colours().near_shapes() : near_shapes_;
}

std::uint32_t DeviceDeck::near_length() const {
  return deck_.near.empty() ? library_->colours().near_colours().length() : std::uint32_t(deck_.near.size());
}

}  // namespace tessera::worker
