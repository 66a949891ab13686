// A sheet of pictures with captions below them and a title above: what contact sheets have in common.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artwork/images/cairo_objects.h"

namespace tessera {

/// Where the cells of a sheet lie: rows of equal pictures, a little wider than high as a whole.
struct SheetLayout {
  int cell_width_px;
  int cell_height_px;  // of the picture; the caption stands below it
  int caption_px;      // height of all its lines
  int columns;
  int rows;

  int width_px() const;
  int height_px() const;
  int x_px(std::size_t cell) const;
  int y_px(std::size_t cell) const;
};

/// `pictures` >= 1 in `max_columns` columns or fewer.
SheetLayout make_sheet_layout(std::size_t pictures, int cell_width_px, int cell_height_px, int caption_px,
                              int max_columns);

class Sheet {
 public:
  /// `title`: UTF-8.
  Sheet(const SheetLayout& layout, const std::string& title);

  cairo_t* cairo() const { return cairo_.get(); }
  const SheetLayout& layout() const { return layout_; }

  /// One line of text in the middle below the cell's picture, cut to its width. Lines count from 0.
  void caption(std::size_t cell, int line, const std::string& text) const;
  /// Throws EnvironmentError where cairo cannot; `path` only names it.
  std::vector<std::uint8_t> png(const std::string& path) const;

 private:
  SheetLayout layout_;
  CairoSurface surface_;
  CairoContext cairo_;  // refers to the surface, so it goes first
};

}  // namespace tessera
