#include "run/nesting/nest_problem_arguments.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "products/nesting/layout/nest_check.h"
#include "products/nesting/layout/nesting.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

constexpr double kLeast_mm = 1e-3;
/// The points of all shapes at all of their angles are kept: some 300 MB.
constexpr std::size_t kMostTurnedPoints = 10'000'000;
/// The points of all pieces in a layout; each takes some 80 bytes in its files.
constexpr std::size_t kMostCutPoints = 3'000'000;

void check_length(const std::string& option, double mm, double least) {
  if (mm >= least && mm <= kFarthest_mm) return;
  char text[96];
  std::snprintf(text, sizeof text, ": found %g, allowed: a number from %g to %g mm", mm, least, kFarthest_mm);
  throw InputError(option + text);
}

std::vector<double> angles_of(const NestArguments& arguments, const NestSource& source) {
  static const std::vector<double> kQuarters = {0, 90, 180, 270};
  if (!arguments.angles_deg.empty()) return arguments.angles_deg;
  return source.angles_deg.empty() ? kQuarters : source.angles_deg;
}

/// Refuses a drawing that is too small for the check of a layout to see.
void check_size(const NestArguments& arguments, const NestDrawing& drawing, double height_mm) {
  const NestBox box = box_of(drawing.outline);
  const double size_mm = std::max(box.width(), box.height());
  if (size_mm >= kNestTolerance * height_mm) return;
  char text[96];
  std::snprintf(text, sizeof text, ": found a size of %g mm, allowed: %g or more, a millionth of the height", size_mm,
                kNestTolerance * height_mm);
  throw InputError(printable_utf8(arguments.input) + ": " + drawing.name + text);
}

}  // namespace

void check_arguments(const NestArguments& arguments) {
  constexpr double kMostTurn_deg = 3600;
  if (arguments.strip_mm && !arguments.sheet_mm.empty()) throw InputError("--strip and --sheet: allowed: one of them");
  if (arguments.strip_mm) check_length("--strip", *arguments.strip_mm, kLeast_mm);
  for (const double side : arguments.sheet_mm) check_length("--sheet", side, kLeast_mm);
  check_length("--spacing", arguments.spacing_mm, 0);
  for (const double angle : arguments.angles_deg) {
    if (!(std::abs(angle) <= kMostTurn_deg)) throw InputError("--angles: allowed: numbers from -3600 to 3600 degrees");
  }
  if (arguments.angles_deg.size() > 360) throw InputError("--angles: allowed: 360 of them or fewer");
}

std::vector<std::pair<std::string, int>> demands_of(const std::vector<std::string>& texts) {
  std::vector<std::pair<std::string, int>> demands;
  for (const std::string& text : texts) {
    const std::size_t sign = text.rfind('=');
    const std::string digits = sign == std::string::npos ? "" : text.substr(sign + 1);
    const bool number =
        !digits.empty() && digits.size() <= 4 && digits.find_first_not_of("0123456789") == std::string::npos;
    if (!number || sign == 0 || std::stoi(digits) > kMostNestedPieces) {
      throw InputError("--demand " + printable_utf8(text) + ": allowed: NAME=COUNT, a whole number from 0 to " +
                       std::to_string(kMostNestedPieces));
    }
    demands.emplace_back(text.substr(0, sign), std::stoi(digits));
  }
  return demands;
}

std::optional<NestBin> sheet_of(const NestArguments& arguments, const NestInput& input) {
  if (!arguments.sheet_mm.empty()) return NestBin{arguments.sheet_mm[0], arguments.sheet_mm[1], 0};
  return arguments.strip_mm ? std::nullopt : input.bin;
}

NestProblem problem_of(const NestArguments& arguments, const NestInput& input) {
  NestProblem problem;
  problem.spacing = arguments.spacing_mm;
  if (const std::optional<NestBin> sheet = sheet_of(arguments, input)) {
    problem.length = sheet->width;
    problem.height = sheet->height;
  } else {
    problem.height = arguments.strip_mm.value_or(input.strip_height);
  }
  if (!(problem.height > 0)) {
    throw InputError(printable_utf8(arguments.input) +
                     ": found no size of the material, allowed: --strip H, or --sheet W,H, in mm");
  }
  std::size_t pieces = 0, points = 0;
  for (const NestSource& source : input.sources) {
    check_size(arguments, source.drawing, problem.height);
    problem.items.push_back({source.drawing.outline, angles_of(arguments, source), source.demand});
    pieces += std::size_t(source.demand);
    points += source.drawing.outline.size() * problem.items.back().angles_deg.size();
  }
  if (pieces < 1 || pieces > kMostNestedPieces) {
    throw InputError(printable_utf8(arguments.input) + ": found " + count_text(pieces, "piece") +
                     " in all, allowed: 1 to " + std::to_string(kMostNestedPieces));
  }
  if (points > kMostTurnedPoints) {
    throw InputError(printable_utf8(arguments.input) + ": found " + std::to_string(points) +
                     " points of all shapes at all angles, allowed: " + std::to_string(kMostTurnedPoints) +
                     " (--angles)");
  }
  if (const std::size_t cut = points_to_cut(input); cut > kMostCutPoints) {
    throw InputError(printable_utf8(arguments.input) + ": found " + std::to_string(cut) +
                     " points of all pieces, allowed: " + std::to_string(kMostCutPoints) + " (--demand)");
  }
  return problem;
}

}  // namespace tessera
