// What a DXF holds that is of use here, before anything is drawn: its unit, layers, blocks and entities. Texts point into
// the file's text.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

/// Numbers of an entity by their group codes. Of a code that comes twice the last one counts.
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
  std::string_view block;  // that an INSERT refers to
  DxfNumbers numbers;
  std::vector<DxfVertex> vertices;     // of a polyline; control points of a SPLINE
  std::vector<double> knots, weights;  // of a SPLINE
};

/// How many things of which name. Only the first few names are kept apart, by their first 60 bytes: a hostile file has
/// millions of them, or long ones.
class DxfTally {
 public:
  void add(std::string_view name, int count = 1);
  void add(const DxfTally& other);
  int count() const;
  /// "HATCH, TEXT", fit for people.
  std::string names() const;

 private:
  std::vector<std::pair<std::string_view, int>> counts_;
};

struct DxfBlock {
  std::string_view name;
  NestPoint base;
  bool is_external = false;  // a reference to another file
  std::vector<DxfEntity> entities;
  DxfTally unread;  // entities that no reader knows, by their kinds or why they cannot be read
};

struct DxfLayer {
  bool is_off = false;
  bool is_frozen = false;
};

struct DxfDocument {
  DxfBlock model;                          // what lies in no block
  std::map<std::string, DxfBlock> blocks;  // by dxf_key of their names
  std::map<std::string, DxfLayer> layers;  // by dxf_key of their names; those that are off or frozen
  double mm = 1;                           // of one unit
  bool says_unit = false;                  // $INSUNITS names one
  bool measures_in_inches = false;         // $MEASUREMENT is 0
  int in_paper = 0;                        // entities of layouts on paper, which are not read
};

/// A POLYLINE or LWPOLYLINE.
bool is_polyline(std::string_view kind);
/// Whether the points of such an entity are those of the drawing, not of a plane of its own.
bool is_in_world(const DxfEntity& entity);

/// Names of layers and blocks are the same in capital and small letters; their first kMostNameBytes bytes count.
std::string dxf_key(std::string_view name);

/// Throws InputError: the file has more points than kMostDrawingPoints.
[[noreturn]] void fail_dxf_points(const std::string& path);

}  // namespace tessera
