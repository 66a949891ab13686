#include "master/exact_checks.h"

namespace tessera::master {

ExactChecks::Key ExactChecks::key_of(const Candidate& candidate) {
  const Similarity& pose = candidate.canvas_from_shape;
  return {candidate.shape, pose.tx, pose.ty, pose.a, pose.b};
}

ExactAreas ExactChecks::compute(const Candidate& candidate) {
  return exact_areas(shapes_.shape(candidate.shape), candidate.canvas_from_shape, free_, opened_, pieces_);
}

ExactAreas ExactChecks::areas(const Candidate& candidate) {
  const auto known = ahead_.find(key_of(candidate));
  return known == ahead_.end() ? compute(candidate) : known->second.areas;
}

void ExactChecks::compute_ahead(const Candidate& candidate) {
  const Key key = key_of(candidate);
  if (ahead_.contains(key)) return;
  const Window window = exact_window(shapes_.shape(candidate.shape), candidate.canvas_from_shape, free_, pieces_);
  ahead_.emplace(key, Known{window, compute(candidate)});
}

void ExactChecks::forget(const Window& changed) {
  std::erase_if(ahead_, [&](const auto& entry) { return free_.grid().overlap(changed, entry.second.window); });
}

}  // namespace tessera::master
