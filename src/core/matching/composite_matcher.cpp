#include "core/matching/composite_matcher.h"

#include <algorithm>
#include <chrono>
#include <span>
#include <stdexcept>
#include <thread>

namespace tessera {
namespace {

/// Merges `more` into `list`; both are sorted, best first. With many parts most have no docking good enough for the
/// list: the first comparison tells.
void join_shortlist(std::vector<Docking>& list, std::span<const Docking> more) {
  if (list.size() == kShortlist && !docks_better(more.front(), list.back())) return;
  const auto middle = std::ptrdiff_t(list.size());
  list.insert(list.end(), more.begin(), more.end());
  std::inplace_merge(list.begin(), list.begin() + middle, list.end(), docks_better);
  if (list.size() > kShortlist) list.resize(kShortlist);
}

std::vector<MatcherPart*> pointers_to(const std::vector<std::unique_ptr<Matcher>>& parts) {
  std::vector<MatcherPart*> pointers;
  for (const auto& part : parts) pointers.push_back(part.get());
  return pointers;
}

}  // namespace

JoinedMatcher::JoinedMatcher(std::vector<MatcherPart*> parts) : parts_(std::move(parts)) {
  if (parts_.empty()) throw std::logic_error("a joined matcher needs at least one part");
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    if (parts_[i]->shapes().begin != parts_[i - 1]->shapes().end) {
      throw std::logic_error("the shape ranges of a joined matcher's parts leave a gap");
    }
  }
  expect_steps();
}

ShapeRange JoinedMatcher::shapes() const { return {parts_.front()->shapes().begin, parts_.back()->shapes().end}; }

void JoinedMatcher::post_count(const CountRequest& request) {
  post_count_to_all(request);
  expect_steps();
}

bool JoinedMatcher::take_ready_steps() {
  bool any_ready = false;
  std::erase_if(counting_, [&](MatcherPart* part) {
    if (!part->step_is_ready()) return false;
    any_ready = true;
    return !part->step_count();
  });
  return any_ready;
}

/// Devices of different speeds and with different parts of the library need different numbers of steps. So no device is
/// idle because another takes longer for its step.
bool JoinedMatcher::step_count() {
  constexpr std::chrono::microseconds kLook{50};
  if (counting_.size() == 1) {
    if (!counting_.front()->step_count()) counting_.clear();
  } else {
    while (!counting_.empty() && !take_ready_steps()) std::this_thread::sleep_for(kLook);
  }
  return !counting_.empty();
}

bool JoinedMatcher::step_is_ready() {
  return counting_.empty() ||
         std::any_of(counting_.begin(), counting_.end(), [](MatcherPart* part) { return part->step_is_ready(); });
}

/// Takes all steps of the devices first. A part that waits for other ranks, which step by themselves, would otherwise
/// delay the devices.
std::vector<DistanceHistogram> JoinedMatcher::take_count() {
  while (step_count()) {
  }
  std::vector<DistanceHistogram> sum = parts_.front()->take_count();
  for (std::size_t p = 1; p < parts_.size(); ++p) {
    const std::vector<DistanceHistogram> more = parts_[p]->take_count();
    if (more.size() != sum.size()) throw std::logic_error("parts of a library counted different samples");
    for (std::size_t t = 0; t < sum.size(); ++t) {
      for (int bin = 0; bin < kDistanceBins; ++bin) sum[t][bin] += more[t][bin];
    }
  }
  return sum;
}

void JoinedMatcher::post_dock(const DockRequest& request) {
  samples_posted_ = std::uint32_t(request.samples.size());
  post_dock_to_all(request);
}

DockReply JoinedMatcher::take_dock() {
  std::vector<std::vector<Docking>> of_sample(samples_posted_);
  DockReply joined;
  for (MatcherPart* const part : parts_) {
    const DockReply reply = part->take_dock();
    joined.evaluated += reply.evaluated;
    for (auto first = reply.dockings.begin(); first != reply.dockings.end();) {
      const auto other_sample = [&](const Docking& d) { return d.sample != first->sample; };
      const auto last = std::find_if(first, reply.dockings.end(), other_sample);
      join_shortlist(of_sample.at(first->sample), std::span(first, last));
      first = last;
    }
  }
  for (const std::vector<Docking>& dockings : of_sample) {
    joined.dockings.insert(joined.dockings.end(), dockings.begin(), dockings.end());
  }
  return joined;
}

/// Sends each part the dockings of its own shapes.
void JoinedMatcher::post_divided(const std::vector<Docking>& dockings, PostTo post) {
  posted_to_.assign(parts_.size(), {});
  for (const Docking& d : dockings) {
    if (!shapes().contains(d.shape)) throw std::out_of_range("a docking of a shape of no part");
  }
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const ShapeRange range = parts_[p]->shapes();
    std::vector<Docking> own;
    for (std::size_t i = 0; i < dockings.size(); ++i) {
      if (!range.contains(dockings[i].shape)) continue;
      posted_to_[p].push_back(i);
      own.push_back(dockings[i]);
    }
    (*parts_[p].*post)(own);
  }
}

template <class Answer>
std::vector<Answer> JoinedMatcher::take_divided(TakeFrom<Answer> take) {
  std::size_t total = 0;
  for (const auto& positions : posted_to_) total += positions.size();
  std::vector<Answer> joined(total);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const std::vector<Answer> own = (*parts_[p].*take)();
    for (std::size_t i = 0; i < own.size(); ++i) joined.at(posted_to_[p][i]) = own[i];
  }
  return joined;
}

void JoinedMatcher::post_refine(const std::vector<Docking>& dockings) {
  post_divided(dockings, &MatcherPart::post_refine);
}

std::vector<RefinedDocking> JoinedMatcher::take_refine() { return take_divided(&MatcherPart::take_refine); }

void JoinedMatcher::post_measure(const std::vector<Docking>& dockings) {
  post_divided(dockings, &MatcherPart::post_measure);
}

std::vector<DockingTerms> JoinedMatcher::take_measure() { return take_divided(&MatcherPart::take_measure); }

CompositeMatcher::CompositeMatcher(std::vector<std::unique_ptr<Matcher>> parts)
    : JoinedMatcher(pointers_to(parts)),
      parts_(std::move(parts)) {}

void CompositeMatcher::start_field(int width, int height, Vec2 origin) {
  for (const auto& part : parts_) part->start_field(width, height, origin);
}

void CompositeMatcher::update_field(const std::vector<FieldPatch>& patches) {
  for (const auto& part : parts_) part->update_field(patches);
}

void CompositeMatcher::limit(const StanceLimits& limits) {
  for (const auto& part : parts_) part->limit(limits);
}

void CompositeMatcher::post_count_to_all(const CountRequest& request) {
  for (const auto& part : parts_) part->post_count(request);
}

void CompositeMatcher::post_dock_to_all(const DockRequest& request) {
  for (const auto& part : parts_) part->post_dock(request);
}

}  // namespace tessera
