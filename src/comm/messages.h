// What the messages of matching and replacing hold, for Boost.Serialization. Structures without pointers travel as they
// lie in memory, and vectors of them in one copy.
#pragma once

#include <boost/serialization/is_bitwise_serializable.hpp>
#include <boost/serialization/level.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/tracking.hpp>
#include <boost/serialization/vector.hpp>
#include <type_traits>

#include "comm/failure.h"
#include "core/matching/matcher.h"
#include "core/ranks/rank_site.h"
#include "core/ranks/rank_statistics.h"
#include "core/replacing/replacement.h"

namespace tessera::comm {

struct FieldStart {
  int width = 0;  // nodes
  int height = 0;
  Vec2 origin;  // canvas px of node (0, 0)

  friend bool operator==(const FieldStart&, const FieldStart&) = default;
};

}  // namespace tessera::comm

#define TESSERA_SENT_AS_IT_LIES(Type)                \
  static_assert(std::is_trivially_copyable_v<Type>); \
  BOOST_IS_BITWISE_SERIALIZABLE(Type)                \
  BOOST_CLASS_IMPLEMENTATION(Type, boost::serialization::primitive_type)

TESSERA_SENT_AS_IT_LIES(tessera::comm::FieldStart)
TESSERA_SENT_AS_IT_LIES(tessera::ShapeId)
TESSERA_SENT_AS_IT_LIES(tessera::ShapeRange)
TESSERA_SENT_AS_IT_LIES(tessera::Window)
TESSERA_SENT_AS_IT_LIES(tessera::TargetSample)
TESSERA_SENT_AS_IT_LIES(tessera::DistanceHistogram)
TESSERA_SENT_AS_IT_LIES(tessera::Docking)
TESSERA_SENT_AS_IT_LIES(tessera::RefinedDocking)
TESSERA_SENT_AS_IT_LIES(tessera::DockingTerms)
TESSERA_SENT_AS_IT_LIES(tessera::Vec2)
TESSERA_SENT_AS_IT_LIES(tessera::Box)
TESSERA_SENT_AS_IT_LIES(tessera::ContactDistances)
TESSERA_SENT_AS_IT_LIES(tessera::WindowPiece)
TESSERA_SENT_AS_IT_LIES(tessera::IncomingShape)
TESSERA_SENT_AS_IT_LIES(tessera::ReplacedPiece)
TESSERA_SENT_AS_IT_LIES(tessera::WorkerTimes)

#undef TESSERA_SENT_AS_IT_LIES

#define TESSERA_SENT_BY_MEMBERS(Type)                                         \
  BOOST_CLASS_IMPLEMENTATION(Type, boost::serialization::object_serializable) \
  BOOST_CLASS_TRACKING(Type, boost::serialization::track_never)

TESSERA_SENT_BY_MEMBERS(tessera::comm::Failure)
TESSERA_SENT_BY_MEMBERS(tessera::FieldPatch)
TESSERA_SENT_BY_MEMBERS(tessera::StandingLimits)
TESSERA_SENT_BY_MEMBERS(tessera::CountRequest)
TESSERA_SENT_BY_MEMBERS(tessera::DockRequest)
TESSERA_SENT_BY_MEMBERS(tessera::DockReply)
TESSERA_SENT_BY_MEMBERS(tessera::Grid<float>)
TESSERA_SENT_BY_MEMBERS(tessera::CanvasField)
TESSERA_SENT_BY_MEMBERS(tessera::EdgeField)
TESSERA_SENT_BY_MEMBERS(tessera::DrawingArea)
TESSERA_SENT_BY_MEMBERS(tessera::ReplacementWindow)
TESSERA_SENT_BY_MEMBERS(tessera::ReplacementOutcome)
TESSERA_SENT_BY_MEMBERS(tessera::DeviceDescription)
TESSERA_SENT_BY_MEMBERS(tessera::RankSite)

#undef TESSERA_SENT_BY_MEMBERS

namespace boost::serialization {

template <class Archive>
void serialize(Archive& archive, tessera::comm::Failure& failure, unsigned) {
  archive& failure.exit_code& failure.text;
}

template <class Archive>
void serialize(Archive& archive, tessera::FieldPatch& patch, unsigned) {
  archive& patch.window& patch.value;
}

template <class Archive>
void serialize(Archive& archive, tessera::StandingLimits& limits, unsigned) {
  archive& limits.region& limits.size_factor& limits.most_scale_px& limits.used_up;
}

template <class Archive>
void serialize(Archive& archive, tessera::CountRequest& request, unsigned) {
  archive& request.samples& request.bins& request.segment_stride;
}

template <class Archive>
void serialize(Archive& archive, tessera::DockRequest& request, unsigned) {
  archive& request.samples& request.bin_limit& request.tangent_dockings& request.first_drawn;
}

template <class Archive>
void serialize(Archive& archive, tessera::DockReply& reply, unsigned) {
  archive& reply.dockings& reply.evaluated;
}

template <class Archive>
void serialize(Archive& archive, tessera::Grid<float>& grid, unsigned) {
  int width = grid.width();
  int height = grid.height();
  archive& width& height;
  if constexpr (Archive::is_loading::value) grid = {width, height};
  archive& grid.data();
}

template <class Archive>
void serialize(Archive& archive, tessera::CanvasField& field, unsigned) {
  archive& field.value& field.origin;
}

template <class Archive>
void serialize(Archive& archive, tessera::EdgeField& edge, unsigned) {
  archive& edge.distance& edge.node_px;
}

template <class Archive>
void serialize(Archive& archive, tessera::DrawingArea& drawn, unsigned) {
  archive& drawn.drawing& drawn.area_px2;
}

template <class Archive>
void serialize(Archive& archive, tessera::RepetitionCosts& costs, unsigned) {
  archive& costs.area& costs.even_share_px2& costs.nearness& costs.reach_sizes;
}

template <class Archive>
void serialize(Archive& archive, tessera::PlacedDrawing& piece, unsigned) {
  archive& piece.drawing& piece.centre_px& piece.scale_px;
}

template <class Archive>
void serialize(Archive& archive, tessera::ReplacementWindow& window, unsigned) {
  // By all its members: one that is left out here would differ from rank to rank, so then this does not compile.
  auto& [box, edge, distances, least_px, most_px, repetition, moving, still, incoming, drawn, elsewhere, random, trials,
         first_px2, last_px2] = window;
  archive& box& edge& distances& least_px& most_px& repetition& moving& still& incoming& drawn& elsewhere;
  archive& random& trials& first_px2& last_px2;
}

template <class Archive>
void serialize(Archive& archive, tessera::ReplacementOutcome& outcome, unsigned) {
  archive& outcome.pieces& outcome.kept;
}

template <class Archive>
void serialize(Archive& archive, tessera::DeviceDescription& device, unsigned) {
  archive& device.kind& device.name& device.platform& device.driver& device.shapes;
}

template <class Archive>
void serialize(Archive& archive, tessera::RankSite& site, unsigned) {
  archive& site.host& site.devices;
}

}  // namespace boost::serialization
