#include "worker/sample_records.h"

#include <algorithm>
#include <cstring>

#include "core/matching/matcher.h"
#include "core/pad/pad_filter.h"

namespace tessera::worker {
namespace {

void put_scale_windows(SampleRecord& r, const MatchRecord& match) {
  for (u32 k = 0; k < match.level_count; ++k) {
    const LevelRecord& level = match.level[k];
    const ScaleWindow window = scale_window(r.scale_length / (level.scale_high_px * kScaleWindowHigh),
                                            r.scale_length / (level.scale_low_px * kScaleWindowLow));
    r.scale_low[k] = window.low;
    r.scale_width[k] = window.width;
  }
}

void put_reach(SampleRecord& r, const QuantisedPad& pad, std::uint32_t reach_steps) {
  const PadWindow window = pad_window(pad, reach_steps);
  r.reach = reach_steps;
  std::copy(window.low.begin(), window.low.end(), r.pad_low);
  r.pad_width = window.width;
}

SampleRecord make_sample_record(const TargetSample& sample, std::uint32_t reach_steps, const MatchRecord& match,
                                int pad_levels) {
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
  put_reach(r, pad, reach_steps);
  r.signs = sign_byte(r.convexity);
  put_scale_windows(r, match);
  for (int i = 0; i < kMaxKeypoints; ++i) {
    r.keypoint_x[i] = sample.pyramid.keypoint[i].x;
    r.keypoint_y[i] = sample.pyramid.keypoint[i].y;
  }
  return r;
}

bool same_sample(SampleRecord a, const SampleRecord& b) {
  a.reach = b.reach;
  a.held_reach = b.held_reach;
  std::copy_n(b.pad_low, kMaxPadElements, a.pad_low);
  a.pad_width = b.pad_width;
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

std::vector<SampleRecord> make_sample_records(const std::vector<TargetSample>& samples,
                                              const std::vector<std::uint32_t>& bin_reach, const MatchRecord& match,
                                              int pad_levels) {
  std::vector<SampleRecord> records;
  records.reserve(samples.size());
  for (std::size_t t = 0; t < samples.size(); ++t) {
    records.push_back(make_sample_record(samples[t], reach_of_bins(bin_reach[t], match.beta_steps), match, pad_levels));
  }
  return records;
}

bool same_samples(const std::vector<SampleRecord>& a, const std::vector<SampleRecord>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_sample);
}

}  // namespace tessera::worker
