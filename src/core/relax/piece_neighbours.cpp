#include "core/relax/piece_neighbours.h"

#include <algorithm>
#include <cmath>

#include "core/relax/contacts.h"

namespace tessera {
namespace {

Box box_of_all(const std::vector<Box>& boxes) {
  Box all = boxes.empty() ? Box{} : boxes.front();
  for (const Box& box : boxes) all = united(all, box);
  return all;
}

/// The size of a cell: the mean width of a piece, but at most a few cells for each piece.
float cell_size(const std::vector<Box>& boxes, const Box& all) {
  double sides_px = 0;
  for (const Box& box : boxes) sides_px += std::max(box.width(), box.height());
  const auto count = std::max<std::size_t>(1, boxes.size());
  constexpr float kCellsPerPiece = 4;
  const float least_px = std::sqrt((all.width() + 1) * (all.height() + 1) / (kCellsPerPiece * float(count)));
  return std::max({float(sides_px / double(count)), least_px, 1.f});
}

}  // namespace

PieceNeighbours::PieceNeighbours(const std::vector<Box>& boxes, const Period& period)
    : boxes_(boxes),
      offsets_(period.offsets()),
      all_(box_of_all(boxes)),
      cell_px_(cell_size(boxes, all_)),
      columns_(int(all_.width() / cell_px_) + 1),
      rows_(int(all_.height() / cell_px_) + 1),
      first_(std::size_t(columns_) * rows_ + 1, 0) {
  const auto each_cell = [&](const Box& box, auto f) {
    const Cells cells = cells_of(box);
    for (int y = cells.y0; y <= cells.y1; ++y) {
      for (int x = cells.x0; x <= cells.x1; ++x) f(std::size_t(y) * columns_ + x);
    }
  };
  for (const Box& box : boxes_) each_cell(box, [&](std::size_t cell) { ++first_[cell + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  pieces_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
    each_cell(boxes_[i], [&](std::size_t cell) { pieces_[next[cell]++] = i; });
  }
}

PieceNeighbours::Cells PieceNeighbours::cells_of(const Box& box) const {
  const auto cell = [&](float px, int count) { return int(std::clamp(px / cell_px_, 0.f, float(count - 1))); };
  return {cell(box.low.x - all_.low.x, columns_), cell(box.low.y - all_.low.y, rows_),
          cell(box.high.x - all_.low.x, columns_), cell(box.high.y - all_.low.y, rows_)};
}

std::vector<Neighbour> PieceNeighbours::of(std::uint32_t piece, float reach_px) const {
  std::vector<Neighbour> found;
  std::vector<std::uint32_t> near;
  for (const Vec2 offset : offsets_) {
    // Compares the moved piece with the others' own places, instead of comparing their images with the piece.
    const Vec2 reach{reach_px, reach_px};
    const Box box{boxes_[piece].low - offset - reach, boxes_[piece].high - offset + reach};
    if (!within_reach(box, all_, 0)) continue;
    near.clear();
    const Cells cells = cells_of(box);
    for (int y = cells.y0; y <= cells.y1; ++y) {
      const std::uint32_t* row = first_.data() + std::size_t(y) * columns_;
      for (std::uint32_t i = row[cells.x0]; i < row[cells.x1 + 1]; ++i) {
        if (within_reach(box, boxes_[pieces_[i]], 0)) near.push_back(pieces_[i]);
      }
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const std::uint32_t other : near) {
      if (other != piece || offset != Vec2{}) found.push_back({other, offset});
    }
  }
  return found;
}

}  // namespace tessera
