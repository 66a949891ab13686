#include "worker/pair_stage.h"

#include <algorithm>

namespace tessera::worker {

PairStage::PairStage(const DeviceLibrary& library, std::size_t stage_bytes)
    : library_(&library),
      stage_bytes_(stage_bytes),
      select_pairs_(library.session().kernel("select_pairs")),
      count_pairs_(library.session().kernel("count_pairs")),
      sample_buffer_(library.session()),
      pairs_(library.session()),
      pair_count_(library.session()),
      histograms_(library.session()) {}

std::uint32_t PairStage::samples_at_a_time() const {
  const std::size_t bytes = library_->match().shapes * (kPairsPerShape * sizeof(PairRecord) + sizeof(std::uint32_t));
  return std::uint32_t(std::max<std::size_t>(1, stage_bytes_ / std::max<std::size_t>(1, bytes)));
}

void PairStage::set_samples(std::vector<SampleRecord> samples) {
  if (same_samples(samples, samples_)) {
    for (std::size_t t = held_.begin; t < held_.end; ++t) samples[t].held_reach = samples_[t].held_reach;
  } else {
    held_ = {};
  }
  samples_ = std::move(samples);
  sample_buffer_.write(samples_);
}

bool PairStage::holds(std::uint32_t first, std::uint32_t end) const {
  return first >= held_.begin && end <= held_.end &&
         std::all_of(samples_.begin() + first, samples_.begin() + end,
                     [](const SampleRecord& sample) { return sample.reach <= sample.held_reach; });
}

std::uint32_t PairStage::need(std::uint32_t first, std::uint32_t end) {
  if (holds(first, end)) return held_.begin;
  const std::uint32_t only_longer_reach = first == held_.begin && end == held_.end;
  const std::size_t places = std::size_t(end - first) * library_->match().shapes;
  pairs_.reserve(places * kPairsPerShape);
  pair_count_.reserve(places);
  launch(library_->session(), select_pairs_, {end - first, library_->match().shapes, kSamplesPerGroup},
         library_->match_buffer(), library_->stances().stances(), library_->stances().lists(),
         library_->stances().shape_class(), library_->pad_bytes(), library_->pads(), library_->pad_records(),
         library_->keypoints(), library_->colours().record(), library_->colours().near_bits(), first, end,
         only_longer_reach, sample_buffer_, pairs_, pair_count_);
  for (std::uint32_t t = first; t < end; ++t) {
    SampleRecord& sample = samples_[t];
    sample.held_reach = only_longer_reach ? std::max(sample.held_reach, sample.reach) : sample.reach;
  }
  held_ = {first, end};
  return first;
}

void PairStage::post_count(std::vector<SampleRecord> samples) {
  set_samples(std::move(samples));
  const std::uint32_t count = std::uint32_t(samples_.size());
  histograms_.clear(count * kDistanceBins);
  for (std::uint32_t first = 0; first < count; first += samples_at_a_time()) {
    const std::uint32_t end = std::min(count, first + samples_at_a_time());
    const std::uint32_t first_paired = need(first, end);
    launch(library_->session(), count_pairs_, {end - first, library_->match().shapes, kSamplesPerGroup},
           library_->match_buffer(), first, end, first_paired, sample_buffer_, pairs_, pair_count_, histograms_);
  }
  library_->session().flush();
}

std::vector<DistanceHistogram> PairStage::take_count() {
  const std::vector<std::uint32_t> bins = histograms_.read(samples_.size() * kDistanceBins);
  std::vector<DistanceHistogram> histograms(samples_.size());
  for (std::size_t t = 0; t < histograms.size(); ++t) {
    std::copy_n(bins.begin() + std::ptrdiff_t(t * kDistanceBins), kDistanceBins, histograms[t].begin());
  }
  return histograms;
}

}  // namespace tessera::worker
