#include "worker/shard/device_index.h"

#include <algorithm>
#include <limits>

#include "core/base/rank_pool.h"

namespace tessera::worker {

DeviceIndex::DeviceIndex(const DeviceSession& session, const MatchRecord& match, const IndexKind& kind,
                         const ModelSource& models)
    : session_(&session),
      match_(match),
      kind_(kind),
      models_(&models),
      parts_(index_parts(match)),
      roots_(session, {}),
      node_boxes_(session, {}),
      block_boxes_(session, {}),
      rows_(session, {}),
      places_(session, {}),
      chords_(session, {}) {
  if (std::uint64_t(match.shapes) * match.sources > std::numeric_limits<std::uint32_t>::max() - match.sources) {
    throw EnvironmentError("a device cannot hold " + std::to_string(match.shapes) +
                           " shapes: give the job more devices or ranks");
  }
  if (!parts_.empty()) root_count_ = parts_.back().first_root + parts_.back().roots;
}

std::uint32_t DeviceIndex::block_count() const {
  return parts_.empty() ? 0 : (parts_.back().first_node + parts_.back().nodes) * kIndexFanOut;
}

void DeviceIndex::add(IndexedPads pads) {
  const auto append = [](auto& all, auto& more) {
    if (all.empty()) return all.swap(more);
    all.insert(all.end(), more.begin(), more.end());
  };
  const auto drop = [](auto& all, std::size_t count) {
    all.erase(all.begin(), all.begin() + std::ptrdiff_t(std::min(count, all.size())));
  };
  append(waiting_.pads, pads.pads);
  append(waiting_.chords, pads.chords);
  while (next_part_ < parts_.size()) {
    const std::size_t whole = std::size_t(parts_[next_part_].shapes) * match_.sources;
    if (waiting_.pads.size() < whole) return;
    add_segment();
    drop(waiting_.pads, whole);
    drop(waiting_.chords, whole);
  }
  waiting_ = {};
}

/// Adds the next segment, all levels at the same time: for a large library this takes most of the loading time.
void DeviceIndex::add_segment() {
  const std::size_t first = next_part_;
  while (next_part_ < parts_.size() && parts_[next_part_].first_shape == parts_[first].first_shape) ++next_part_;
  std::vector<IndexRows> made(next_part_ - first);
  parallel_for(made.size(), [&](std::size_t i) { made[i] = rows_of(parts_[first + i]); });
  session_->finish();  // so that no more than one segment is on its way
  for (std::size_t i = 0; i < made.size(); ++i) upload(parts_[first + i], std::move(made[i]));
  session_->flush();
}

IndexRows DeviceIndex::rows_of(const IndexPart& part) const {
  const u32 first = match_.first_shape + part.first_shape;
  return make_index_rows(part, match_, waiting_, kind_, models_->pad_order({first, first + part.shapes}, part.level));
}

void DeviceIndex::upload(const IndexPart& part, IndexRows made) {
  const u32 all_nodes = parts_.back().first_node + parts_.back().nodes;
  roots_.post_part(std::move(made.roots), part.first_root, part.roots, root_count_);
  node_boxes_.post_part(std::move(made.node_boxes), part.first_root, part.roots, root_count_);
  block_boxes_.post_part(std::move(made.block_boxes), part.first_node, part.nodes, all_nodes);
  rows_.post_part(std::move(made.rows), part.first_node, part.nodes, all_nodes);
  places_.post_part(std::move(made.places), part.first_node, part.nodes, all_nodes);
  if (kind_.with_chords) chords_.post_part(std::move(made.chords), part.first_node, part.nodes, all_nodes);
}

}  // namespace tessera::worker
