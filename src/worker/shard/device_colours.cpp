#include "worker/shard/device_colours.h"

#include <algorithm>

namespace tessera::worker {
namespace {

std::vector<float> floats_of(const std::vector<Texel>& texels) {
  std::vector<float> floats;
  floats.reserve(4 * texels.size());
  for (const Texel& t : texels) floats.insert(floats.end(), {t.lightness, t.a, t.b, t.weight});
  return floats;
}

ColourRecord record_of(const ColourWish& wish, const NearColours& near_colours) {
  ColourRecord r{};
  if (!wish) return r;
  r.levels = u32(wish.target->levels().size());
  r.weight = wish.weight;
  r.near_words = near_colours.words();
  for (u32 k = 0; k < r.levels; ++k) {
    const ColourLevel& level = wish.target->levels()[k];
    r.level[k] = {level.width, level.height, level.first, level.texels_per_px};
  }
  return r;
}

}  // namespace

DeviceColours::DeviceColours(const DeviceSession& session, const MatchingContext& context)
    : wish_(context.colour),
      near_colours_(context.colour, context.colour_depth_px),
      record_(session),
      texels_(session),
      near_shapes_(session),
      near_bits_(session) {
  texels_.write(wish_ ? floats_of(wish_.target->texels()) : std::vector<float>());
  start(context);
}

void DeviceColours::start(const MatchingContext& context) {
  near_colours_.set_depth(context.colour_depth_px);
  near_colours_.start(context.stances);
  record_.write({record_of(wish_, near_colours_)});
  write_lists();
}

void DeviceColours::write_lists() {
  near_shapes_.write(near_colours_.all_shapes());
  near_bits_.write(near_colours_.all_bits());
  lists_on_device_ = near_colours_.all_bits().size();
}

void DeviceColours::assign_lists(const std::vector<TargetSample>& samples, std::vector<SampleRecord>& records) {
  for (std::size_t t = 0; t < samples.size(); ++t) records[t].near_list = near_colours_.list_for(samples[t]);
  if (near_colours_.all_bits().size() != lists_on_device_) write_lists();
}

}  // namespace tessera::worker
