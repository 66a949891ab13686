#include "result/polygon_features.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/count_text.h"
#include "core/base/error.h"
#include "core/base/too_many.h"
#include "job/job_entry.h"
#include "text/number_text.h"

namespace tessera {
namespace {

using nlohmann::json;

constexpr std::size_t kDeepest = 32;  // deepest nesting in the file
constexpr const char* kCoordinates = "geometry.coordinates";
constexpr const char* kGeometryTypes = "\"Polygon\" or \"MultiPolygon\"";

[[noreturn]] void fail(const std::string& key, const std::string& found, const std::string& allowed) {
  throw InputError(key + ": found " + found + ", allowed: " + allowed);
}

std::string found_text(const json& value) {
  return printable(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

/// Reads geometry.coordinates: nested lists of numbers, whose depth says whether they are positions, rings or polygons.
class Coordinates {
 public:
  /// `points_before`: counts the points of all features.
  explicit Coordinates(std::size_t& points_before) : points_before_(points_before) {}

  /// Begins the next feature.
  void begin() {
    depth_ = position_depth_ = axis_ = 0;
    points_ = 0;
    ring_.clear();
    rings_.clear();
    polygons_.clear();
  }

  bool open() const { return depth_ > 0; }

  void begin_list() {
    if (axis_ > 0) fail(kCoordinates, "a list within a position", "numbers");
    ++depth_;
    empty_ = true;
  }

  void end_list() {
    if (empty_) fail(kCoordinates, "an empty list", "polygons of rings of positions [x, y]");
    if (depth_ == position_depth_) end_position();
    if (depth_ + 1 == position_depth_) end_ring();
    if (depth_ + 2 == position_depth_) end_polygon();
    --depth_;
  }

  void add(const json& number) {
    const double found = number.get<double>();
    if (position_depth_ == 0) position_depth_ = depth_;
    if (depth_ != position_depth_) fail(kCoordinates, found_text(number) + " beside lists", "lists of the same depth");
    if (!(found >= kLeastCoordinate && found <= kMostCoordinate)) {
      fail(kCoordinates, found_text(number),
           "px from " + fixed(kLeastCoordinate, 0) + " to " + fixed(kMostCoordinate, 0));
    }
    empty_ = false;
    if (axis_ == 0) position_.x = float(found);
    if (axis_ == 1) position_.y = float(found);
    ++axis_;
  }

  /// The polygons of a feature whose geometry has this type.
  std::vector<std::vector<Ring>> polygons(const std::string& type) {
    const int needed = type == "Polygon" ? 3 : 4;
    if (position_depth_ == 0) fail(kCoordinates, "nothing", "a list of rings");
    if (position_depth_ != needed) {
      fail(kCoordinates, "positions " + count_text(std::size_t(position_depth_), "list") + " deep",
           std::to_string(needed) + " of a " + type);
    }
    return std::move(polygons_);
  }

 private:
  void end_position() {
    if (axis_ < 2) fail(kCoordinates, "a position of one number", "[x, y]");
    axis_ = 0;
    if (++points_ > kMostFeaturePoints) {
      throw InputError(std::string(kCoordinates) + ": " + too_many(kMostFeaturePoints, "positions of a piece"));
    }
    if (++points_before_ > kMostPoints) {
      throw InputError(std::string(kCoordinates) + ": " + too_many(kMostPoints, "positions up to here, of all pieces"));
    }
    ring_.push_back(position_);
  }

  void end_ring() {
    rings_.emplace_back(ring_.begin(), ring_.end());  // with no spare memory, because there may be many rings
    ring_.clear();
  }

  void end_polygon() {
    polygons_.push_back(std::move(rings_));
    rings_.clear();
  }

  int depth_ = 0;           // of the present list
  int position_depth_ = 0;  // 0: no number was read yet
  int axis_ = 0;            // number of axes read of the present position
  bool empty_ = false;      // of the present list
  std::size_t points_ = 0;
  std::size_t& points_before_;
  Vec2 position_;
  Ring ring_;
  std::vector<Ring> rings_;
  std::vector<std::vector<Ring>> polygons_;
};

/// Receives the parser's events. It knows the place in the file and keeps one feature at a time.
class FeatureReader : public json::json_sax_t {
 public:
  explicit FeatureReader(const std::function<void(PolygonFeature)>& take) : take_(take) {}

  /// Throws where the file had no features. To be called at its end.
  void check_complete() const {
    if (!any_features_) fail("features", "nothing", "a list of features, as in pieces.geojson");
  }

  std::string where() const { return at(Place::features) ? "feature " + std::to_string(features_) + ": " : ""; }

  bool null() override { return value(nullptr); }
  bool boolean(bool v) override { return value(v); }
  bool number_integer(number_integer_t v) override { return number(v); }
  bool number_unsigned(number_unsigned_t v) override { return number(v); }
  bool number_float(number_float_t v, const string_t&) override { return number(v); }
  bool string(string_t& v) override { return value(v); }
  bool binary(binary_t&) override { return true; }

  bool key(string_t& name) override {
    key_ = name;
    return true;
  }

  bool start_object(std::size_t) override {
    if (coordinates_.open()) fail(kCoordinates, "an object", "numbers and lists");
    const Place within = place();
    if (within == Place::properties) check_is_no_shape("an object");
    push(within == Place::nowhere                           ? Place::collection
         : within == Place::features                        ? Place::feature
         : within == Place::feature && key_ == "properties" ? Place::properties
         : within == Place::feature && key_ == "geometry"   ? Place::geometry
                                                            : Place::other);
    if (place() == Place::feature) begin_feature();
    if (place() == Place::geometry) begin_geometry();
    return true;
  }

  bool end_object() override {
    if (place() == Place::feature) end_feature();
    places_.pop_back();
    return true;
  }

  bool start_array(std::size_t) override {
    const Place within = place();
    if (within == Place::nowhere) fail("the file", "a list", "a FeatureCollection");
    if (within == Place::features) fail("the feature", "a list", "an object");
    if (within == Place::properties) check_is_no_shape("a list");
    const bool coordinates = within == Place::geometry && key_ == "coordinates";
    if (coordinates) coordinates_.begin();
    if (coordinates || coordinates_.open()) coordinates_.begin_list();
    push(within == Place::collection && key_ == "features" ? Place::features : Place::other);
    any_features_ |= place() == Place::features;
    return true;
  }

  bool end_array() override {
    if (coordinates_.open()) coordinates_.end_list();
    places_.pop_back();
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const json::exception& error) override {
    throw InputError("no JSON: " + printable(error.what(), 200));
  }

 private:
  enum class Place { nowhere, collection, features, feature, properties, geometry, other };

  Place place() const { return places_.empty() ? Place::nowhere : places_.back(); }
  bool at(Place place) const { return std::find(places_.begin(), places_.end(), place) != places_.end(); }

  void push(Place place) {
    if (places_.size() == kDeepest) throw InputError("more than " + std::to_string(kDeepest) + " levels deep");
    places_.push_back(place);
  }

  bool number(const json& v) {
    if (!coordinates_.open()) return value(v);
    coordinates_.add(v);
    return true;
  }

  bool value(const json& v) {
    if (coordinates_.open()) fail(kCoordinates, found_text(v), "numbers and lists");
    switch (place()) {
      case Place::nowhere: fail("the file", found_text(v), "a FeatureCollection");
      case Place::features: fail("the feature", found_text(v), "an object");
      case Place::collection: take_member_of_collection(v); break;
      case Place::properties: take_property(v); break;
      case Place::geometry: take_member_of_geometry(v); break;
      default: break;
    }
    return true;
  }

  void take_member_of_collection(const json& v) const {
    if (key_ == "features") fail("features", found_text(v), "a list of features, as in pieces.geojson");
    if (key_ == "type" && v != "FeatureCollection") fail("type", found_text(v), "\"FeatureCollection\"");
  }

  /// Refuses a member "shape" of properties that is no text.
  void check_is_no_shape(const std::string& found) const {
    if (key_ == "shape") fail("shape", found, "a text, the name of what the piece shows");
  }

  void take_property(const json& v) {
    if (key_ != "shape" || v.is_null()) return;
    if (!v.is_string()) check_is_no_shape(found_text(v));
    feature_.shape = v.get<std::string>();
    if (feature_.shape.size() > kMostShapeNameBytes) {
      fail("shape", "a text of " + count_text(feature_.shape.size(), "byte"),
           std::to_string(kMostShapeNameBytes) + " or fewer");
    }
  }

  void take_member_of_geometry(const json& v) {
    if (key_ == "coordinates") fail(kCoordinates, found_text(v), "a list of rings");
    if (key_ != "type") return;
    if (v != "Polygon" && v != "MultiPolygon") fail("geometry.type", found_text(v), kGeometryTypes);
    geometry_type_ = v.get<std::string>();
  }

  void begin_feature() {
    if (features_ == kMostFeatures) throw InputError("more than " + count_text(kMostFeatures, "feature"));
    feature_ = {};
    begin_geometry();
  }

  void begin_geometry() {
    geometry_type_.clear();
    coordinates_.begin();
  }

  void end_feature() {
    if (geometry_type_.empty()) fail("geometry.type", "nothing", kGeometryTypes);
    feature_.polygons = coordinates_.polygons(geometry_type_);
    take_(std::move(feature_));
    ++features_;
  }

  const std::function<void(PolygonFeature)>& take_;
  std::vector<Place> places_;
  std::string key_;  // the latest key
  bool any_features_ = false;
  std::size_t features_ = 0;
  PolygonFeature feature_;
  std::string geometry_type_;
  std::size_t points_ = 0;
  Coordinates coordinates_{points_};
};

}  // namespace

void read_polygon_features(JsonFile& file, const std::function<void(PolygonFeature)>& take) {
  FeatureReader reader(take);
  try {
    json::sax_parse(file.stream(), &reader);
    reader.check_complete();
  } catch (const InputError& error) {
    throw InputError(reader.where() + error.what());
  }
}

}  // namespace tessera
