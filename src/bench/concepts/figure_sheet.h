// A sheet of a figure as SVG: curves, dots, bars and words on white paper, so that dark pages show it, too.
#pragma once

#include <string>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/geometry/similarity.h"
#include "text/xml_writer.h"

namespace tessera::bench::concepts {

inline constexpr const char* kInk = "#222222";
inline constexpr const char* kPaleInk = "#8a8a8a";
inline constexpr const char* kPiece = "#dedbd5";  // pieces that stand
inline constexpr const char* kBlue = "#0072b2";
inline constexpr const char* kOrange = "#d55e00";
inline constexpr const char* kGreen = "#009e73";

/// The style of a drawn curve. Colours are those of SVG.
struct Pen {
  std::string stroke = "none";
  double width_px = 1;
  std::string fill = "none";
  double opacity = 1;
  bool dashed = false;
};

enum class Anchor { start, middle, end };

/// Sheet frame: px, y down, origin at the upper left corner.
class FigureSheet {
 public:
  FigureSheet(double width_px, double height_px);

  void closed(const std::vector<Vec2>& points, const Pen& pen);
  void open(const std::vector<Vec2>& points, const Pen& pen);
  void outline(const Outline& outline, const Similarity& sheet_from_shape, const Pen& pen);
  void dot(Vec2 centre, double radius_px, const std::string& fill);
  void box(const Box& box, const Pen& pen);
  /// A straight line with a head at `to`.
  void arrow(Vec2 from, Vec2 to, const Pen& pen);
  void text(Vec2 at, const std::string& words, double size_px = 14, Anchor anchor = Anchor::start,
            const std::string& fill = kInk);

  /// All that is drawn until end_clip() shows within the box alone.
  void begin_clip(const Box& box);
  void end_clip() { svg_.end(); }

  /// The SVG; nothing can be added any more.
  std::string finish();

 private:
  void path(const std::string& data, const Pen& pen);

  XmlWriter svg_;
  int clips_ = 0;
};

/// `b` followed by `a`: target_from_middle and middle_from_source.
Similarity followed_by(const Similarity& a, const Similarity& b);

/// Moves by `by`, after scaling by `factor`.
Similarity scaled_and_moved(float factor, Vec2 by);

std::vector<Vec2> applied(const Similarity& sheet_from_points, std::vector<Vec2> points);

}  // namespace tessera::bench::concepts
