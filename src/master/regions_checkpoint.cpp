// Regions: what a checkpoint keeps of them, and how it is known to belong to the job.
#include <algorithm>
#include <bit>
#include <string>

#include "core/base/count_text.h"
#include "core/base/digest.h"
#include "core/base/error.h"
#include "master/regions.h"

namespace tessera::master {
namespace {

[[noreturn]] void refuse(const CheckpointState& from, const std::string& why) {
  throw InputError(from.name + ": " + why + "; --restart removes it and starts again");
}

}  // namespace

void Regions::save(CheckpointState& state) const {
  const bool fills = state.loop.phase == LoopPhase::filling;
  state.search = fills ? current_->filling.search() : 0;
  sizes_.save(state);
  state.begun_with = begun_with();
  current_->collage.save(state);
}

void Regions::restore(const CheckpointState& from) {
  const std::uint32_t region = from.loop.region;
  if (region >= std::max<std::size_t>(1, canvas_.regions.size()) || from.given > from.placements.size() ||
      !sizes_.restore(from)) {
    refuse(from, "not a checkpoint of this job: region " + std::to_string(region) + ", attempt " +
                     std::to_string(from.sizes.attempt));
  }
  check_belongs(from);
  begin_again(region, from.placements, from.given, sizes_);
  current_->collage.restore(from);
  const int searches = std::max(from.search, int(from.searched));
  if (searches > current_->filling.most_searches())
    refuse(from, "not a checkpoint of this job: a sample was searched " + std::to_string(searches) + " times");
  current_->filling.restore_search(from.search);
}

void Regions::check_belongs(const CheckpointState& from) const {
  for (std::size_t i = 0; i < from.given; ++i) {
    if (index_of(from.placements[i].shape) < context_.library_shapes) continue;
    refuse(from, "not a checkpoint of this library");
  }
  const bool as_many =
      from.loop.region > 0 ? from.given >= settings_.wishes.locked() : from.given == given_.at_first().given;
  if (as_many && from.begun_with == begun_with()) return;
  throw InputError(from.name +
                   ": the pieces of [[given]] or start.pieces have changed since it was written; give the " +
                   "old ones, or --restart, which removes it and starts again");
}

/// A digest of all pieces that the job gives; improving may have taken out some of them since.
std::uint64_t Regions::begun_with() const {
  Digest digest;
  for (const GivenPiece& piece : settings_.wishes.given) {
    const Similarity& pose = piece.canvas_from_shape;
    digest.add(std::uint64_t(index_of(piece.shape)) << 2 | std::uint64_t(piece.for_good) << 1 |
               std::uint64_t(piece.locked));
    for (const float number : {pose.a, pose.b, pose.tx, pose.ty, piece.score, piece.matched_px}) {
      digest.add(std::bit_cast<std::uint32_t>(number));
    }
  }
  return digest.value();
}

}  // namespace tessera::master
