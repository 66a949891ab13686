// A shape of a library as sheets of its drawings show it.
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
  bool outlined;  // the outline is drawn over the drawing: where they disagree, the tracing went wrong
};

/// The library's name and how much of it is shown, UTF-8.
std::string sheet_title(const LibraryFile& library, std::size_t shown);

/// With outline and thumbnail. Throws InputError where the library is damaged.
Shape shape_for_sheet(const LibraryFile& library, std::size_t index);

/// The thumbnail in the artwork frame, cut to the cell around it: pages often hold more than the shape. Where it is
/// damaged, the outline alone.
void draw_on_sheet(cairo_t* cairo, Drawers& drawers, const Shape& shape, const SheetCell& cell);

}  // namespace tessera
