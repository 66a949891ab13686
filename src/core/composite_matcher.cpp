#include "core/composite_matcher.h"

#include <stdexcept>

namespace tessera {

CompositeMatcher::CompositeMatcher(std::vector<std::unique_ptr<Matcher>> parts) : parts_(std::move(parts)) {
  if (parts_.empty()) throw std::logic_error("a composite matcher needs at least one part");
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    if (parts_[i]->shapes().begin != parts_[i - 1]->shapes().end) {
      throw std::logic_error("the shape ranges of a composite matcher's parts leave a gap");
    }
  }
}

ShapeRange CompositeMatcher::shapes() const { return {parts_.front()->shapes().begin, parts_.back()->shapes().end}; }

void CompositeMatcher::start_field(int width, int height, Vec2 origin) {
  for (const auto& part : parts_) part->start_field(width, height, origin);
}

void CompositeMatcher::update_field(const FieldPatch& patch) {
  for (const auto& part : parts_) part->update_field(patch);
}

void CompositeMatcher::post_count(const CountRequest& request) {
  for (const auto& part : parts_) part->post_count(request);
}

std::vector<DistanceHistogram> CompositeMatcher::take_count() {
  std::vector<DistanceHistogram> sum = parts_.front()->take_count();
  for (std::size_t p = 1; p < parts_.size(); ++p) {
    const std::vector<DistanceHistogram> more = parts_[p]->take_count();
    for (std::size_t t = 0; t < sum.size(); ++t) {
      for (int bin = 0; bin < kDistanceBins; ++bin) sum[t][bin] += more[t][bin];
    }
  }
  return sum;
}

void CompositeMatcher::post_dock(const DockRequest& request) {
  samples_posted_ = std::uint32_t(request.samples.size());
  for (const auto& part : parts_) part->post_dock(request);
}

DockReply CompositeMatcher::take_dock() {
  std::vector<std::vector<Docking>> of_sample(samples_posted_);
  DockReply merged;
  for (const auto& part : parts_) {
    const DockReply reply = part->take_dock();
    merged.evaluated += reply.evaluated;
    for (const Docking& docking : reply.dockings) of_sample.at(docking.sample).push_back(docking);
  }
  for (std::vector<Docking>& dockings : of_sample) {
    keep_shortlist(dockings);
    merged.dockings.insert(merged.dockings.end(), dockings.begin(), dockings.end());
  }
  return merged;
}

void CompositeMatcher::post_refine(const std::vector<Docking>& dockings) {
  posted_to_.assign(parts_.size(), {});
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const ShapeRange range = parts_[p]->shapes();
    std::vector<Docking> own;
    for (std::size_t i = 0; i < dockings.size(); ++i) {
      if (dockings[i].shape < range.begin || dockings[i].shape >= range.end) continue;
      posted_to_[p].push_back(i);
      own.push_back(dockings[i]);
    }
    parts_[p]->post_refine(own);
  }
}

std::vector<RefinedDocking> CompositeMatcher::take_refine() {
  std::size_t total = 0;
  for (const auto& positions : posted_to_) total += positions.size();
  std::vector<RefinedDocking> merged(total);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const std::vector<RefinedDocking> own = parts_[p]->take_refine();
    for (std::size_t i = 0; i < own.size(); ++i) merged.at(posted_to_[p][i]) = own[i];
  }
  return merged;
}

}  // namespace tessera
