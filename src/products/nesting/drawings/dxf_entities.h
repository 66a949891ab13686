// Builds the entities of a DXF from their pairs.
#pragma once

#include <string>

#include "products/nesting/drawings/dxf_document.h"
#include "products/nesting/drawings/dxf_pairs.h"

namespace tessera {

/// Takes the pairs of one entity after the other, and adds each entity to its block.
class DxfEntities {
 public:
  /// `pairs`, `path`: for messages. Both outlive it.
  DxfEntities(const DxfPairs& pairs, const std::string& path) : pairs_(pairs), path_(path) {}

  /// Takes a pair of code 0 that begins an entity, or continues the POLYLINE before it. The entity before is added to
  /// `block`; `in_paper` counts entities on paper. Throws InputError where there are too many points.
  void begin(const DxfPair& pair, DxfBlock& block, int& in_paper);

  /// Takes a pair of the present entity. Throws InputError where a number that is used is not a number.
  void value(const DxfPair& pair);

  /// Adds the last entity, if any.
  void finish(DxfBlock& block, int& in_paper);

 private:
  void common_value(const DxfPair& pair);
  void polyline_value(const DxfPair& pair);
  void spline_value(const DxfPair& pair);
  void add_vertex();
  void end_vertex();
  void count_points(std::size_t points);

  const DxfPairs& pairs_;
  const std::string& path_;
  DxfEntity entity_;
  bool in_vertex_ = false;
  double vertex_flags_ = 0;
  std::size_t points_ = 0;  // of all entities, or fewer: curves count with their least number
};

}  // namespace tessera
