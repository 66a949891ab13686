// The boundary of the free region as linked vertices, and its target samples (paper section 4: "cut and paste").
//
// A vertex is known by the grid edge that the contour crosses. Whatever a placement did not touch keeps its vertices,
// samples and PADs; only what is new, or whose PAD reaches into the change, is computed again. Everything about a
// sample follows from a walk along its own neighbourhood, so updating gives the bits that starting afresh would give.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "core/field/edge_table.h"
#include "core/field/free_field.h"
#include "core/geometry/tile_index.h"
#include "core/pad/pad.h"
#include "core/settings.h"

namespace tessera {

/// A point of the target curve where shapes are docked. Canvas px; the free region lies on the left.
struct TargetSample {
  std::uint32_t edge = 0;  // its name: 2 (y · width + x), +1 for the edge from (x, y) down to (x, y + 1)
  std::uint32_t pass = 0;  // how often it was matched before: other random draws each time
  Vec2 position;           // on the curve itself
  Vec2 tangent;            // unit
  ArclengthPyramid pyramid;  // of the curve smoothed by target_sigma_px
};

/// Of a sample's PAD when it was last to be matched: what decides whether it has changed much since.
struct MatchedPad {
  std::uint32_t edge = 0;
  std::array<float, kMaxPadLevels> left{};
  std::array<float, kMaxPadLevels> right{};
  float convexity = 0;

  friend bool operator==(const MatchedPad&, const MatchedPad&) = default;
};

class TargetCurve {
 public:
  TargetCurve(const PieceSettings& pieces, const PadParameters& pad);

  struct Change {
    std::vector<std::uint32_t> removed;  // samples that are gone, ascending
    std::vector<std::uint32_t> renewed;  // samples that are new or whose PAD changed much, ascending
  };

  /// Traces the nodes of `window` again (all others are as before). `origin` is the canvas position of node (0, 0).
  Change retrace(const OpenedField& opened, Vec2 origin, const Window& window);

  const TargetSample& sample(std::uint32_t edge) const { return samples_.at(edge).sample; }
  std::size_t sample_count() const { return samples_.size(); }
  bool has_sample(std::uint32_t edge) const { return samples_.contains(edge); }
  std::vector<std::uint32_t> sample_edges() const;

  /// Of the samples whose PAD has changed a little since it was matched, ascending: the only part of a curve that does
  /// not follow from the opened field.
  std::vector<MatchedPad> matched_pads() const;
  /// All other samples count as matched with the PAD that they have.
  void set_matched_pads(const std::vector<MatchedPad>& pads);

 private:
  struct Vertex {
    GridEdge edge;
    bool smoothed = false;
    bool measured = false;
    int next = -1;
    int previous = -1;
    Vec2 raw;
    Vec2 smooth;
    float edge_after = 0;   // length of the smoothed curve to the next vertex
    float turning_rad = 0;  // of the smoothed curve here, absolute
  };
  struct Held {
    TargetSample sample;
    ArclengthPyramid matched;  // as it was when last reported as renewed
    std::vector<TileIndex::Tile> support;  // of the nodes that it depends on
  };
  class Walk;

  int vertex_at(const GridEdge& edge);
  void remove_vertex(int v);
  void cut_window(const Window& window);
  void trace_cell(const Grid<float>& contour, Vec2 origin, int x, int y);
  void link(const Grid<float>& contour, Vec2 origin, const GridEdge& from, const GridEdge& to);
  void forget_smoothing(const Window& window);
  std::vector<std::uint32_t> reached_by(const Window& window) const;
  Vec2 smooth_position(int v);
  Vec2 smoothed_at(int v) const;
  void measure(int v);
  bool on_raster(const GridEdge& e) const { return (e.down ? e.x : e.y) % spacing_px_ == 0; }
  void visit(int v, TileIndex::Region& support) const;
  bool on_short_loop(int v, TileIndex::Region& support) const;
  Held make_sample(int v, TileIndex::Region support);
  void hold(std::uint32_t edge, Held held);
  void drop(std::uint32_t edge);
  void reject(std::uint32_t edge, std::vector<TileIndex::Tile> support);

  int width_ = 0;  // of the node grid
  float sigma_px_;
  float shortest_loop_px_;
  int spacing_px_;
  PadParameters pad_;
  std::vector<Vertex> vertices_;
  std::vector<int> unused_;
  EdgeTable vertex_of_edge_;
  std::map<std::uint32_t, Held> samples_;
  std::map<std::uint32_t, std::vector<TileIndex::Tile>> rejected_;  // where a loop is too short for a sample
  TileIndex supports_;  // the edges of samples and of the rejected, by the nodes that they depend on
};

}  // namespace tessera
