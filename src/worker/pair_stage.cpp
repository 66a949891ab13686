#include "worker/pair_stage.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/base/rank_pool.h"
#include "worker/pair_choice.h"

namespace tessera::worker {
namespace {

/// Bounds of the samples in one search. Samples with very many pairs are searched in smaller numbers.
constexpr std::uint32_t kFewestSamplesAtATime = 256;
constexpr std::uint32_t kMostSamplesAtATime = 4096;

/// The number of samples to search at a time. Together they visit a million blocks, if each visits a sixteenth of all blocks.
/// Each search costs the host a few tenths of a ms.
std::uint32_t samples_at_a_time(std::uint32_t blocks) {
  constexpr std::uint32_t kBlocksAtATime = 1 << 20;
  return std::clamp(kBlocksAtATime / std::max(1u, blocks / 16), kFewestSamplesAtATime, kMostSamplesAtATime);
}

/// The pairs as keys, grouped by sample.
class KeysOfSamples {
 public:
  KeysOfSamples(const std::vector<PairRecord>& pairs, std::size_t samples) : end_(samples + 1, 0), keys_(pairs.size()) {
    for (const PairRecord& pair : pairs) ++end_[pair.sample + 1];
    std::partial_sum(end_.begin(), end_.end(), end_.begin());
    std::vector<std::size_t> next = end_;
    for (const PairRecord& pair : pairs) keys_[next[pair.sample]++] = pair_key(pair);
  }

  std::span<PairKey> of(std::size_t sample) {
    return std::span(keys_).subspan(end_[sample], end_[sample + 1] - end_[sample]);
  }

 private:
  std::vector<std::size_t> end_;  // by sample: end of the sample before it
  std::vector<PairKey> keys_;
};

}  // namespace

PairStage::PairStage(const DeviceLibrary& library, std::size_t stage_bytes)
    : library_(&library),
      search_(library, stage_bytes),
      run_records_(library.session()) {}

void PairStage::set_samples(std::vector<SampleRecord> samples) {
  const bool same = same_samples(samples, samples_);
  samples_ = std::move(samples);
  if (!same) forget();
}

void PairStage::post_search(const std::vector<std::uint32_t>& bins, std::uint32_t segment_stride) {
  segment_stride_ = segment_stride;
  if (segment_stride > 1) estimated_.assign(samples_.size(), {});
  searched_.clear();
  for (std::uint32_t t = 0; t < bins.size(); ++t) {
    if (bins[t] > (segment_stride > 1 ? 0 : held_[t].bins)) searched_.push_back({t, bins[t]});
  }
  run_begin_ = 0;
  run_samples_ = samples_at_a_time(library_->index().block_count() / segment_stride);
  post_run();
}

/// Posts the next samples of the search.
void PairStage::post_run() {
  run_end_ = std::uint32_t(std::min<std::size_t>(searched_.size(), run_begin_ + run_samples_));
  if (!run_is_posted()) return;
  std::vector<SampleRecord> records;
  for (std::uint32_t place = run_begin_; place < run_end_; ++place) {
    records.push_back(samples_[searched_[place].sample]);
    set_reach(records.back(), reach_of_bins(searched_[place].bins, library_->match().beta_steps));
  }
  run_records_.write(records);
  search_.post(run_records_, std::uint32_t(records.size()), segment_stride_);
}

void PairStage::take_run() {
  if (const auto pairs = search_.take()) {
    hold(*pairs);
    run_begin_ = run_end_;
  } else {
    run_samples_ = (run_end_ - run_begin_) / 2;  // these have more pairs than there may be room for
  }
  post_run();
}

/// Chooses and keeps pairs. With very many pairs that takes as long as the search, so the rank's threads share the samples.
void PairStage::hold(const std::vector<PairRecord>& pairs) {
  constexpr std::size_t kPairsOfATask = 1 << 13;
  const std::size_t samples = run_end_ - run_begin_;
  KeysOfSamples found(pairs, samples);
  std::vector<Held>& held = segment_stride_ > 1 ? estimated_ : held_;
  const std::size_t tasks = std::clamp<std::size_t>(pairs.size() / kPairsOfATask, 1, samples);
  parallel_for_portions(samples, (samples + tasks - 1) / tasks, [&](std::size_t k) {
    const Searched& searched = searched_[run_begin_ + k];
    held[searched.sample] = {searched.bins, docked_pairs(searched.sample, found.of(k), library_->match())};
  });
}

void PairStage::post_count(std::vector<std::uint32_t> bins, std::uint32_t segment_stride) {
  expect_bins_of(samples_.size(), bins);
  asked_bins_ = std::move(bins);
  post_search(asked_bins_, segment_stride);
}

bool PairStage::step_count() {
  if (run_is_posted()) take_run();
  return run_is_posted();
}

bool PairStage::step_is_ready() const { return !run_is_posted() || library_->session().launches_are_done(); }

std::vector<DistanceHistogram> PairStage::take_count() {
  while (step_count()) {
  }
  const std::vector<Held>& held = segment_stride_ > 1 ? estimated_ : held_;
  std::vector<DistanceHistogram> histograms;
  for (std::size_t t = 0; t < asked_bins_.size(); ++t) {
    if (asked_bins_[t] > 0) histograms.push_back(counted(held[t].pairs, asked_bins_[t]));
  }
  return histograms;
}

DistanceHistogram PairStage::counted(const std::vector<PairRecord>& pairs, std::uint32_t bins) const {
  DistanceHistogram histogram{};
  for (const PairRecord& pair : pairs) {
    const std::uint32_t bin = distance_bin(pair.distance, library_->match().beta_steps);
    if (bin < bins) ++histogram[bin];
  }
  return histogram;
}

std::vector<PairRecord> PairStage::pairs_of(std::vector<SampleRecord> samples,
                                            const std::vector<std::uint32_t>& bin_limit) {
  set_samples(std::move(samples));
  post_search(bin_limit, 1);
  while (run_is_posted()) take_run();
  std::vector<PairRecord> pairs;
  for (std::size_t t = 0; t < samples_.size(); ++t) {
    const std::uint32_t reach = reach_of_bins(bin_limit[t], library_->match().beta_steps);
    std::copy_if(held_[t].pairs.begin(), held_[t].pairs.end(), std::back_inserter(pairs),
                 [&](const PairRecord& pair) { return pair.distance < reach; });
  }
  return pairs;
}

}  // namespace tessera::worker
