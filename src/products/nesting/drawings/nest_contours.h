// Closed contours of a drawing, whatever file they come from, sorted into pieces: an outline with the contours inside it.
#pragma once

#include <string>
#include <vector>

#include "artwork/svg/path_steps.h"
#include "products/nesting/layout/nest_polygon.h"

namespace tessera {

/// One thing that is cut out: its outline, and the holes that travel along. mm.
struct NestDrawing {
  std::string name;
  NestRing outline;
  std::vector<NestRing> holes = {};
  std::vector<PathSteps> curves =
      {};  // the curves that outline and holes stand for, in this order; empty: it is a polygon

  /// Of the outline, 0, or a hole; empty: it is a polygon.
  const PathSteps& curve(std::size_t contour) const;
};

/// Of the outline and the holes.
std::size_t points_of(const NestDrawing& drawing);

/// Most points of one contour, and of all of a file; most pieces of a file.
inline constexpr std::size_t kMostContourPoints = 5'000;
inline constexpr std::size_t kMostDrawingPoints = 200'000;
inline constexpr std::size_t kMostDrawings = 2'000;

/// How far a polygon may be from the curve that it stands for, mm.
inline constexpr double kFlatness_mm = 0.01;
/// Largest coordinate, mm.
inline constexpr double kFarthest_mm = 1e6;

/// Why the contour is of no use, "found a contour that crosses itself"; empty: it can be nested. It needs three points or
/// more, coordinates that are numbers and not too large, an area, and sides that do not cross.
std::string contour_fault(const NestRing& contour);

/// Throws InputError, naming `what`, where the contour is of no use.
void check_contour(const NestRing& contour, const std::string& what);

/// Longest name of a shape.
inline constexpr std::size_t kMostNameBytes = 1'000;
/// Throws InputError, naming `what`, where a name is longer: many pieces may have it.
void check_name(const std::string& name, const std::string& what);

/// A contour and what it is called.
struct NamedContour {
  std::string name;
  NestRing ring;
  std::string fault;     // for people, where the contour is of no use: "bow: found a contour that crosses itself"
  PathSteps curve = {};  // that the ring stands for; empty: it is a polygon
};

/// What is to be told of contours that are of no use, "left out bow: found a contour that crosses itself"; empty: all are
/// good. Throws InputError, naming `path`, where none is good.
std::string faults_text(const std::vector<NamedContour>& contours, const std::string& path);

/// Contours that are of no use are left out, and outlines with them that lie in such a contour. Outlines that lie in no other, each with all that lies in it as holes; what lies in those is cut, too, and travels
/// along. In the order of the outlines. Of several outlines of one name the names are NAME-1, NAME-2 and so on.
std::vector<NestDrawing> drawings_of(std::vector<NamedContour> contours);

/// Points of the arc of a circle or ellipse that starts at `from` (not among them), by steps that keep the flatness.
/// The arc is centre + u cos t + v sin t, t from `first` to `last`, rad.
void add_arc(NestPoint centre, NestPoint u, NestPoint v, double first, double last, NestRing& ring);

}  // namespace tessera
