// The pairs of target samples and shape PADs that are docked: found on a device, chosen and kept here. They are counted
// for the top K % threshold, farther each time, and docked for the same samples thereafter.
#pragma once

#include "worker/pair_search.h"
#include "worker/sample_records.h"

namespace tessera::worker {

class PairStage {
 public:
  PairStage(const DeviceLibrary& library, std::size_t stage_bytes);

  /// Records without reach: whose pairs are counted from here on. What is held of the same samples stays.
  void set_samples(std::vector<SampleRecord> samples);
  /// As CountRequest says.
  void post_count(std::vector<std::uint32_t> bins, std::uint32_t segment_stride);
  /// Waits for what is on the device and posts what is to be searched next; false where nothing is.
  bool step_count();
  /// As in Matcher.
  bool step_is_ready() const;
  std::vector<DistanceHistogram> take_count();

  /// The pairs of these samples whose bins are below each one's limit, by sample, then by shape, best first. Waits for
  /// the device where they have not been counted.
  std::vector<PairRecord> pairs_of(std::vector<SampleRecord> samples, const std::vector<std::uint32_t>& bin_limit);

  /// The pairs that are there do not count any more.
  void forget() { held_.assign(samples_.size(), {}); }

  PairSearch& search() { return search_; }

 private:
  /// A sample's pairs of the first `bins` bins.
  struct Held {
    std::uint32_t bins = 0;
    std::vector<PairRecord> pairs;
  };

  /// Searches for each sample the bins below `bins[t]`, where they are more than it holds.
  void post_search(const std::vector<std::uint32_t>& bins, std::uint32_t segment_stride);
  void post_run();
  /// Takes what is on the device and posts the next samples of the same search.
  void take_run();
  bool run_is_posted() const { return run_begin_ < run_end_; }
  void hold(const std::vector<PairRecord>& pairs);
  DistanceHistogram counted(const std::vector<PairRecord>& pairs, std::uint32_t bins) const;

  const DeviceLibrary* library_;
  PairSearch search_;
  std::vector<SampleRecord> samples_;
  std::vector<Held> held_;                 // by sample
  std::vector<std::uint32_t> asked_bins_;  // by sample
  std::vector<Held> estimated_;            // by sample, of some segments alone

  struct Searched {
    std::uint32_t sample;
    std::uint32_t bins;
  };
  std::vector<Searched>
      searched_;  // what is being searched, some after others: [run_begin_, run_end_) are on the device
  std::uint32_t segment_stride_ = 1;
  std::uint32_t run_begin_ = 0;
  std::uint32_t run_end_ = 0;
  std::uint32_t run_samples_ = 0;  // at a time
  DeviceBuffer<SampleRecord> run_records_;
};

}  // namespace tessera::worker
