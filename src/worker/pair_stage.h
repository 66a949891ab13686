// Finds pairs of target samples and shape PADs on a device, and keeps the ones that may be docked. Pairs are first counted
// for the top K % threshold, with a larger reach each time; then the same samples are docked.
#pragma once

#include "worker/pair_search.h"
#include "worker/sample_records.h"

namespace tessera::worker {

class PairStage {
 public:
  PairStage(const DeviceLibrary& library, std::size_t stage_bytes);

  /// Sets the samples whose pairs are counted from now on; their records have no reach. Pairs of the same samples are kept.
  void set_samples(std::vector<SampleRecord> samples);
  /// Posts the search for a CountRequest with these numbers of bins.
  void post_count(std::vector<std::uint32_t> bins, std::uint32_t segment_stride);
  /// Waits for the posted search and posts the next part of it. False where nothing is left to search.
  bool step_count();
  /// See Matcher::step_is_ready().
  bool step_is_ready() const;
  std::vector<DistanceHistogram> take_count();

  /// The pairs of these samples whose bins are below each sample's limit, by sample, then by shape, best first. Waits for
  /// the device where they were not counted before.
  std::vector<PairRecord> pairs_of(std::vector<SampleRecord> samples, const std::vector<std::uint32_t>& bin_limit);

  /// Forgets the pairs that were found, because they no longer count.
  void forget() { held_.assign(samples_.size(), {}); }

  PairSearch& search() { return search_; }

 private:
  /// A sample's pairs in the first `bins` bins.
  struct Held {
    std::uint32_t bins = 0;
    std::vector<PairRecord> pairs;
  };

  /// Posts the search of the bins below `bins[t]`, for each sample that does not hold them yet.
  void post_search(const std::vector<std::uint32_t>& bins, std::uint32_t segment_stride);
  void post_run();
  /// Takes the results from the device and posts the next samples of the same search.
  void take_run();
  bool run_is_posted() const { return run_begin_ < run_end_; }
  void hold(const std::vector<PairRecord>& pairs);
  DistanceHistogram counted(const std::vector<PairRecord>& pairs, std::uint32_t bins) const;

  const DeviceLibrary* library_;
  PairSearch search_;
  std::vector<SampleRecord> samples_;
  std::vector<Held> held_;                 // by sample
  std::vector<std::uint32_t> asked_bins_;  // by sample
  std::vector<Held> estimated_;            // by sample, from every `segment_stride_`-th segment

  struct Searched {
    std::uint32_t sample;
    std::uint32_t bins;
  };
  std::vector<Searched>
      searched_;  // what is being searched, some after others: [run_begin_, run_end_) are on the device
  std::uint32_t segment_stride_ = 1;
  std::uint32_t run_begin_ = 0;
  std::uint32_t run_end_ = 0;
  std::uint32_t run_samples_ = 0;  // samples in one run
  DeviceBuffer<SampleRecord> run_records_;
};

}  // namespace tessera::worker
