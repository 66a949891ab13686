#include "recognition/match_picture.h"

#include <algorithm>
#include <array>
#include <span>

#include "core/geometry/polygon.h"
#include "text/number_text.h"
#include "text/xml_writer.h"

namespace tessera {
namespace {

constexpr float kPanel_px = 320;
constexpr float kMargin_px = 16;
constexpr float kCaption_px = 24;
constexpr const char* kColourOfA = "#b0b0b0";
constexpr const char* kColourOfB = "#404040";
/// Colours that people who cannot tell red from green can tell apart (Okabe and Ito 2008).
constexpr std::array<const char*, 6> kRunColours = {"#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

const char* colour_of_run(std::size_t k) { return kRunColours[k % kRunColours.size()]; }

Box box_of(const std::vector<Curve>& curves, const Similarity& pose) {
  std::vector<Vec2> points;
  for (const Curve& curve : curves) {
    for (const Vec2 p : curve.points) points.push_back(pose.apply(p));
  }
  return bounding_box(points);
}

/// The transform that fits the box into a panel.
Similarity panel_from(const Box& box, float left_px, float top_px) {
  const float side = std::max({box.width(), box.height(), 1e-6f});
  const float scale = (kPanel_px - 2 * kMargin_px) / side;
  const Vec2 middle = (box.low + box.high) * 0.5f;
  return {scale, 0, left_px + kPanel_px / 2 - scale * middle.x, top_px + kPanel_px / 2 - scale * middle.y};
}

/// Applies `inner`, then `outer`.
Similarity combined(const Similarity& outer, const Similarity& inner) {
  const Vec2 t = outer.apply(inner.translation());
  const Vec2 d = outer.apply_direction({inner.a, inner.b});
  return {d.x, d.y, t.x, t.y};
}

class MatchPicture {
 public:
  MatchPicture(const std::vector<Curve>& a, const std::vector<Curve>& b, const std::vector<CurveMatch>& matches)
      : a_(a),
        b_(b) {
    const float width = 3 * kPanel_px, height = float(matches.size()) * row_px();
    xml_.start("svg").attribute("xmlns", "http://www.w3.org/2000/svg");
    xml_.attribute("width", fixed(width, 0)).attribute("height", fixed(height, 0));
    xml_.start("rect").attribute("width", fixed(width, 0)).attribute("height", fixed(height, 0));
    xml_.attribute("fill", "white").end();
    for (std::size_t k = 0; k < matches.size(); ++k) add_row(matches[k], float(k) * row_px());
  }

  std::string finish() && { return xml_.finish(); }

 private:
  static float row_px() { return kPanel_px + kCaption_px; }

  void add_row(const CurveMatch& match, float top_px) {
    const Similarity as_it_is;
    const Box box_a = box_of(a_, as_it_is);
    const Similarity first = panel_from(box_a, 0, top_px);
    const Similarity second = panel_from(box_of(b_, as_it_is), kPanel_px, top_px);
    const Similarity third = panel_from(united(box_a, box_of(b_, match.a_from_b)), 2 * kPanel_px, top_px);
    const Similarity third_from_b = combined(third, match.a_from_b);
    add_curves(a_, first, kColourOfA);
    add_curves(b_, second, kColourOfB);
    add_curves(a_, third, kColourOfA);
    add_curves(b_, third_from_b, kColourOfB);
    for (std::size_t k = 0; k < match.runs.size(); ++k) {
      const MatchedRun& run = match.runs[k];
      const std::vector<Vec2> of_a = points_of(a_[run.of_a.curve], run.of_a);
      const std::vector<Vec2> of_b = points_of(b_[run.of_b.curve], run.of_b);
      add_line(of_a, first, false, colour_of_run(k), 3);
      add_line(of_b, second, false, colour_of_run(k), 3);
      add_line(of_a, third, false, colour_of_run(k), 3);
    }
    add_caption("A: " + fixed(100 * match.part_of_a, 0) + " % matched", 0, top_px);
    add_caption("B: " + fixed(100 * match.part_of_b, 0) + " % matched", kPanel_px, top_px);
    add_caption("B on A: score " + fixed(match.score, 2) + ", similarity " + fixed(match.similarity, 2), 2 * kPanel_px,
                top_px);
  }

  void add_curves(const std::vector<Curve>& curves, const Similarity& pose, const char* colour) {
    for (const Curve& curve : curves) add_line(curve.points, pose, curve.closed, colour, 1);
  }

  void add_line(std::span<const Vec2> points, const Similarity& pose, bool closed, const char* colour, int width_px) {
    std::string data;
    for (const Vec2 p : points) {
      const Vec2 at = pose.apply(p);
      data += (data.empty() ? "M" : " ") + fixed(at.x, 1) + "," + fixed(at.y, 1);
    }
    xml_.start("path").attribute("d", closed ? data + "Z" : data).attribute("fill", "none");
    xml_.attribute("stroke", colour).attribute("stroke-width", fixed(width_px, 0)).end();
  }

  void add_caption(const std::string& text, float left_px, float top_px) {
    xml_.start("text").attribute("x", fixed(left_px + kMargin_px, 0)).attribute("y", fixed(top_px + kPanel_px + 8, 0));
    xml_.attribute("font-family", "sans-serif").attribute("font-size", "13").text(text).end();
  }

  const std::vector<Curve>& a_;
  const std::vector<Curve>& b_;
  XmlWriter xml_;
};

}  // namespace

std::string match_picture(const std::vector<Curve>& a, const std::vector<Curve>& b,
                          const std::vector<CurveMatch>& matches) {
  return MatchPicture(a, b, matches).finish();
}

}  // namespace tessera
