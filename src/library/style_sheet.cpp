#include "library/style_sheet.h"

#include <algorithm>

#include "artwork/drawers/drawers.h"
#include "files/atomic_file.h"
#include "library/sheet.h"
#include "library/sheet_cell.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr int kStyleCell_px = 108;
constexpr int kCaption_px = 34;  // the name, and for the first of a group a line about the group
constexpr std::size_t kColumns = 16;
constexpr std::size_t kMostRows = 2;  // of one group

struct Cell {
  std::size_t place;  // its place on the sheet
  std::uint32_t shape;
  std::string group;  // only for the first of a group
};

std::vector<Cell> cells_of(const std::vector<StyleGroup>& groups) {
  std::vector<Cell> cells;
  std::size_t row = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::vector<std::uint32_t>& members = groups[g].members;
    const std::size_t shown = std::min(members.size(), kColumns * kMostRows);
    for (std::size_t k = 0; k < shown; ++k)
      cells.push_back({row * kColumns + k, members[k * members.size() / shown], {}});
    cells[cells.size() - shown].group = "group " + std::to_string(g + 1) + ": " + std::to_string(members.size());
    row += (shown + kColumns - 1) / kColumns;
  }
  return cells;
}

}  // namespace

std::size_t write_style_sheet(const LibraryFile& library, const std::vector<StyleGroup>& groups,
                              const std::string& path) {
  const std::vector<Cell> cells = cells_of(groups);
  const std::size_t rows = cells.back().place / kColumns + 1;
  const SheetLayout layout =
      make_sheet_layout(rows * kColumns, kStyleCell_px, kStyleCell_px, kCaption_px, int(kColumns));
  const Sheet sheet(layout, sheet_title(library, cells.size()) + "  ·  by style");
  Drawers drawers({});
  for (const Cell& cell : cells) {
    const Shape shape = shape_for_sheet(library, cell.shape);
    draw_on_sheet(sheet.cairo(), drawers, shape,
                  {double(layout.x_px(cell.place)), double(layout.y_px(cell.place)), double(kStyleCell_px), false});
    sheet.caption(cell.place, 0, printable_utf8(shape.name));
    if (!cell.group.empty()) sheet.caption(cell.place, 1, cell.group);
  }
  write_file_atomically(path, sheet.png(path));
  return cells.size();
}

}  // namespace tessera
