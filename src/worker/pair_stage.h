// The pairs of target samples and shape PADs on a device (kernels/pairs.cl), counted for the top K % threshold and kept
// for the docking of the same samples.
#pragma once

#include "worker/device_library.h"
#include "worker/sample_records.h"

namespace tessera::worker {

class PairStage {
 public:
  /// `stage_bytes`: of pairs on the device at a time.
  PairStage(const DeviceLibrary& library, std::size_t stage_bytes);

  void post_count(std::vector<SampleRecord> samples);
  std::vector<DistanceHistogram> take_count();

  /// Puts the samples of the requests that follow on the device.
  void set_samples(std::vector<SampleRecord> samples);
  const DeviceBuffer<SampleRecord>& samples() const { return sample_buffer_; }

  /// Posts the pairs of samples [first, end) of those set, within their reach, where they are not there already.
  /// Returns the sample with which pairs() begins.
  std::uint32_t need(std::uint32_t first, std::uint32_t end);
  const DeviceBuffer<PairRecord>& pairs() const { return pairs_; }
  const DeviceBuffer<std::uint32_t>& pair_count() const { return pair_count_; }

  /// The pairs that are there do not count any more.
  void forget() { held_ = {}; }

  /// So few that the buffers stay small, however large the library.
  std::uint32_t samples_at_a_time() const;
  std::size_t stage_bytes() const { return stage_bytes_; }

 private:
  const DeviceLibrary* library_;
  std::size_t stage_bytes_;
  cl::Kernel select_pairs_;
  cl::Kernel count_pairs_;
  std::vector<SampleRecord> samples_;
  DeviceBuffer<SampleRecord> sample_buffer_;
  DeviceBuffer<PairRecord> pairs_;
  DeviceBuffer<std::uint32_t> pair_count_;
  DeviceBuffer<std::uint32_t> histograms_;
  bool holds(std::uint32_t first, std::uint32_t end) const;

  struct Held {  // samples [begin, end), whose pairs are on the device
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };
  Held held_;
};

/// Samples in a work group of kernels that run over (sample, shape): they share the shape's data in a cache.
inline constexpr std::size_t kSamplesPerGroup = 16;

}  // namespace tessera::worker
