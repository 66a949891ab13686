// The messages of matching, replacing and the end of a job: how each type is sent (archive.h). Structures without
// pointers are sent as their bytes in memory, all others member by member.
#pragma once

#include "comm/archive.h"
#include "comm/failure.h"
#include "comm/heartbeat.h"
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

template <class T>
requires kIsOneOf<T, FieldStart, ShapeRange, Window, TargetSample, Docking, RefinedDocking, DockingTerms, Vec2, Box,
                  ContactDistances, RepetitionCosts, WindowPiece, IncomingShape, DrawingArea, PlacedDrawing,
                  ReplacedPiece, WorkerTimes>
inline constexpr bool kSentAsBytes<T> = true;

template <class T>
requires kIsOneOf<T, Failure, Heartbeat, FieldPatch, StanceLimits, CountRequest, DockRequest, DockReply, CanvasField,
                  EdgeField, ReplacementWindow, ReplacementOutcome, DeviceDescription, RankSite>
inline constexpr bool kSentByMembers<T> = true;

}  // namespace tessera::comm

namespace boost::serialization {

template <class Archive>
void serialize(Archive& archive, tessera::comm::Failure& failure, unsigned) {
  auto& [exit_code, text] = failure;
  tessera::comm::send_members(archive, exit_code, text);
}

template <class Archive>
void serialize(Archive& archive, tessera::comm::Heartbeat& beat, unsigned) {
  auto& [waiting, for_s] = beat;
  tessera::comm::send_members(archive, waiting, for_s);
}

template <class Archive>
void serialize(Archive& archive, tessera::FieldPatch& patch, unsigned) {
  auto& [window, value] = patch;
  tessera::comm::send_members(archive, window, value);
}

template <class Archive>
void serialize(Archive& archive, tessera::StanceLimits& limits, unsigned) {
  auto& [region, size_factor, most_scale_px, used_up] = limits;
  tessera::comm::send_members(archive, region, size_factor, most_scale_px, used_up);
}

template <class Archive>
void serialize(Archive& archive, tessera::CountRequest& request, unsigned) {
  auto& [samples, bins, segment_stride] = request;
  tessera::comm::send_members(archive, samples, bins, segment_stride);
}

template <class Archive>
void serialize(Archive& archive, tessera::DockRequest& request, unsigned) {
  auto& [samples, bin_limit, tangent_dockings, first_drawn] = request;
  tessera::comm::send_members(archive, samples, bin_limit, tangent_dockings, first_drawn);
}

template <class Archive>
void serialize(Archive& archive, tessera::DockReply& reply, unsigned) {
  auto& [dockings, evaluated] = reply;
  tessera::comm::send_members(archive, dockings, evaluated);
}

template <class Archive>
void serialize(Archive& archive, tessera::CanvasField& field, unsigned) {
  auto& [value, origin] = field;
  tessera::comm::send_members(archive, value, origin);
}

template <class Archive>
void serialize(Archive& archive, tessera::EdgeField& edge, unsigned) {
  auto& [distance, node_px] = edge;
  tessera::comm::send_members(archive, distance, node_px);
}

template <class Archive>
void serialize(Archive& archive, tessera::ReplacementWindow& window, unsigned) {
  auto& [box, edge, distances, least_px, most_px, repetition, moving, still, incoming, drawn, elsewhere, random, trials,
         first_px2, last_px2] = window;
  tessera::comm::send_members(archive, box, edge, distances, least_px, most_px, repetition, moving, still, incoming,
                              drawn, elsewhere, random, trials, first_px2, last_px2);
}

template <class Archive>
void serialize(Archive& archive, tessera::ReplacementOutcome& outcome, unsigned) {
  auto& [pieces, kept] = outcome;
  tessera::comm::send_members(archive, pieces, kept);
}

template <class Archive>
void serialize(Archive& archive, tessera::DeviceDescription& device, unsigned) {
  auto& [kind, name, platform, driver, shapes] = device;
  tessera::comm::send_members(archive, kind, name, platform, driver, shapes);
}

template <class Archive>
void serialize(Archive& archive, tessera::RankSite& site, unsigned) {
  auto& [host, devices] = site;
  tessera::comm::send_members(archive, host, devices);
}

}  // namespace boost::serialization
