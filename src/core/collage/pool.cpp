#include "core/collage/pool.h"

#include <algorithm>

#include "core/settings/tuning.h"

namespace tessera {

bool ranks_before(const Candidate& a, const Candidate& b) {
  if (a.score != b.score) return a.score > b.score;
  if (a.shape != b.shape) return a.shape < b.shape;
  return a.source < b.source;
}

void Pool::put(SampleId sample, std::vector<Candidate> candidates, bool truncated) {
  std::sort(candidates.begin(), candidates.end(), ranks_before);
  if (candidates.size() > kPoolPerSample) {
    candidates.resize(kPoolPerSample);
    truncated = true;
  }
  put_back(sample, std::move(candidates), truncated);
}

void Pool::put_back(SampleId sample, std::vector<Candidate> candidates, bool truncated) {
  erase(sample);
  Entry& entry = entries_[sample];
  entry.candidates = std::move(candidates);
  entry.truncated = truncated;
  for (Candidate& c : entry.candidates) {
    c.ordinal = std::uint32_t(&c - entry.candidates.data());
    rank(sample, c);
    entry.reach = entry.reach.united(c.window);
  }
  index_.insert(TileIndex::tile_at(entry.reach.x0, entry.reach.y0), edge_number(sample));
  widest_ = std::max(widest_, entry.reach.width());
  highest_ = std::max(highest_, entry.reach.height());
}

void Pool::erase(SampleId sample) {
  const auto found = entries_.find(sample);
  if (found == entries_.end()) return;
  index_.erase(TileIndex::tile_at(found->second.reach.x0, found->second.reach.y0), edge_number(sample));
  entries_.erase(found);
}

void Pool::erase(const Ranked& ranked) {
  std::vector<Candidate>& candidates = entries_.at(ranked.sample).candidates;
  candidates.erase(candidates.begin() + (find(ranked) - candidates.data()));
}

std::vector<SampleId> Pool::reached_by(const Window& changed) const {
  std::vector<SampleId> samples;
  const Window corners{changed.x0 - widest_, changed.y0 - highest_, changed.x1, changed.y1};
  index_.each(corners, [&](std::uint32_t thing) {
    const SampleId sample{thing};
    if (entries_.at(sample).reach.overlaps(changed)) samples.push_back(sample);
  });
  return samples;
}

void Pool::rank_again(Ranked& ranked) {
  Candidate& candidate = at(ranked);
  rank(ranked.sample, candidate);
  ranked.stamp = candidate.stamp;
}

/// Leaves an outdated entry in the queue.
void Pool::set_aside(Ranked& ranked) {
  Candidate& candidate = at(ranked);
  candidate.stamp = ranked.stamp = ++last_stamp_;
  ranked.value = candidate.score;
  aside_.push_back(ranked);
}

void Pool::bring_back() {
  for (std::vector<Ranked>* waiting : {&aside_, &put_off_}) {
    for (const Ranked& ranked : *waiting) push(queue_, ranked);
    waiting->clear();
  }
}

/// Looks from the candidate's first place on downwards: it only moves down, where others are dropped.
Candidate* Pool::find(const Ranked& ranked) {
  const auto entry = entries_.find(ranked.sample);
  if (entry == entries_.end()) return nullptr;
  std::vector<Candidate>& candidates = entry->second.candidates;
  for (std::size_t i = std::min<std::size_t>(candidates.size(), ranked.ordinal + 1); i-- > 0;) {
    if (candidates[i].stamp == ranked.stamp) return &candidates[i];
  }
  return nullptr;
}

void Pool::rank(SampleId sample, Candidate& candidate) {
  candidate.stamp = ++last_stamp_;
  push(queue_, {candidate.score, sample, candidate.ordinal, candidate.stamp});
}

void Pool::push(std::vector<Ranked>& heap, const Ranked& ranked) {
  heap.push_back(ranked);
  std::push_heap(heap.begin(), heap.end(), ranks_after);
}

Pool::Ranked Pool::pop(std::vector<Ranked>& heap) {
  std::pop_heap(heap.begin(), heap.end(), ranks_after);
  const Ranked first = heap.back();
  heap.pop_back();
  return first;
}

/// Removes outdated entries once the queue has doubled: then they may be most of it.
void Pool::sweep() {
  if (queue_.size() < 2 * swept_ + 1024) return;
  std::erase_if(queue_, [&](const Ranked& ranked) { return find(ranked) == nullptr; });
  std::make_heap(queue_.begin(), queue_.end(), ranks_after);
  swept_ = queue_.size();
}

}  // namespace tessera
