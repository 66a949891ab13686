#include "products/nesting/nest_instance.h"

#include <nlohmann/json.hpp>
#include <set>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/too_many.h"
#include "products/nesting/instance_material.h"
#include "products/nesting/instance_values.h"
#include "products/nesting/layout/nesting.h"
#include "text/json_bounds.h"
#include "text/utf8_text.h"

namespace tessera {
namespace {

using nlohmann::json;

constexpr std::size_t kMostAngles = 360;
/// Each of up to kMostDrawingPoints points is a list of two numbers.
constexpr JsonBounds kBounds{.values = 1'000'000, .levels = 32};

NestRing ring_of(const json& points, const std::string& where) {
  if (!points.is_array() || points.size() > kMostContourPoints + 1) {
    throw InputError(where + ": found " +
                     (points.is_array() ? count_text(points.size(), "point") : shown_value(points)) +
                     ", allowed: a list of points, " + std::to_string(kMostContourPoints) + " or fewer");
  }
  NestRing ring;
  for (const json& point : points) {
    if (!point.is_array() || point.size() != 2)
      throw InputError(where + ": found " + shown_value(point) + ", allowed: [x, y]");
    ring.push_back({number_in(point[0], -kFarthest_mm, kFarthest_mm, where),
                    number_in(point[1], -kFarthest_mm, kFarthest_mm, where)});
  }
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  check_contour(ring, where);
  return ring;
}

/// Reads a shape and adds the number of its points to `points`.
NestDrawing drawing_of(const json& shape, const std::string& where, std::size_t& points) {
  const json& type = member(shape, "type", where + ": shape");
  const json& data = member(shape, "data", where + ": shape");
  if (type == "simple_polygon") return {"", ring_of(data, where + ": shape"), {}};
  if (type == "rectangle") {
    const auto [x, y, w, h] = rectangle_of(data, where + ": shape");
    return {"", {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}, {}};
  }
  if (type == "polygon") {
    NestDrawing drawing{"", ring_of(member(data, "outer", where + ": shape"), where + ": shape: outer"), {}};
    if (!data.contains("inner") || data["inner"].is_null()) return drawing;
    if (!data["inner"].is_array())
      throw InputError(where + ": shape: inner: found " + shown_value(data["inner"]) + ", allowed: a list of contours");
    for (const json& hole : data["inner"]) {
      drawing.holes.push_back(ring_of(hole, where + ": shape: inner"));
      points += drawing.holes.back().size();
      if (points > kMostDrawingPoints) break;
    }
    return drawing;
  }
  throw InputError(where + ": shape: type: found " + shown_value(type) +
                   ", allowed: \"simple_polygon\", \"polygon\" or \"rectangle\"");
}

std::vector<double> angles_of(const json& item, const std::string& where) {
  // Without the key any rotation is allowed: the command's angles are used.
  const auto at = item.find("allowed_orientations");
  if (at == item.end() || at->is_null()) return {};
  if (!at->is_array() || at->empty() || at->size() > kMostAngles)
    throw InputError(where + ": allowed_orientations: found " + shown_value(*at) +
                     ", allowed: a list of 1 to 360 angles");
  std::set<double> angles;
  for (const json& angle : *at) angles.insert(number_in(angle, -3600, 3600, where + ": allowed_orientations"));
  return {angles.begin(), angles.end()};
}

std::string name_of(const json& item, std::size_t index) {
  const auto id = item.find("id");
  if (id != item.end() && id->is_string()) return printable_utf8(id->get<std::string>());
  if (id != item.end() && id->is_number_integer()) return id->dump();
  return std::to_string(index);
}

}  // namespace

NestInput nest_instance(std::string_view text, const std::string& path) {
  try {
    check_json(text, kBounds);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
  const json instance = json::parse(text, nullptr, false);
  if (instance.is_discarded()) throw InputError(path + ": not a readable JSON file");
  NestInput input;
  read_material(instance, path, input);
  const json& items = member(instance, "items", path);
  if (!items.is_array() || items.empty() || items.size() > kMostDrawings) {
    throw InputError(path + ": items: found " +
                     (items.is_array() ? count_text(items.size(), "item") : shown_value(items)) +
                     ", allowed: a list of 1 to " + std::to_string(kMostDrawings));
  }
  std::size_t points = 0;
  for (const json& item : items) {
    const std::string where = path + ": item " + std::to_string(input.sources.size());
    if (!item.is_object()) throw InputError(where + ": found " + shown_value(item) + ", allowed: an object");
    check_quality(item, where);
    NestSource& source = input.sources.emplace_back();
    source.drawing = drawing_of(member(item, "shape", where), where, points);
    source.drawing.name = name_of(item, input.sources.size() - 1);
    check_name(source.drawing.name, where + ": id");
    if (item.contains("demand"))
      source.demand = whole_number_in(item["demand"], 0, kMostNestedPieces, where + ": demand");
    source.angles_deg = angles_of(item, where);
    points += source.drawing.outline.size();
    if (points > kMostDrawingPoints) {
      throw InputError(path + ": " + too_many(kMostDrawingPoints, "points in a file"));
    }
  }
  return input;
}

}  // namespace tessera
