// A sheet of pictures with captions below them and a title above; contact sheets use it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "artwork/images/cairo_objects.h"

namespace tessera {

/// The places of the cells of a sheet: rows of equal pictures. The whole is a little wider than high.
struct SheetLayout {
  int cell_width_px;
  int cell_height_px;  // of the picture; the caption is below it
  int caption_px;      // height of all its lines
  int columns;
  int rows;

  int width_px() const;
  int height_px() const;
  int x_px(std::size_t cell) const;
  int y_px(std::size_t cell) const;
};

/// A layout for `pictures` >= 1 in at most `max_columns` columns.
SheetLayout make_sheet_layout(std::size_t pictures, int cell_width_px, int cell_height_px, int caption_px,
                              int max_columns);

class Sheet {
 public:
  /// `title`: UTF-8.
  Sheet(const SheetLayout& layout, const std::string& title);

  cairo_t* cairo() const { return cairo_.get(); }
  const SheetLayout& layout() const { return layout_; }

  /// Writes one line of text, centred below the cell's picture and cut to its width. Lines count from 0.
  void caption(std::size_t cell, int line, const std::string& text) const;
  /// The sheet as a PNG. Throws EnvironmentError where cairo fails; `path` is only for the message.
  std::vector<std::uint8_t> png(const std::string& path) const;

 private:
  SheetLayout layout_;
  CairoSurface surface_;
  CairoContext cairo_;  // refers to the surface, so it is destroyed first
};

}  // namespace tessera
