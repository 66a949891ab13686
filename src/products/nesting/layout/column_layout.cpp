#include "products/nesting/layout/column_layout.h"

#include <algorithm>

#include "products/nesting/layout/nest_tuning.h"

namespace tessera {

ColumnLayout::ColumnLayout(const NestProblem& problem) : problem_(&problem) {
  for (int item = 0; item < int(problem.items.size()); ++item) boxes_.push_back(boxed(item));
}

ColumnLayout::Boxed ColumnLayout::boxed(int item) const {
  const double tolerance = nest_tuning::kInset * problem_->height;
  const NestItem& of = problem_->items[std::size_t(item)];
  Boxed best;
  for (int angle = 0; angle < int(of.angles_deg.size()); ++angle) {
    const NestBox box = box_of(placed_outline(*problem_, {item, angle, {}, 0}));
    const Boxed here{item, angle, box.low * -1, box.width(), box.height()};
    if (here.width > problem_->length + tolerance || here.height > problem_->height + tolerance) continue;
    const double area = here.width * here.height, least = best.width * best.height;
    if (best.angle < 0 || area < least || (area == least && here.width < best.width)) best = here;
  }
  return best;
}

std::vector<int> ColumnLayout::too_large() const {
  std::vector<int> items;
  for (std::size_t item = 0; item < boxes_.size(); ++item) {
    if (boxes_[item].angle < 0) items.push_back(int(item));
  }
  return items;
}

NestLayout ColumnLayout::all() const {
  NestLayout layout;
  layout.left_over.assign(boxes_.size(), 0);
  std::vector<int> items;
  for (std::size_t item = 0; item < boxes_.size(); ++item)
    items.insert(items.end(), std::size_t(problem_->items[item].demand), int(item));
  add(items, 0, layout);
  return layout;
}

void ColumnLayout::add(std::span<const int> items, double from, NestLayout& layout) const {
  std::vector<Boxed> boxes;
  for (const int item : items) {
    if (boxes_[std::size_t(item)].angle >= 0)
      boxes.push_back(boxes_[std::size_t(item)]);
    else
      ++layout.left_over[std::size_t(item)];
  }
  if (boxes.empty()) return;
  std::stable_sort(boxes.begin(), boxes.end(), [](const Boxed& a, const Boxed& b) { return a.width > b.width; });
  NestPoint at{from, 0};
  double column_end = from;
  layout.used_length = from;
  for (const Boxed& box : boxes) {
    if (at.y > 0 && at.y + box.height > problem_->height) at = {column_end + problem_->spacing, 0};
    if (at.x > 0 && at.x + box.width > problem_->length) {
      ++layout.sheets;
      layout.used_length = 0;
      at = {};
    }
    layout.pieces.push_back({box.item, box.angle, box.corner + at, layout.sheets});
    if (at.y == 0) column_end = at.x + box.width;  // the widest piece of its column
    layout.used_length = std::max(layout.used_length, at.x + box.width);
    at.y += box.height + problem_->spacing;
  }
  ++layout.sheets;
}

}  // namespace tessera
