#include "worker/device_index.h"

#include <algorithm>
#include <limits>

namespace tessera::worker {
namespace {

/// Puts the content of `places` equal places, the first of which is `first`, into a buffer of `all_places`. The first part
/// that comes makes the room.
template <class T>
void put(DeviceBuffer<T>& buffer, const std::vector<T>& content, std::size_t first, std::size_t places,
         std::size_t all_places) {
  const std::size_t of_a_place = content.size() / places;
  if (first == 0) buffer.reserve(all_places * of_a_place);
  buffer.write_at(first * of_a_place, content);
}

}  // namespace

DeviceIndex::DeviceIndex(const DeviceSession& session, const MatchRecord& match, int pad_levels)
    : match_(match),
      pad_levels_(pad_levels),
      parts_(index_parts(match)),
      roots_(session, {}),
      node_boxes_(session, {}),
      block_boxes_(session, {}),
      rows_(session, {}),
      places_(session, {}) {
  if (std::uint64_t(match.shapes) * match.sources > std::numeric_limits<std::uint32_t>::max() - match.sources) {
    throw EnvironmentError("a device cannot hold " + std::to_string(match.shapes) +
                           " shapes: give the job more devices or ranks");
  }
  if (!parts_.empty()) root_count_ = parts_.back().first_root + parts_.back().roots;
}

void DeviceIndex::add(const std::vector<IndexedPad>& pads) {
  waiting_.insert(waiting_.end(), pads.begin(), pads.end());
  while (next_part_ < parts_.size()) {
    const std::size_t whole = std::size_t(parts_[next_part_].shapes) * match_.sources;
    if (waiting_.size() < whole) return;
    const u32 segment = parts_[next_part_].first_shape;
    for (; next_part_ < parts_.size() && parts_[next_part_].first_shape == segment; ++next_part_) {
      upload(parts_[next_part_]);
    }
    waiting_.erase(waiting_.begin(), waiting_.begin() + std::ptrdiff_t(whole));
  }
  waiting_ = {};
}

void DeviceIndex::upload(const IndexPart& part) {
  const IndexRows made = make_index_rows(part, match_, waiting_, pad_levels_);
  const u32 all_nodes = parts_.back().first_node + parts_.back().nodes;
  put(roots_, made.roots, part.first_root, part.roots, root_count_);
  put(node_boxes_, made.node_boxes, part.first_root, part.roots, root_count_);
  put(block_boxes_, made.block_boxes, part.first_node, part.nodes, all_nodes);
  put(rows_, made.rows, part.first_node, part.nodes, all_nodes);
  put(places_, made.places, part.first_node, part.nodes, all_nodes);
}

}  // namespace tessera::worker
