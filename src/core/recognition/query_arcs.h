// Arcs of a query's curves, which are looked up among those of a library (known_arcs.h).
#pragma once

#include <vector>

#include "core/recognition/arc_signature.h"
#include "core/recognition/query.h"

namespace tessera {

struct QueryArc {
  float length = 0;  // query units
  ArcPoints points;
  ArcSignature signature;
};

/// Arcs with the lengths `unit` times powers of `step`, of all of the query's curves that are long enough, without
/// straight arcs. The distance of their starts is a fraction of their length.
std::vector<QueryArc> query_arcs(const Query& query, float unit, float step);

}  // namespace tessera
