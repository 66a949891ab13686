#include "worker/shard/device_stances.h"

namespace tessera::worker {
namespace {

StanceRecord record_of(const Stance& s) {
  const DirectionRange& rotations = s.poses.rotations;
  return {s.poses.min_scale_px,      s.poses.max_scale_px,     s.log2_scale_ratio, s.weight,
          rotations.middle.x,        rotations.middle.y,       rotations.edge.x,   rotations.edge.y,
          s.docked_rotations.edge.x, s.docked_rotations.edge.y};
}

}  // namespace

DeviceStances::DeviceStances(const DeviceSession& session)
    : stances_(session),
      lists_(session),
      shape_class_(session),
      open_shapes_(session) {}

void DeviceStances::write(const StanceTable& table, const ShapeRange& shapes) {
  std::vector<StanceRecord> stances;
  for (const Stance& s : table.stances()) stances.push_back(record_of(s));
  std::vector<StanceListRecord> lists;
  for (const StanceList& l : table.lists()) lists.push_back({l.first, l.count, l.min_scale_px, l.max_scale_px});
  std::vector<std::uint32_t> shape_class;
  for (std::uint32_t shape = shapes.begin; shape < shapes.end; ++shape) {
    shape_class.push_back(table.class_of(ShapeId(shape)));
  }
  stances_.write(stances);
  lists_.write(lists);
  shape_class_.write(shape_class);
  open_count_ = table.open_shapes();
  all_open_ = table.all_open();
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 0; !all_open_ && i < open_count_; ++i) open.push_back(index_of(table.open_shape(i)));
  open_shapes_.write(open);
}

}  // namespace tessera::worker
