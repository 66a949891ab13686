// The zero line of a field as linked vertices, smoothed along its length. Only changed parts of the field are traced
// again.
//
// A vertex is identified by the grid edge that the line crosses; parts that a change did not touch keep their vertices.
// All values of a vertex follow from its own neighbourhood, so tracing a window gives the same bits as tracing
// everything.
#pragma once

#include <vector>

#include "core/field/edge_table.h"
#include "core/field/grid_edge.h"
#include "core/geometry/grid.h"
#include "core/geometry/periodic_grid.h"
#include "core/geometry/vec2.h"

namespace tessera {

class LinkedContour {
 public:
  static constexpr int kNone = EdgeTable::kNone;

  /// Smooths positions by a Gaussian of width `sigma_px` along the line, cut off at three times that width.
  explicit LinkedContour(float sigma_px) : sigma_px_(sigma_px) {}

  /// Positions and lengths are canvas px; positive nodes lie on the left of the line.
  struct Vertex {
    GridEdge edge;
    int next = -1;
    int previous = -1;
    Vec2 raw;  // on the line itself
    Vec2 smooth;
    float edge_after = 0;   // length of the smoothed line to the next vertex
    float turning_rad = 0;  // turning of the smoothed line here, absolute value
  };

  /// Traces the nodes of `windows` again; all others are unchanged. `origin` is the canvas position of node (0, 0).
  /// `grid` is the same in each call. If it repeats, the line continues from one end of the period to the other. Its
  /// vertices lie in the one period, and `field` must be valid at grid.with_next_nodes(). The nodes at the border of the
  /// grid that does not repeat lie outside the line. Uses the rank's threads.
  void retrace(const Grid<float>& field, const PeriodicGrid& grid, Vec2 origin, const std::vector<Window>& windows);

  const PeriodicGrid& grid() const { return grid_; }
  int width() const { return width_; }  // of the node grid; 0 before the first retrace
  int find(const GridEdge& edge) const { return vertex_of_edge_.find(edge); }  // kNone: the line does not cross it
  /// Calls visit(edge, vertex) for the crossed edges of the window.
  template <class Visit>
  void each(const Window& window, Visit visit) const {
    for (const Window& part : grid_.images(window, grid_.with_next_nodes())) vertex_of_edge_.each(part, visit);
  }
  const Vertex& vertex(int v) const { return vertices_[v]; }
  /// Distance between neighbours on the line itself, canvas px.
  float length_px(int from, int to) const;

 private:
  int vertex_at(const GridEdge& edge);
  void remove_vertex(int v);
  void cut_window(const Window& window);
  void trace_cell(const Grid<float>& contour, Vec2 origin, int x, int y);
  void link(const Grid<float>& contour, Vec2 origin, const GridEdge& from, const GridEdge& to);
  void smooth(const std::vector<Window>& windows);
  std::vector<int> vertices_in(const std::vector<Window>& windows) const;
  GridEdge in_one_period(const GridEdge& edge) const;
  Vec2 smoothed_at(int v) const;
  void measure(int v);

  float sigma_px_;
  PeriodicGrid grid_;
  int width_ = 0;
  std::vector<Vertex> vertices_;
  std::vector<int> unused_;
  EdgeTable vertex_of_edge_;
};

}  // namespace tessera
