// What the messages of matching, replacing and the end of a job hold (archive.h). Structures without pointers travel as
// they lie in memory.
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
requires kIsOneOf<T, FieldStart, Heartbeat, ShapeRange, Window, TargetSample, Docking, RefinedDocking, DockingTerms,
                  Vec2, Box, ContactDistances, RepetitionCosts, WindowPiece, IncomingShape, DrawingArea, PlacedDrawing,
                  ReplacedPiece, WorkerTimes>
inline constexpr bool kSentAsItLies<T> = true;

template <class Archive>
void serialize(Archive& archive, Failure& failure) {
  auto& [exit_code, text] = failure;
  archive(exit_code, text);
}

template <class Archive>
void serialize(Archive& archive, FieldPatch& patch) {
  auto& [window, value] = patch;
  archive(window, value);
}

template <class Archive>
void serialize(Archive& archive, StandingLimits& limits) {
  auto& [region, size_factor, most_scale_px, used_up] = limits;
  archive(region, size_factor, most_scale_px, used_up);
}

template <class Archive>
void serialize(Archive& archive, CountRequest& request) {
  auto& [samples, bins, segment_stride] = request;
  archive(samples, bins, segment_stride);
}

template <class Archive>
void serialize(Archive& archive, DockRequest& request) {
  auto& [samples, bin_limit, tangent_dockings, first_drawn] = request;
  archive(samples, bin_limit, tangent_dockings, first_drawn);
}

template <class Archive>
void serialize(Archive& archive, DockReply& reply) {
  auto& [dockings, evaluated] = reply;
  archive(dockings, evaluated);
}

template <class Archive>
void serialize(Archive& archive, CanvasField& field) {
  auto& [value, origin] = field;
  archive(value, origin);
}

template <class Archive>
void serialize(Archive& archive, EdgeField& edge) {
  auto& [distance, node_px] = edge;
  archive(distance, node_px);
}

template <class Archive>
void serialize(Archive& archive, ReplacementWindow& window) {
  auto& [box, edge, distances, least_px, most_px, repetition, moving, still, incoming, drawn, elsewhere, random, trials,
         first_px2, last_px2] = window;
  archive(box, edge, distances, least_px, most_px, repetition, moving, still, incoming, drawn, elsewhere, random,
          trials, first_px2, last_px2);
}

template <class Archive>
void serialize(Archive& archive, ReplacementOutcome& outcome) {
  auto& [pieces, kept] = outcome;
  archive(pieces, kept);
}

template <class Archive>
void serialize(Archive& archive, DeviceDescription& device) {
  auto& [kind, name, platform, driver, shapes] = device;
  archive(kind, name, platform, driver, shapes);
}

template <class Archive>
void serialize(Archive& archive, RankSite& site) {
  auto& [host, devices] = site;
  archive(host, devices);
}

}  // namespace tessera::comm
