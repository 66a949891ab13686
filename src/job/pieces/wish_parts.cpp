#include "job/pieces/wish_parts.h"

namespace tessera {

WishParts::WishParts(std::size_t shapes) : parts_{{.wish = {}, .shapes = shapes}}, part_of_(shapes, 0) {}

void WishParts::add_row(const std::vector<std::uint32_t>& shapes, const std::function<void(ShapeWish&)>& say) {
  std::vector<std::uint32_t> touched;
  for (const std::uint32_t shape : shapes) {
    if (parts_[part_of_[shape]].chosen++ == 0) touched.push_back(part_of_[shape]);
  }
  for (const std::uint32_t part : touched) {
    parts_[part].of_chosen = part;
    if (parts_[part].chosen < parts_[part].shapes) {
      const std::size_t chosen = parts_[part].chosen;
      parts_[part].shapes -= chosen;
      parts_[part].of_chosen = std::uint32_t(parts_.size());
      parts_.push_back({.wish = parts_[part].wish, .shapes = chosen});
    }
    parts_[part].chosen = 0;
    say(parts_[parts_[part].of_chosen].wish);
  }
  for (const std::uint32_t shape : shapes) part_of_[shape] = parts_[part_of_[shape]].of_chosen;
}

}  // namespace tessera
