#include "library/contact_sheet.h"

#include <algorithm>

#include "artwork/drawers/drawers.h"
#include "files/atomic_file.h"
#include "library/sheet.h"
#include "library/sheet_cell.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr int kCell_px = 140;
constexpr int kName_px = 18;
constexpr int kMaxColumns = 20;

}  // namespace

std::size_t write_contact_sheet(const LibraryFile& library, const std::string& path) {
  const std::size_t shown = std::min(library.size(), kMaxSheetShapes);
  const SheetLayout layout = make_sheet_layout(shown, kCell_px, kCell_px, kName_px, kMaxColumns);
  const Sheet sheet(layout, sheet_title(library, shown));
  Drawers drawers({});
  for (std::size_t k = 0; k < shown; ++k) {
    const Shape shape = shape_for_sheet(library, k * library.size() / shown);
    draw_on_sheet(sheet.cairo(), drawers, shape,
                  {double(layout.x_px(k)), double(layout.y_px(k)), double(kCell_px), true});
    sheet.caption(k, 0, printable_utf8(shape.name));
  }
  write_file_atomically(path, sheet.png(path));
  return shown;
}

}  // namespace tessera
