// The pairs of target samples and shape PADs that are docked: found on a device, chosen and kept here. They are counted
// for the top K % threshold, and docked for the same samples thereafter.
#pragma once

#include "worker/pair_search.h"
#include "worker/sample_records.h"

namespace tessera::worker {

class PairStage {
 public:
  PairStage(const DeviceLibrary& library, std::size_t stage_bytes);

  /// `samples`: records without reach. Looks as far as it takes to find more than `most_pairs` of each.
  void post_count(std::vector<SampleRecord> samples, std::uint64_t most_pairs);
  /// Waits for what is on the device and posts what is to be searched next; false where nothing is.
  bool step_count();
  std::vector<DistanceHistogram> take_count();

  /// The pairs of these samples whose bins are below each one's limit, by sample, then by shape, best first. Waits for
  /// the device where they have not been counted.
  std::vector<PairRecord> pairs_of(std::vector<SampleRecord> samples, const std::vector<std::uint32_t>& bin_limit);

  /// The pairs that are there do not count any more.
  void forget() { remembers_ = false; }

  PairSearch& search() { return search_; }

 private:
  /// A sample's pairs of the first `bins` bins.
  struct Held {
    std::uint32_t bins = 0;
    std::vector<PairRecord> pairs;
  };

  void set_samples(std::vector<SampleRecord> samples);
  /// Searches for each sample the bins below `bins[t]`, where they are more than it holds.
  void post_search(const std::vector<std::uint32_t>& bins);
  void post_run();
  /// Takes what is on the device and posts the next samples of the same search.
  void take_run();
  bool run_is_posted() const { return run_begin_ < run_end_; }
  void hold(const std::vector<PairRecord>& pairs);
  /// How far to look next: nowhere where there are enough pairs.
  std::vector<std::uint32_t> next_bins() const;

  const DeviceLibrary* library_;
  PairSearch search_;
  std::vector<SampleRecord> samples_;
  std::vector<Held> held_;  // by sample
  bool remembers_ = false;  // what is held still counts
  std::uint64_t most_pairs_ = 0;

  struct Searched {
    std::uint32_t sample;
    std::uint32_t bins;
  };
  std::vector<Searched>
      searched_;  // what is being searched, some after others: [run_begin_, run_end_) are on the device
  std::uint32_t run_begin_ = 0;
  std::uint32_t run_end_ = 0;
  std::uint32_t run_samples_ = 0;  // at a time
  DeviceBuffer<SampleRecord> run_records_;
};

}  // namespace tessera::worker
