#include "products/nesting/drawings/dxf_entities.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "products/nesting/drawings/dxf_outlines.h"
#include "products/nesting/drawings/nest_contours.h"

namespace tessera {
namespace {

constexpr unsigned kIsMesh = 16 | 64;    // flags of a POLYLINE
constexpr unsigned kIsSplineFrame = 16;  // flag of a VERTEX: a control point that the line does not touch

bool is_read(std::string_view kind) {
  static constexpr std::array<std::string_view, 8> kRead = {"LINE",   "CIRCLE", "ARC",        "ELLIPSE",
                                                            "SPLINE", "INSERT", "LWPOLYLINE", "POLYLINE"};
  return std::find(kRead.begin(), kRead.end(), kind) != kRead.end();
}

bool is_tilted(const DxfEntity& entity) {
  constexpr double kMostTilt = 1e-6;
  return std::hypot(entity.numbers.get(210), entity.numbers.get(220)) >
         kMostTilt * std::abs(entity.numbers.get(230, 1));
}

/// Why an entity of a known kind cannot be read; empty: it can.
std::string_view why_unread(const DxfEntity& entity) {
  if (entity.kind == "POLYLINE" && entity.numbers.has_bit(70, kIsMesh)) return "POLYLINE that is a mesh";
  if (!is_in_world(entity) && is_tilted(entity)) return "entity in a tilted plane";
  if (entity.kind != "SPLINE") return {};
  if (entity.vertices.empty()) return "SPLINE with fit points only";
  return is_nurbs(nurbs_of(entity, {})) ? "" : "SPLINE whose knots or weights are wrong";
}

/// The least number of points that an entity has when it is drawn.
std::size_t least_points(const DxfEntity& entity) {
  constexpr std::size_t kOfCurve = 8;  // add_arc
  if (entity.kind == "LINE") return 2;
  return entity.kind == "CIRCLE" || entity.kind == "ARC" || entity.kind == "ELLIPSE" ? kOfCurve : 1;
}

}  // namespace

void DxfEntities::begin(const DxfPair& pair, DxfBlock& block, int& in_paper) {
  if (entity_.kind == "POLYLINE" && pair.value == "VERTEX") {
    end_vertex();
    add_vertex();
    in_vertex_ = true;
    return;
  }
  finish(block, in_paper);
  if (pair.value != "SEQEND") entity_.kind = pair.value;
}

void DxfEntities::finish(DxfBlock& block, int& in_paper) {
  end_vertex();
  DxfEntity entity = std::exchange(entity_, {});
  // A VIEWPORT draws nothing. An ATTDEF in a block is a template for the text of each reference.
  if (entity.kind.empty() || entity.kind == "VIEWPORT" || (entity.kind == "ATTDEF" && !block.name.empty())) return;
  if (entity.numbers.get(67) == 1) {
    ++in_paper;
  } else if (!is_read(entity.kind)) {
    block.unread.add(entity.kind);
  } else if (const std::string_view why = why_unread(entity); !why.empty()) {
    block.unread.add(why);
  } else {
    count_points(least_points(entity));
    block.entities.push_back(std::move(entity));
  }
}

void DxfEntities::value(const DxfPair& pair) {
  if (entity_.kind.empty()) return;
  if (!in_vertex_) common_value(pair);
  if (is_polyline(entity_.kind))
    polyline_value(pair);
  else if (entity_.kind == "SPLINE")
    spline_value(pair);
}

void DxfEntities::common_value(const DxfPair& pair) {
  static constexpr std::array<int, 5> kOfAll = {60, 67, 210, 220, 230};
  static constexpr std::array<int, 13> kOfSimple = {10, 20, 11, 21, 40, 41, 42, 44, 45, 50, 51, 70, 71};
  const auto is_one_of = [&](const auto& codes) {
    return std::find(codes.begin(), codes.end(), pair.code) != codes.end();
  };
  if (pair.code == 8) entity_.layer = pair.value;
  if (pair.code == 2 && entity_.kind == "INSERT") entity_.block = pair.value;
  const bool is_simple = is_read(entity_.kind) && !is_polyline(entity_.kind) && entity_.kind != "SPLINE";
  const bool is_used = pair.code == 67 || (is_read(entity_.kind) && is_one_of(kOfAll)) ||
                       (is_simple && is_one_of(kOfSimple)) || (is_read(entity_.kind) && pair.code == 70) ||
                       (entity_.kind == "SPLINE" && pair.code == 71);
  if (is_used) entity_.numbers.set(pair.code, pairs_.number(pair));
}

void DxfEntities::polyline_value(const DxfPair& pair) {
  const bool is_light = entity_.kind == "LWPOLYLINE";
  if (is_light && pair.code == 10) add_vertex();
  if ((!is_light && !in_vertex_) || entity_.vertices.empty()) return;
  DxfVertex& vertex = entity_.vertices.back();
  if (pair.code == 10) vertex.at.x = pairs_.number(pair);
  if (pair.code == 20) vertex.at.y = pairs_.number(pair);
  if (pair.code == 42) vertex.bulge = pairs_.number(pair);
  if (pair.code == 70 && in_vertex_) vertex_flags_ = pairs_.number(pair);
}

void DxfEntities::spline_value(const DxfPair& pair) {
  if (pair.code == 10) add_vertex();
  if (pair.code == 10) entity_.vertices.back().at.x = pairs_.number(pair);
  if (pair.code == 20 && !entity_.vertices.empty()) entity_.vertices.back().at.y = pairs_.number(pair);
  if (pair.code == 40) entity_.knots.push_back(pairs_.number(pair));
  if (pair.code == 41) entity_.weights.push_back(pairs_.number(pair));
  if (std::max(entity_.knots.size(), entity_.weights.size()) > kMostDrawingPoints) fail_dxf_points(path_);
}

void DxfEntities::add_vertex() {
  count_points(1);
  entity_.vertices.push_back({});
}

void DxfEntities::end_vertex() {
  if (in_vertex_ && (unsigned(std::clamp(vertex_flags_, 0.0, 65'535.0)) & kIsSplineFrame) != 0)
    entity_.vertices.pop_back();
  in_vertex_ = false;
  vertex_flags_ = 0;
}

void DxfEntities::count_points(std::size_t points) {
  points_ += points;
  if (points_ > kMostDrawingPoints) fail_dxf_points(path_);
}

}  // namespace tessera
