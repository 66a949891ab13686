#include "bench/concepts/figure_sheet.h"

#include <array>

#include "text/number_text.h"

namespace tessera::bench::concepts {
namespace {

constexpr float kArrowHead_px = 7;
constexpr float kLeastStep_px = 0.7f;  // points of a curve that are nearer to the one before are left out

std::string px(double value) { return fixed(value, 1); }

std::string path_data(const std::vector<Vec2>& points, bool closed) {
  std::string data;
  Vec2 last;
  for (const Vec2& p : points) {
    const bool is_end = &p == &points.back() && !closed;
    if (!data.empty() && !is_end && norm(p - last) < kLeastStep_px) continue;
    data += (data.empty() ? "M" : " ") + px(double(p.x)) + "," + px(double(p.y));
    last = p;
  }
  return closed ? data + "Z" : data;
}

}  // namespace

FigureSheet::FigureSheet(double width_px, double height_px) {
  svg_.start("svg")
      .attribute("xmlns", "http://www.w3.org/2000/svg")
      .attribute("viewBox", "0 0 " + px(width_px) + " " + px(height_px));
  svg_.attribute("width", px(width_px)).attribute("height", px(height_px)).attribute("font-family", "sans-serif");
  svg_.start("rect")
      .attribute("width", "100%")
      .attribute("height", "100%")
      .attribute("rx", "8")
      .attribute("fill", "#ffffff")
      .end();
}

void FigureSheet::path(const std::string& data, const Pen& pen) {
  svg_.start("path").attribute("d", data).attribute("fill", pen.fill).attribute("fill-rule", "evenodd");
  if (pen.stroke != "none") {
    svg_.attribute("stroke", pen.stroke)
        .attribute("stroke-width", px(pen.width_px))
        .attribute("stroke-linejoin", "round");
  }
  if (pen.opacity < 1) svg_.attribute("opacity", fixed(pen.opacity, 2));
  if (pen.dashed) svg_.attribute("stroke-dasharray", "5 4");
  svg_.end();
}

void FigureSheet::closed(const std::vector<Vec2>& points, const Pen& pen) { path(path_data(points, true), pen); }

void FigureSheet::open(const std::vector<Vec2>& points, const Pen& pen) { path(path_data(points, false), pen); }

void FigureSheet::outline(const Outline& outline, const Similarity& sheet_from_shape, const Pen& pen) {
  std::string data;
  for (const std::vector<Vec2>& curve : outline.curves) data += path_data(applied(sheet_from_shape, curve), true);
  path(data, pen);
}

void FigureSheet::dot(Vec2 centre, double radius_px, const std::string& fill) {
  svg_.start("circle").attribute("cx", px(double(centre.x))).attribute("cy", px(double(centre.y)));
  svg_.attribute("r", px(radius_px)).attribute("fill", fill).end();
}

void FigureSheet::box(const Box& box, const Pen& pen) {
  closed({box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, pen);
}

void FigureSheet::arrow(Vec2 from, Vec2 to, const Pen& pen) {
  open({from, to}, pen);
  const Vec2 along = (to - from) * (kArrowHead_px / norm(to - from));
  const Vec2 across = Vec2{-along.y, along.x} * 0.5f;
  Pen head;
  head.fill = pen.stroke;
  head.opacity = pen.opacity;
  closed({to, to - along + across, to - along - across}, head);
}

void FigureSheet::text(Vec2 at, const std::string& words, double size_px, Anchor anchor, const std::string& fill) {
  constexpr std::array<const char*, 3> kAnchors = {"start", "middle", "end"};
  svg_.start("text").attribute("x", px(double(at.x))).attribute("y", px(double(at.y))).attribute("fill", fill);
  svg_.attribute("text-anchor", kAnchors[std::size_t(anchor)]).attribute("font-size", px(size_px)).text(words).end();
}

void FigureSheet::begin_clip(const Box& box) {
  const std::string name = "clip" + std::to_string(++clips_);
  svg_.start("clipPath").attribute("id", name).start("rect").attribute("x", px(double(box.low.x)));
  svg_.attribute("y", px(double(box.low.y))).attribute("width", px(double(box.width())));
  svg_.attribute("height", px(double(box.height()))).end().end();
  svg_.start("g").attribute("clip-path", "url(#" + name + ")");
}

std::string FigureSheet::finish() { return svg_.finish(); }

Similarity followed_by(const Similarity& a, const Similarity& b) {
  const Vec2 turned = a.apply_direction({b.a, b.b});
  const Vec2 moved = a.apply(b.translation());
  return {turned.x, turned.y, moved.x, moved.y};
}

Similarity scaled_and_moved(float factor, Vec2 by) { return {factor, 0, by.x, by.y}; }

std::vector<Vec2> applied(const Similarity& sheet_from_points, std::vector<Vec2> points) {
  for (Vec2& p : points) p = sheet_from_points.apply(p);
  return points;
}

}  // namespace tessera::bench::concepts
