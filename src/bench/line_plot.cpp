#include "bench/line_plot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "artwork/artwork_render.h"
#include "artwork/images/png_encoder.h"
#include "bench/report.h"
#include "files/atomic_file.h"
#include "text/number_text.h"
#include "text/xml_writer.h"

namespace tessera::bench {
namespace {

constexpr double kPanelWidth = 610;
constexpr double kHeight = 380;
constexpr double kLeft = 60, kRight = 170, kTop = 40, kBottom = 50;  // margins around the axes; right: the legend
constexpr int kPngWidth_px = 1840;
constexpr double kLegendLine = 16;
constexpr double kLinearStep = 10;     // of an x axis that is not logarithmic
constexpr double kMostDoublings = 10;  // of a logarithmic axis, before its steps become powers of four
constexpr const char* kGrey = "#999999";
constexpr const char* kInk = "#222222";
constexpr std::array<const char*, 6> kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"};

std::string number(double value) { return fixed(value, 2); }

class PanelDrawing {
 public:
  PanelDrawing(XmlWriter& svg, const Panel& panel, double left) : svg_(svg), panel_(panel), left_(left + kLeft) {
    for (const PlotCurve& curve : panel.curves) {
      for (const auto& [x, y] : curve.points) greatest_x_ = std::max(greatest_x_, x);
    }
  }

  void draw() {
    text(left_ + width() / 2, kTop - 16, panel_.title, "middle", 15);
    x_axis();
    y_axis();
    int colour = 0;
    const double legend_x = left_ + width() + 16;
    double legend_y = kTop + kLegendLine;
    for (const PlotCurve& curve : panel_.curves) {
      const char* stroke = curve.ideal ? kGrey : kColours[std::size_t(colour++) % kColours.size()];
      draw_curve(curve, stroke);
      line(legend_x, legend_y - 4, legend_x + 24, legend_y - 4, stroke, curve.ideal);
      text(legend_x + 30, legend_y, curve.name, "start", 12);
      legend_y += kLegendLine;
    }
  }

 private:
  static double width() { return kPanelWidth - kLeft - kRight; }
  static double height() { return kHeight - kTop - kBottom; }

  double x_at(double x) const {
    return left_ + width() * (panel_.log_x ? std::log2(x) / std::log2(greatest_x_) : x / greatest_x_);
  }
  double y_at(double y) const {
    const double part =
        panel_.log_y ? std::log2(std::max(y, 1.)) / std::log2(panel_.greatest_y) : y / panel_.greatest_y;
    return kTop + height() * (1 - std::clamp(part, 0., 1.));
  }

  void line(double x1, double y1, double x2, double y2, const char* stroke, bool dashed) {
    svg_.start("line").attribute("x1", number(x1)).attribute("y1", number(y1));
    svg_.attribute("x2", number(x2)).attribute("y2", number(y2)).attribute("stroke", stroke);
    if (dashed) svg_.attribute("stroke-dasharray", "6 4");
    svg_.end();
  }

  void text(double x, double y, const std::string& words, const char* anchor, int size_px) {
    svg_.start("text").attribute("x", number(x)).attribute("y", number(y)).attribute("fill", kInk);
    svg_.attribute("text-anchor", anchor).attribute("font-size", std::to_string(size_px)).text(words).end();
  }

  void x_axis() {
    const double bottom = kTop + height();
    line(left_, bottom, left_ + width(), bottom, kInk, false);
    const double log_step = std::log2(greatest_x_) > kMostDoublings ? 4 : 2;
    for (double x = panel_.log_x ? 1 : 0; x <= greatest_x_; x = panel_.log_x ? log_step * x : x + kLinearStep) {
      line(x_at(x), bottom, x_at(x), bottom + 5, kInk, false);
      text(x_at(x), bottom + 20, fixed(x, 0), "middle", 12);
    }
    text(left_ + width() / 2, bottom + 40, panel_.x_label, "middle", 13);
  }

  void y_tick(double y, const std::string& label) {
    line(left_ - 5, y_at(y), left_, y_at(y), kInk, false);
    text(left_ - 9, y_at(y) + 4, label, "end", 12);
  }

  void y_axis() {
    line(left_, kTop, left_, kTop + height(), kInk, false);
    if (panel_.log_y) {
      for (double y = 1; y <= panel_.greatest_y; y *= 2) y_tick(y, fixed(y, 0));
    } else {
      for (int step = 0; step <= 5; ++step)
        y_tick(panel_.greatest_y * step / 5, short_number(panel_.greatest_y * step / 5));
    }
    text(left_ - kLeft + 10, kTop - 16, panel_.y_label, "start", 13);
  }

  void draw_curve(const PlotCurve& curve, const char* stroke) {
    std::string path;
    for (const auto& [x, y] : curve.points) path += (path.empty() ? "" : " ") + number(x_at(x)) + "," + number(y_at(y));
    svg_.start("polyline").attribute("points", path).attribute("fill", "none").attribute("stroke", stroke);
    svg_.attribute("stroke-width", "2");
    if (curve.ideal) svg_.attribute("stroke-dasharray", "6 4");
    svg_.end();
    for (const auto& [x, y] : curve.points) {
      if (curve.ideal) continue;
      svg_.start("circle").attribute("cx", number(x_at(x))).attribute("cy", number(y_at(y))).attribute("r", "3.5");
      svg_.attribute("fill", stroke).end();
    }
  }

  XmlWriter& svg_;
  const Panel& panel_;
  double left_;
  double greatest_x_ = 2;
};

}  // namespace

std::string plot_svg(const std::vector<Panel>& panels) {
  const std::string width = number(kPanelWidth * double(panels.size()));
  const std::string height = number(kHeight);
  XmlWriter svg;
  svg.start("svg").attribute("xmlns", "http://www.w3.org/2000/svg");
  svg.attribute("width", width).attribute("height", height).attribute("font-family", "sans-serif");
  svg.start("rect").attribute("width", width).attribute("height", height).attribute("fill", "#ffffff").end();
  for (std::size_t i = 0; i < panels.size(); ++i) PanelDrawing(svg, panels[i], kPanelWidth * double(i)).draw();
  return svg.finish();
}

void check_plot_can_be_written(const std::string& path) {
  for (const char* ending : {".svg", ".png"}) check_can_be_written(path + ending);
}

void write_plot(const std::vector<Panel>& panels, const std::string& path) {
  const std::string svg = plot_svg(panels);
  write_file_atomically(path + ".svg", svg);
  const std::vector<std::uint8_t> bytes(svg.begin(), svg.end());
  write_file_atomically(path + ".png", png_of(render_artwork(bytes, path + ".svg", kPngWidth_px)));
}

}  // namespace tessera::bench
