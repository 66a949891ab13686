#include "worker/pair_stage.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "worker/found_pairs.h"

namespace tessera::worker {
namespace {

constexpr std::uint32_t kFewestBins = 2;
constexpr std::uint32_t kSamplesAtATime = 256;  // or fewer, where they have very many pairs

/// As far as samples look at first: in a larger library as many pairs are nearer, and fewer are nearer still. A third to
/// half of what most need with 120 and with 10,000 shapes: those that need less have not looked much too far.
std::uint32_t first_bins(std::uint32_t shapes, std::uint64_t most) {
  constexpr double kBinsOfOnePairAShape = 27;
  const double bins = kBinsOfOnePairAShape * std::cbrt((double(most) + 1) / (double(shapes) + 1));
  return std::uint32_t(std::clamp(bins, double(kFewestBins), kDistanceBins / 2.0));
}

/// How far to look where `bins` bins held `found` pairs: pairs grow about with the third power of the distance, and half
/// as many again as are wanted cost little.
std::uint32_t farther(std::uint32_t bins, std::size_t found, std::uint64_t most) {
  const double factor = std::cbrt(1.5 * (double(most) + 1) / double(std::max<std::size_t>(found, 1)));
  const auto next = std::uint32_t(std::ceil(double(bins) * std::clamp(factor, 1.0, 2.0)));
  return std::clamp(next, std::max(kFewestBins, bins + 1), std::uint32_t(kDistanceBins));
}

/// Of each sample a part of one list.
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
  std::vector<std::size_t> end_;  // of the sample before
  std::vector<PairKey> keys_;
};

}  // namespace

PairStage::PairStage(const DeviceLibrary& library, std::size_t stage_bytes)
    : library_(&library),
      search_(library, stage_bytes),
      run_records_(library.session()) {}

void PairStage::set_samples(std::vector<SampleRecord> samples) {
  if (!remembers_ || !same_samples(samples, samples_)) held_.assign(samples.size(), {});
  remembers_ = true;
  samples_ = std::move(samples);
}

void PairStage::post_search(const std::vector<std::uint32_t>& bins) {
  searched_.clear();
  for (std::uint32_t t = 0; t < samples_.size(); ++t) {
    if (bins[t] > held_[t].bins) searched_.push_back({t, bins[t]});
  }
  run_begin_ = 0;
  run_samples_ = kSamplesAtATime;
  post_run();
}

/// The next samples of those that are searched.
void PairStage::post_run() {
  run_end_ = std::uint32_t(std::min<std::size_t>(searched_.size(), run_begin_ + run_samples_));
  if (!run_is_posted()) return;
  std::vector<SampleRecord> records;
  for (std::uint32_t place = run_begin_; place < run_end_; ++place) {
    records.push_back(samples_[searched_[place].sample]);
    set_reach(records.back(), reach_of_bins(searched_[place].bins, library_->match().beta_steps));
  }
  run_records_.write(records);
  search_.post(run_records_, std::uint32_t(records.size()));
}

void PairStage::take_run() {
  if (const auto pairs = search_.take()) {
    hold(*pairs);
    run_begin_ = run_end_;
  } else {
    run_samples_ = (run_end_ - run_begin_) / 2;  // too many for all of them
  }
  post_run();
}

void PairStage::hold(const std::vector<PairRecord>& pairs) {
  KeysOfSamples found(pairs, run_end_ - run_begin_);
  for (std::uint32_t place = run_begin_; place < run_end_; ++place) {
    const Searched& searched = searched_[place];
    held_[searched.sample] = {searched.bins,
                              docked_pairs(searched.sample, found.of(place - run_begin_), library_->match())};
  }
}

std::vector<std::uint32_t> PairStage::next_bins() const {
  const std::uint32_t first = first_bins(library_->match().shapes, most_pairs_);
  std::vector<std::uint32_t> bins;
  for (const Held& held : held_) {
    const bool enough = held.pairs.size() > most_pairs_ || held.bins == kDistanceBins;
    bins.push_back(enough ? 0 : held.bins == 0 ? first : farther(held.bins, held.pairs.size(), most_pairs_));
  }
  return bins;
}

void PairStage::post_count(std::vector<SampleRecord> samples, std::uint64_t most_pairs) {
  set_samples(std::move(samples));
  most_pairs_ = most_pairs;
  post_search(next_bins());
}

bool PairStage::step_count() {
  if (!run_is_posted()) return false;
  take_run();
  if (!run_is_posted()) post_search(next_bins());
  return run_is_posted();
}

std::vector<DistanceHistogram> PairStage::take_count() {
  while (step_count()) {
  }
  std::vector<DistanceHistogram> histograms(samples_.size());
  for (std::size_t t = 0; t < samples_.size(); ++t) {
    for (const PairRecord& pair : held_[t].pairs) {
      ++histograms[t][distance_bin(pair.distance, library_->match().beta_steps)];
    }
    histograms[t] = ended_histogram(histograms[t], most_pairs_);
  }
  return histograms;
}

std::vector<PairRecord> PairStage::pairs_of(std::vector<SampleRecord> samples,
                                            const std::vector<std::uint32_t>& bin_limit) {
  set_samples(std::move(samples));
  post_search(bin_limit);
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
