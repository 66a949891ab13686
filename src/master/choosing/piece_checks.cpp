#include "master/choosing/piece_checks.h"

#include <memory>

#include "core/base/rank_pool.h"
#include "core/settings/tuning.h"

namespace tessera::master {
namespace {

constexpr std::size_t kMostKnown = 4096;  // answers that nobody asks for do not pile up

}  // namespace

PoseRange PieceChecks::poses_of(const Candidate& candidate) const {
  const Stance& stance = context_.stances[candidate.stance];
  return sized_at(context_, stance, candidate.canvas_from_shape.translation()).poses;
}

PieceChecks::Key PieceChecks::key_of(const Candidate& candidate) const {
  const Similarity& pose = candidate.canvas_from_shape;
  const float largest_px = poses_of(candidate).max_scale_px;
  return {candidate.shape, candidate.stance, pose.tx, pose.ty, pose.a, pose.b, largest_px};
}

PieceChecks::Known<ExactAreas> PieceChecks::compute_areas(const Shape& shape,
                                                          const Similarity& canvas_from_shape) const {
  return {exact_areas(shape, canvas_from_shape, free_, opened_, pieces_),
          exact_window(shape, canvas_from_shape, free_, pieces_)};
}

PieceChecks::Known<SettledPiece> PieceChecks::settle(const Shape& shape, const ShapeModel& model,
                                                     const Candidate& candidate) const {
  const SettledPose settled = settling_.settle(shape, model, poses_of(candidate), candidate.canvas_from_shape);
  if (!settled.fits) return {{}, settled.read};
  const Similarity pose = free_.grid().period().wrapped(settled.canvas_from_shape);
  const Known<ExactAreas> areas = compute_areas(shape, pose);
  const Window contour = piece_window(shape.outline, pose, free_.field().origin, context_.gap_px + kWindowMargin_px);
  return {{true, pose, docking_terms(pose, model, free_.view(), context_), areas.answer},
          free_.grid().united(settled.read, areas.read.united(contour))};
}

ExactAreas PieceChecks::areas(const Candidate& candidate) {
  const auto known = areas_.find(key_of(candidate));
  if (known != areas_.end()) return known->second.answer;
  return compute_areas(shapes_.shape(candidate.shape), candidate.canvas_from_shape).answer;
}

SettledPiece PieceChecks::settled(const Candidate& candidate) {
  const auto known = settled_.find(key_of(candidate));
  if (known != settled_.end()) return known->second.answer;
  const ShapeModel& model = shapes_.model(candidate.shape);
  return settle(shapes_.shape(candidate.shape), model, candidate).answer;
}

/// Adds compute(shape, model, candidate) to `known` for each candidate that is not known yet. The shapes may come from a
/// file, and are read one after the other.
template <class Answer, class Compute>
void PieceChecks::compute_ahead(const std::vector<Candidate>& candidates, KnownAnswers<Answer>& known,
                                Compute compute) {
  struct Task {
    const Candidate& candidate;
    std::shared_ptr<const Shape> shape;
    const ShapeModel& model;
    Known<Answer> result{};
  };
  if (known.size() + candidates.size() > kMostKnown) known.clear();
  std::vector<Task> tasks;
  for (const Candidate& candidate : candidates) {
    if (!known.contains(key_of(candidate)))
      tasks.push_back({candidate, shapes_.hold(candidate.shape), shapes_.model(candidate.shape)});
  }
  parallel_for(tasks.size(), [&](std::size_t i) {
    Task& task = tasks[i];
    task.result = compute(*task.shape, task.model, task.candidate);
  });
  for (const Task& task : tasks) known.emplace(key_of(task.candidate), task.result);
}

void PieceChecks::compute_areas_ahead(const std::vector<Candidate>& candidates) {
  compute_ahead(candidates, areas_, [&](const Shape& shape, const ShapeModel&, const Candidate& candidate) {
    return compute_areas(shape, candidate.canvas_from_shape);
  });
}

void PieceChecks::settle_ahead(const std::vector<Candidate>& candidates) {
  compute_ahead(candidates, settled_, [&](const Shape& shape, const ShapeModel& model, const Candidate& candidate) {
    return settle(shape, model, candidate);
  });
}

/// Settling compares outlines, also where no node changed.
void PieceChecks::forget_near(const Shape& shape, const Similarity& canvas_from_shape, const Window& stamped) {
  const Window outline = piece_window(shape.outline, canvas_from_shape, free_.field().origin, 0);
  forget(free_.grid().united(stamped, outline));
}

void PieceChecks::forget(const Window& changed) {
  const auto depends = [&](const auto& known) { return free_.grid().overlap(changed, known.second.read); };
  std::erase_if(areas_, depends);
  std::erase_if(settled_, depends);
}

void PieceChecks::forget_all() {
  areas_.clear();
  settled_.clear();
}

}  // namespace tessera::master
