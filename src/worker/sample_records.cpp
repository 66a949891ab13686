#include "worker/sample_records.h"

#include <algorithm>
#include <cstring>

#include "worker/shard.h"

namespace tessera::worker {
namespace {

SampleRecord make_sample_record(const TargetSample& sample, int pad_levels) {
  SampleRecord r{};
  r.position_x = sample.position.x;
  r.position_y = sample.position.y;
  r.tangent_x = sample.tangent.x;
  r.tangent_y = sample.tangent.y;
  r.edge = sample.edge;
  r.pass = sample.pass;
  const int k = scale_level(pad_levels);
  r.scale_length = sample.pyramid.left[k] + sample.pyramid.right[k];
  const Pad pad = make_pad(sample.pyramid, pad_levels);
  r.convexity = pad.convexity;
  std::copy(pad.element.begin(), pad.element.end(), r.element);
  for (int i = 0; i < kMaxKeypoints; ++i) {
    r.keypoint_x[i] = sample.pyramid.keypoint[i].x;
    r.keypoint_y[i] = sample.pyramid.keypoint[i].y;
  }
  return r;
}

bool same_sample(SampleRecord a, const SampleRecord& b) {
  a.bin_limit = b.bin_limit;
  return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

std::vector<SampleRecord> make_sample_records(const std::vector<TargetSample>& samples,
                                              const std::vector<std::uint32_t>& bin_limit, int pad_levels) {
  std::vector<SampleRecord> records;
  records.reserve(samples.size());
  for (std::size_t t = 0; t < samples.size(); ++t) {
    records.push_back(make_sample_record(samples[t], pad_levels));
    if (!bin_limit.empty()) records.back().bin_limit = bin_limit[t];
  }
  return records;
}

bool same_samples(const std::vector<SampleRecord>& a, const std::vector<SampleRecord>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_sample);
}

}  // namespace tessera::worker
