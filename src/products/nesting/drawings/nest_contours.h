// Closed contours of a drawing from any file, sorted into pieces: an outline with the contours inside it.
#pragma once

#include <string>
#include <vector>

#include "artwork/svg/path_steps.h"
#include "products/nesting/layout/nest_polygon.h"
#include "products/nesting/layout/ring_rows.h"

namespace tessera {

/// One thing that is cut out: its outline, and the holes that belong to it, mm.
struct NestDrawing {
  std::string name;
  NestRing outline;
  std::vector<NestRing> holes = {};
  /// The curves of the outline and then of the holes. A contour whose curve is empty or missing is a polygon.
  std::vector<PathSteps> curves = {};

  /// The curve of contour 0, the outline, or of a hole; empty: the contour is a polygon.
  const PathSteps& curve(std::size_t contour) const;
};

/// The number of points of outline and holes together.
std::size_t points_of(const NestDrawing& drawing);

/// Limits: points of one contour, points of a file, and pieces of a file.
inline constexpr std::size_t kMostContourPoints = 5'000;
inline constexpr std::size_t kMostDrawingPoints = 200'000;
inline constexpr std::size_t kMostDrawings = 2'000;

/// The largest distance of a polygon from the curve that it stands for, mm.
inline constexpr double kFlatness_mm = 0.01;
/// Largest coordinate, mm.
inline constexpr double kFarthest_mm = 1e6;

/// Why the contour cannot be nested: "found a contour that crosses itself"; empty: it can. It needs at least three points,
/// finite coordinates that are not too large, an area, and sides that do not cross.
std::string contour_fault(const NestRing& contour);

/// Throws InputError that begins with `what` where the contour cannot be nested.
void check_contour(const NestRing& contour, const std::string& what);

/// Longest name of a shape.
inline constexpr std::size_t kMostNameBytes = 1'000;
/// Throws InputError that begins with `what` where a name is longer, because many pieces may have it.
void check_name(const std::string& name, const std::string& what);

/// A contour and its name.
struct NamedContour {
  std::string name;
  NestRing ring;
  std::string fault;     // why it cannot be nested, for people: "bow: found a contour that crosses itself"
  PathSteps curve = {};  // the curve that the ring stands for; empty: it is a polygon
};

/// Adds a note that `count` things were left out: "left out 2 invisible entities"; no note where it is 0. `one`, `several`:
/// what they are and why, in the singular and in the plural.
void note_left_out(int count, const char* one, const char* several, const std::string& names,
                   std::vector<std::string>& notes);

/// Lists unusable contours: "left out bow: found a contour that crosses itself"; empty: all are good. Throws InputError
/// that names `path` where none is good.
std::string faults_text(const std::vector<NamedContour>& contours, const std::string& path);

/// Makes the pieces, in the order of their outlines. An outline that lies in no other becomes a piece, with everything
/// inside it as holes that are cut, too. Unusable contours are left out, and outlines inside them. If several outlines have
/// the same name, they become NAME-1, NAME-2 and so on.
std::vector<NestDrawing> drawings_of(std::vector<NamedContour> contours);

/// Whether most of some points of the inner ring lie inside the outer one; sides may touch.
bool lies_in(const NestRing& inner, const RingRows& outer);

/// Adds points of the arc of a circle or ellipse, without the point at `first`, in steps that keep the flatness. The arc is
/// centre + u cos t + v sin t, t from `first` to `last`, rad.
void add_arc(NestPoint centre, NestPoint u, NestPoint v, double first, double last, NestRing& ring);

}  // namespace tessera
