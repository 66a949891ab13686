#include "products/nesting/layout/nest_scene.h"

#include <algorithm>
#include <utility>

#include "products/nesting/layout/nest_tuning.h"

namespace tessera {

NestScene::NestScene(const PosedItems& shapes, double height, double spacing, NestWatch watch)
    : shapes_(&shapes),
      height_(height),
      spacing_(spacing),
      watch_(std::move(watch)) {}

NestBox NestScene::own_box(int piece) const {
  const NestBox& box = shape(piece).own_box;
  return {box.low + pose(piece).shift, box.high + pose(piece).shift};
}

NestBox NestScene::range(const PosedShape& shape) const {
  const NestBox& box = shape.own_box;
  const double tolerance = nest_tuning::kInset * height_;
  const auto end = [&](double first, double last) { return last < first && first - last <= tolerance ? first : last; };
  return {{-box.low.x, -box.low.y}, {end(-box.low.x, length_ - box.high.x), end(-box.low.y, height_ - box.high.y)}};
}

double NestScene::used_length() const {
  double length = 0;
  for (int i = 0; i < size(); ++i) length = std::max(length, own_box(i).high.x);
  return length;
}

void NestScene::widen(std::size_t pieces) {
  if (pieces <= stride_) return;
  const std::size_t wider = std::max<std::size_t>(16, pieces * 2);
  std::vector<double> overlap(wider * wider, 0), weight(wider * wider, 1);
  for (std::size_t i = 0; i < items_.size(); ++i) {
    std::copy_n(&overlap_[i * stride_], items_.size(), &overlap[i * wider]);
    std::copy_n(&weight_[i * stride_], items_.size(), &weight[i * wider]);
  }
  overlap_ = std::move(overlap);
  weight_ = std::move(weight);
  stride_ = wider;
}

void NestScene::add(int item, const NestPose& pose) {
  widen(items_.size() + 1);
  items_.push_back(item);
  poses_.push_back(pose);
  for (auto* side : {&low_x_, &low_y_, &high_x_, &high_y_}) side->push_back(0);
  const int piece = size() - 1;
  for (int j = 0; j <= piece; ++j) {
    weight_[at(piece, j)] = weight_[at(j, piece)] = 1;
    overlap_[at(piece, j)] = overlap_[at(j, piece)] = 0;
  }
  set_box(piece);
  fill_row(piece);
}

void NestScene::remove_last() {
  items_.pop_back();
  poses_.pop_back();
  for (auto* side : {&low_x_, &low_y_, &high_x_, &high_y_}) side->pop_back();
}

void NestScene::set_box(int piece) {
  const NestBox& box = shape(piece).box;
  const NestPoint shift = pose(piece).shift;
  const std::size_t i = std::size_t(piece);
  low_x_[i] = box.low.x + shift.x;
  low_y_[i] = box.low.y + shift.y;
  high_x_[i] = box.high.x + shift.x;
  high_y_[i] = box.high.y + shift.y;
}

void NestScene::restore(const std::vector<NestPose>& poses) {
  poses_ = poses;
  std::fill(weight_.begin(), weight_.end(), 1.0);
  for (int i = 0; i < size(); ++i) set_box(i);
  for (int i = 0; i < size(); ++i) fill_row(i);
}

void NestScene::move(int piece, const NestPose& pose) {
  poses_[std::size_t(piece)] = pose;
  set_box(piece);
  fill_row(piece);
}

bool NestScene::clamp(int piece, NestPose& pose) const {
  const NestBox here = own_box(piece);
  for (int tried = 0; tried < angles_of(item(piece)); ++tried) {
    const int angle = (pose.angle + tried) % angles_of(item(piece));
    const PosedShape& shape = this->shape(item(piece), angle);
    if (!fits(shape)) continue;
    const NestBox free = range(shape);
    const NestPoint shift = tried == 0 ? pose.shift : here.low - shape.own_box.low;
    pose.angle = angle;
    pose.shift = {std::max(free.low.x, std::min(shift.x, free.high.x)),
                  std::max(free.low.y, std::min(shift.y, free.high.y))};
    return true;
  }
  return false;
}

bool NestScene::clamp_all() {
  std::vector<NestPose> poses = poses_;
  for (int i = 0; i < size(); ++i) {
    if (!clamp(i, poses[std::size_t(i)])) return false;
  }
  restore(poses);
  return true;
}

void NestScene::near(const PosedShape& shape, NestPoint shift, int but) {
  const double low_x = shape.box.low.x + shift.x, high_x = shape.box.high.x + shift.x;
  const double low_y = shape.box.low.y + shift.y, high_y = shape.box.high.y + shift.y;
  near_.resize(items_.size());
  std::size_t count = 0;
  for (std::size_t j = 0; j < items_.size(); ++j) {
    near_[count] = int(j);
    count += std::size_t(low_x_[j] <= high_x) & std::size_t(high_x_[j] >= low_x) & std::size_t(low_y_[j] <= high_y) &
             std::size_t(high_y_[j] >= low_y) & std::size_t(int(j) != but);
  }
  near_.resize(count);
  work_ += 1 + count + items_.size() / 16;
}

double NestScene::cost(int item, int piece, const NestPose& pose, double most) {
  const PosedShape& shape = this->shape(item, pose.angle);
  near(shape, pose.shift, piece);
  double sum = 0;
  for (const int j : near_) {
    bool sure = false;
    const PosedShape& other = this->shape(j);
    const double weight = piece < 0 ? 1 : weight_[at(piece, j)];
    const double overlap = overlap_estimate(shape, pose.shift, other, this->pose(j).shift, sure);
    if (!sure && !shapes_meet(shape, pose.shift, other, this->pose(j).shift)) continue;
    sum += overlap * weight;
    if (sum > most) return sum;
  }
  return sum;
}

void NestScene::fill_row(int piece) {
  const PosedShape& shape = this->shape(piece);
  near(shape, pose(piece).shift, piece);
  for (int j = 0; j < size(); ++j) overlap_[at(piece, j)] = overlap_[at(j, piece)] = 0;
  for (const int j : near_) {
    bool sure = false;
    const PosedShape& other = this->shape(j);
    const double overlap = overlap_estimate(shape, pose(piece).shift, other, pose(j).shift, sure);
    if (!sure && !shapes_meet(shape, pose(piece).shift, other, pose(j).shift)) continue;
    overlap_[at(piece, j)] = overlap_[at(j, piece)] = overlap;
  }
}

double NestScene::overlap_of(int piece) const {
  double sum = 0;
  for (int j = 0; j < size(); ++j) sum += overlap_[at(piece, j)];
  return sum;
}

double NestScene::weighted_overlap_of(int piece) const {
  double sum = 0;
  for (int j = 0; j < size(); ++j) sum += overlap_[at(piece, j)] * weight_[at(piece, j)];
  return sum;
}

double NestScene::overlap() const {
  double sum = 0;
  for (int i = 0; i < size(); ++i) {
    for (int j = 0; j < i; ++j) sum += overlap_[at(i, j)];
  }
  return sum;
}

void NestScene::grow_weights() {
  using namespace nest_tuning;
  double deepest = 0;
  for (int i = 0; i < size(); ++i) {
    for (int j = 0; j < i; ++j) deepest = std::max(deepest, overlap_[at(i, j)]);
  }
  for (int i = 0; i < size(); ++i) {
    for (int j = 0; j < i; ++j) {
      const double overlap = overlap_[at(i, j)];
      double weight = weight_[at(i, j)];
      if (overlap > 0)
        weight *= kLeastGrowth + (kMostGrowth - kLeastGrowth) * (overlap / deepest);
      else
        weight = std::max(1.0, weight * kWeightFading);
      weight_[at(i, j)] = weight_[at(j, i)] = weight;
    }
  }
}

}  // namespace tessera
