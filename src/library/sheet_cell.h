// Draws a shape of a library into a cell of a sheet.
#pragma once

#include <string>

#include "artwork/drawers/drawers.h"
#include "artwork/images/cairo_objects.h"
#include "library/storage/library_file.h"

namespace tessera {

/// A square on the sheet.
struct SheetCell {
  double x_px;
  double y_px;
  double side_px;
  bool outlined;  // draws the outline over the drawing: where they differ, tracing went wrong
};

/// The library's name and how many of its shapes are shown, UTF-8.
std::string sheet_title(const LibraryFile& library, std::size_t shown);

/// Reads a shape with outline and thumbnail. Throws InputError where the library is damaged.
Shape shape_for_sheet(const LibraryFile& library, std::size_t index);

/// Draws the thumbnail, placed by the artwork frame and cut to the cell, because pages often hold more than the shape.
/// A shape with a damaged thumbnail gets only its outline.
void draw_on_sheet(cairo_t* cairo, Drawers& drawers, const Shape& shape, const SheetCell& cell);

}  // namespace tessera
