#include "run/nesting/nest_fit.h"

#include <cmath>
#include <vector>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "products/nesting/layout/column_layout.h"
#include "text/number_text.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

std::string length_text(double mm) {
  constexpr int kDigits = 6;
  return significant(mm, kDigits);
}

std::string size_text(double width_mm, double height_mm) {
  return length_text(width_mm) + " x " + length_text(height_mm) + " mm";
}

std::string material_text(const NestProblem& problem) {
  return std::isfinite(problem.length) ? "sheet of " + size_text(problem.length, problem.height)
                                       : "strip of " + length_text(problem.height) + " mm";
}

/// Names pieces with the sizes in which they are drawn: "disc (16 x 16 mm), ring (20 x 20 mm) and 3 more".
std::string names_of(const std::vector<int>& items, const NestInput& input) {
  constexpr std::size_t kMostNamed = 5, kMostBytesOfName = 60;
  std::string text;
  for (std::size_t i = 0; i < items.size() && i < kMostNamed; ++i) {
    const NestDrawing& drawing = input.sources[std::size_t(items[i])].drawing;
    const NestBox box = box_of(drawing.outline);
    text += (i > 0 ? ", " : "") + cut_utf8(printable_utf8(drawing.name), kMostBytesOfName) + " (" +
            size_text(box.width(), box.height()) + ")";
  }
  return items.size() > kMostNamed ? text + " and " + std::to_string(items.size() - kMostNamed) + " more" : text;
}

}  // namespace

std::string too_large_text(const NestInput& input, const NestProblem& problem, const std::string& path) {
  const std::vector<int> items = ColumnLayout(problem).too_large();
  if (items.empty()) return {};
  if (items.size() == problem.items.size()) {
    throw InputError(path + ": none of its pieces fits onto the " + material_text(problem) +
                     " at the angles allowed: " + names_of(items, input));
  }
  return path + ": " + count_text(items.size(), "shape") + " of " + std::to_string(problem.items.size()) + " " +
         by_count(items.size(), "does", "do") + " not fit onto the " + material_text(problem) +
         " at the angles allowed: " + names_of(items, input);
}

std::string stock_text(const NestBin& sheet, int sheets) {
  if (sheet.stock == 0 || sheets <= sheet.stock) return {};
  return "the layout takes " + count_text(std::size_t(sheets), "sheet") + ", and the instance's stock is " +
         std::to_string(sheet.stock);
}

}  // namespace tessera
