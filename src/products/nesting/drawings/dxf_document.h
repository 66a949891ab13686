// The useful content of a DXF, before anything is drawn: its unit, layers, blocks and entities. Texts point into the file's
// text.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

/// Numbers of an entity by their group codes. If a code is repeated, the last number counts.
class DxfNumbers {
 public:
  void set(int code, double value) {
    for (auto& [of, number] : numbers_) {
      if (of != code) continue;
      number = value;
      return;
    }
    numbers_.emplace_back(code, value);
  }

  double get(int code, double otherwise = 0) const {
    for (const auto& [of, number] : numbers_) {
      if (of == code) return number;
    }
    return otherwise;
  }

  bool has_bit(int code, unsigned bit) const {
    const double number = get(code);
    return number >= 0 && number < 65'536 && (unsigned(number) & bit) != 0;
  }

 private:
  std::vector<std::pair<int, double>> numbers_;
};

struct DxfVertex {
  NestPoint at;
  double bulge = 0;  // tangent of a quarter of the arc's angle to the next vertex
};

struct DxfEntity {
  std::string_view kind;
  std::string_view layer = "0";
  std::string_view block;  // block that an INSERT refers to
  DxfNumbers numbers;
  std::vector<DxfVertex> vertices;     // of a polyline; control points of a SPLINE
  std::vector<double> knots, weights;  // of a SPLINE
};

/// Counts things by name. Only the first few names are kept apart, by their first 60 bytes, because a hostile file may have
/// millions of names or long ones.
class DxfTally {
 public:
  void add(std::string_view name, int count = 1);
  void add(const DxfTally& other);
  int count() const;
  /// The names for people: "HATCH, TEXT".
  std::string names() const;

 private:
  std::vector<std::pair<std::string_view, int>> counts_;
};

struct DxfBlock {
  std::string_view name;
  NestPoint base;
  bool is_external = false;  // a reference to another file
  std::vector<DxfEntity> entities;
  DxfTally unread;  // entities that cannot be read, by kind or reason
};

struct DxfLayer {
  bool is_off = false;
  bool is_frozen = false;
};

struct DxfDocument {
  DxfBlock model;                          // what lies in no block
  std::map<std::string, DxfBlock> blocks;  // by dxf_key() of their names
  std::map<std::string, DxfLayer> layers;  // by dxf_key() of their names; only those that are off or frozen
  double mm = 1;                           // mm in one unit
  bool says_unit = false;                  // $INSUNITS names a unit
  bool measures_in_inches = false;         // $MEASUREMENT is 0
  int in_paper = 0;                        // entities of layouts on paper, which are not read
};

/// Whether the entity is a POLYLINE or LWPOLYLINE.
bool is_polyline(std::string_view kind);
/// Whether the points of such an entity are those of the drawing, not of its own plane.
bool is_in_world(const DxfEntity& entity);

/// The key of a layer's or block's name: capital and small letters are the same, and its first kMostNameBytes bytes count.
std::string dxf_key(std::string_view name);

/// Throws InputError, because the file has more points than kMostDrawingPoints.
[[noreturn]] void fail_dxf_points(const std::string& path);

}  // namespace tessera
