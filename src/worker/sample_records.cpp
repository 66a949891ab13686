#include "worker/sample_records.h"

#include <algorithm>
#include <cstring>

#include "core/matching/matcher.h"
#include "core/matching/near_colours.h"
#include "core/pad/pad_filter.h"

namespace tessera::worker {
namespace {

void put_scale_windows(SampleRecord& r, const MatchRecord& match) {
  for (u32 k = 0; k < match.level_count; ++k) {
    const LevelRecord& level = match.level[k];
    const ScaleWindow window = scale_window(r.scale_length / (level.scale_high_px * kScaleWindowHigh),
                                            r.scale_length / (level.scale_low_px * kScaleWindowLow));
    r.scale_low[k] = window.low;
    r.scale_high[k] = window.high;
  }
}

SampleRecord make_sample_record(const TargetSample& sample, const MatchRecord& match, int pad_levels) {
  SampleRecord r{};
  r.position_x = sample.position.x;
  r.position_y = sample.position.y;
  r.tangent_x = sample.tangent.x;
  r.tangent_y = sample.tangent.y;
  r.edge = edge_number(sample.id);
  r.pass = sample.pass;
  r.scale_length = scale_length(sample.pyramid, pad_levels);
  r.convexity = sample.pyramid.convexity;
  const QuantisedPad pad = quantised(make_pad(sample.pyramid, pad_levels));
  std::copy(pad.element.begin(), pad.element.end(), r.element);
  r.signs = sign_byte(r.convexity);
  r.near_list = NearColours::kAny;
  put_scale_windows(r, match);
  const Vec2 turn = chord(sample.pyramid, pad_levels);
  r.chord_x = turn.x;
  r.chord_y = turn.y;
  for (int i = 0; i < kMaxKeypoints; ++i) {
    r.keypoint_x[i] = sample.pyramid.keypoint[i].x;
    r.keypoint_y[i] = sample.pyramid.keypoint[i].y;
  }
  return r;
}

}  // namespace

std::vector<SampleRecord> make_sample_records(const std::vector<TargetSample>& samples, const MatchRecord& match,
                                              int pad_levels) {
  std::vector<SampleRecord> records;
  records.reserve(samples.size());
  for (const TargetSample& sample : samples) records.push_back(make_sample_record(sample, match, pad_levels));
  return records;
}

void set_reach(SampleRecord& record, std::uint32_t reach_steps) {
  QuantisedPad pad;
  std::copy(std::begin(record.element), std::end(record.element), pad.element.begin());
  const PadWindow window = pad_window(pad, reach_steps);
  record.reach = reach_steps;
  std::copy(window.low.begin(), window.low.end(), record.pad_low);
  std::copy(window.high.begin(), window.high.end(), record.pad_high);
}

bool same_samples(const std::vector<SampleRecord>& a, const std::vector<SampleRecord>& b) {
  const auto same = [](const SampleRecord& x, const SampleRecord& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

}  // namespace tessera::worker
