#include "result/geojson_output.h"

#include <charconv>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>

#include "text/number_text.h"
#include "text/pose.h"

namespace tessera {
namespace {

constexpr int kScoreDecimals = 6;

/// A JSON text. Names and paths may be any bytes of the file system; bytes that are not UTF-8 are replaced.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_position(Vec2 p, std::string& text) {
  text += '[';
  text += fixed(p.x, kPixelDecimals);
  text += ',';
  text += fixed(p.y, kPixelDecimals);
  text += ']';
}

void append_ring(const std::vector<Vec2>& curve, const Similarity& canvas_from_shape, std::string& text) {
  text += '[';
  for (const Vec2 p : curve) {
    append_position(canvas_from_shape.apply(p), text);
    text += ',';
  }
  append_position(canvas_from_shape.apply(curve.front()), text);
  text += ']';
}

void append_geometry(const Outline& outline, const Similarity& canvas_from_shape, std::string& text) {
  text += R"({"type":"Polygon","coordinates":[)";
  bool first = true;
  for (const std::vector<Vec2>& curve : outline.curves) {
    if (curve.empty()) continue;
    if (!std::exchange(first, false)) text += ',';
    append_ring(curve, canvas_from_shape, text);
  }
  text += "]}";
}

/// Appends a property. `value` is JSON already.
void append_property(const char* key, const std::string& value, std::string& text) {
  text += text.ends_with('{') ? "\"" : ",\"";
  text += key;
  text += "\":";
  text += value;
}

/// A JSON list of numbers with as few digits as give the same numbers back.
std::string numbers_text(std::initializer_list<float> numbers) {
  std::string text;
  for (const float number : numbers) {
    char digits[32];
    text += text.empty() ? '[' : ',';
    // adding 0 avoids -0, which would be read back as 0
    text.append(digits, std::to_chars(digits, digits + sizeof digits, number + 0.f).ptr);
  }
  return text + ']';
}

/// The properties of a feature that its placement does not hold.
struct Feature {
  std::size_t index;
  std::string group;
  bool locked;
};

void append_properties(const Placement& placement, const Feature& feature, const Shape& shape, std::string& text) {
  const Similarity& t = placement.canvas_from_shape;
  text += '{';
  append_property("index", std::to_string(feature.index), text);
  append_property("shape", quoted(shape.name), text);
  append_property("source", quoted(shape.artwork.path), text);
  if (!feature.group.empty()) append_property("group", quoted(feature.group), text);
  append_property("scale", fixed(t.scale(), kPixelDecimals), text);
  append_property("rotation_deg", fixed(rotation_deg(t), kPixelDecimals), text);
  append_property("x_px", fixed(t.tx, kPixelDecimals), text);
  append_property("y_px", fixed(t.ty, kPixelDecimals), text);
  append_property("mirrored", shape.artwork.mirrored ? "true" : "false", text);
  if (feature.locked) append_property("locked", "true", text);
  append_property("canvas_from_shape", numbers_text({t.a, t.b, t.tx, t.ty}), text);
  append_property("score", fixed(placement.score, kScoreDecimals), text);
  append_property("matched_px", fixed(placement.matched_px, kPixelDecimals), text);
  text += '}';
}

void append_feature(const Placement& placement, const Feature& feature, const Shape& shape, std::string& text) {
  text += R"({"type":"Feature","properties":)";
  append_properties(placement, feature, shape, text);
  text += R"(,"geometry":)";
  append_geometry(shape.outline, placement.canvas_from_shape, text);
  text += '}';
}

}  // namespace

std::string geojson_text(const CollageReport& report) {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  for (std::size_t i = 0; i < report.placements.size(); ++i) {
    const Placement& placement = report.placements[i];
    text += i ? ",\n" : "\n";
    const Feature feature{i, report.groups.empty() ? "" : report.groups[i], !report.locked.empty() && report.locked[i]};
    append_feature(placement, feature, report.shape(placement.shape), text);
  }
  text += "\n]}\n";
  return text;
}

}  // namespace tessera
