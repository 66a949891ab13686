// Closed contours of a drawing, whatever file they come from, sorted into pieces: an outline with the contours inside it.
#pragma once

#include <string>
#include <vector>

#include "artwork/svg/path_steps.h"
#include "products/nesting/layout/nest_polygon.h"
#include "products/nesting/layout/ring_rows.h"

namespace tessera {

/// One thing that is cut out: its outline, and the holes that travel along. mm.
struct NestDrawing {
  std::string name;
  NestRing outline;
  std::vector<NestRing> holes = {};
  /// The curves that the outline and then the holes stand for. A contour whose curve is empty or missing is a polygon.
  std::vector<PathSteps> curves = {};

  /// The curve of contour 0, the outline, or of a hole; empty: the contour is a polygon.
  const PathSteps& curve(std::size_t contour) const;
};

/// How many points outline and holes have together.
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

/// Tells that `count` things were left out, none where it is 0: "left out 2 invisible entities". `one`, `several`: what they
/// are and why, in the singular and in the plural.
void note_left_out(int count, const char* one, const char* several, const std::string& names,
                   std::vector<std::string>& notes);

/// What is to be told of contours that are of no use, "left out bow: found a contour that crosses itself"; empty: all are
/// good. Throws InputError, naming `path`, where none is good.
std::string faults_text(const std::vector<NamedContour>& contours, const std::string& path);

/// Contours that are of no use are left out, and outlines with them that lie in such a contour. Outlines that lie in no other, each with all that lies in it as holes; what lies in those is cut, too, and travels
/// along. In the order of the outlines. Of several outlines of one name the names are NAME-1, NAME-2 and so on.
std::vector<NestDrawing> drawings_of(std::vector<NamedContour> contours);

/// Whether most of some points of the inner ring are inside the outer one: sides may touch.
bool lies_in(const NestRing& inner, const RingRows& outer);

/// Points of the arc of a circle or ellipse that starts at `from` (not among them), by steps that keep the flatness.
/// The arc is centre + u cos t + v sin t, t from `first` to `last`, rad.
void add_arc(NestPoint centre, NestPoint u, NestPoint v, double first, double last, NestRing& ring);

}  // namespace tessera
