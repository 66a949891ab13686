#include "artwork/protocol/warp_codec.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "core/base/error.h"

namespace tessera {
namespace {

/// Sent before the displacements and the cells.
struct WarpHeader {
  Vec2 origin;
  float step = 0;
  std::int32_t columns = 0;
  std::int32_t rows = 0;
  std::uint32_t falling = 0;
};

std::size_t nodes_of(const WarpHeader& header) { return std::size_t(header.columns) * std::size_t(header.rows); }
std::size_t cells_of(const WarpHeader& header) {
  return std::size_t(header.columns - 1) * std::size_t(header.rows - 1);
}

void check(bool holds, const std::string& what) {
  if (!holds) throw InputError("a warp: " + what);
}

bool is_sane(Vec2 v) { return std::abs(v.x) <= kMostWarpLength && std::abs(v.y) <= kMostWarpLength; }

void check_header(const WarpHeader& header) {
  const std::int64_t columns = header.columns, rows = header.rows;
  check(columns >= 2 && rows >= 2 && columns <= kMostWarpNodes && rows <= kMostWarpNodes &&
            columns * rows <= kMostWarpNodes,
        "found " + std::to_string(columns) + " x " + std::to_string(rows) + " nodes, allowed: 2 x 2 to " +
            std::to_string(kMostWarpNodes));
  check(header.step > 0 && header.step <= kMostWarpLength && is_sane(header.origin),
        "a step or an origin beyond what is allowed");
  check(header.falling <= 1, "no such diagonal");
}

void check_displacement(const Grid<Vec2>& displacement) {
  check(std::all_of(displacement.data().begin(), displacement.data().end(), is_sane),
        "a displacement beyond what is allowed");
}

}  // namespace

std::vector<std::uint8_t> encode_warp(const Warp& warp) {
  const WarpHeader header{.origin = warp.origin,
                          .step = warp.step,
                          .columns = warp.displacement.width(),
                          .rows = warp.displacement.height(),
                          .falling = warp.falling};
  check_header(header);
  check(warp.active.width() == header.columns - 1 && warp.active.height() == header.rows - 1,
        "its cells do not fit its nodes");
  check_displacement(warp.displacement);
  const std::size_t node_bytes = nodes_of(header) * sizeof(Vec2);
  std::vector<std::uint8_t> bytes(sizeof header + node_bytes + cells_of(header));
  std::memcpy(bytes.data(), &header, sizeof header);
  std::memcpy(bytes.data() + sizeof header, warp.displacement.data().data(), node_bytes);
  std::ranges::copy(warp.active.data(), bytes.begin() + std::ptrdiff_t(sizeof header + node_bytes));
  return bytes;
}

Warp decode_warp(std::span<const std::uint8_t> bytes) {
  WarpHeader header;
  check(bytes.size() >= sizeof header, "it is cut off");
  std::memcpy(&header, bytes.data(), sizeof header);
  check_header(header);
  const std::size_t node_bytes = nodes_of(header) * sizeof(Vec2);
  check(bytes.size() == sizeof header + node_bytes + cells_of(header), "it is cut off, or goes on");
  Warp warp{.origin = header.origin,
            .step = header.step,
            .displacement = {header.columns, header.rows},
            .active = {header.columns - 1, header.rows - 1},
            .falling = header.falling != 0};
  std::memcpy(static_cast<void*>(warp.displacement.data().data()), bytes.data() + sizeof header, node_bytes);
  std::ranges::copy(bytes.subspan(sizeof header + node_bytes), warp.active.data().begin());
  check_displacement(warp.displacement);
  return warp;
}

}  // namespace tessera
